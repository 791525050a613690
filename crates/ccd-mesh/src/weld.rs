//! Shared vertices for meshes that have none.

use std::collections::HashMap;

use exact_ccd::Point;

use crate::frame::Frame;
use crate::mesh::TriangleMesh;
use crate::motion::{Motion, MotionError};

impl Motion {
    /// The motion from one frame to another, with one vertex in place of all that coincide both at t = 0 and at t = 1.
    ///
    /// Such vertices coincide at all times between, so the surface stays the same. But where separate bodies share such
    /// a point, they become neighbours there, and pairs of primitives that share a vertex are not looked at. Vertices
    /// that meet at one time only stay apart. The new vertices are numbered in the order in which they first appear, and
    /// the faces keep their order. Coordinates are compared as numbers: −0.0 equals 0.0.
    ///
    /// # Errors
    /// As [`Motion::new`].
    pub fn weld(start: Frame, end: Frame) -> Result<Self, MotionError> {
        let split = Self::new(start, end)?;
        let mut numbers = HashMap::with_capacity(split.x0.len());
        let mut vertex_of = Vec::with_capacity(split.x0.len());
        let (mut x0, mut x1) = (Vec::new(), Vec::new());
        for (&p0, &p1) in split.x0.iter().zip(&split.x1) {
            let vertex = *numbers.entry(key(p0, p1)).or_insert_with(|| {
                let next = x0.len() as u32;
                x0.push(p0);
                x1.push(p1);
                next
            });
            vertex_of.push(vertex);
        }
        let weld_face = |face: &[u32; 3]| face.map(|corner| vertex_of[corner as usize]);
        let faces = split.mesh.faces().iter().map(weld_face).collect();
        let mesh = TriangleMesh::new(x0.len(), faces).expect("every corner has its vertex");
        Ok(Self { mesh, x0, x1 })
    }
}

/// Equal for positions that are equal as numbers.
fn key(p0: Point, p1: Point) -> [[u64; 3]; 2] {
    // Adding 0.0 turns −0.0 into 0.0 and changes no other number.
    [p0, p1].map(|p| p.map(|x| (x + 0.0).to_bits()))
}
