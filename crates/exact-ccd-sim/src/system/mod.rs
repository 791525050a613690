//! The bodies of a scene, as one list of vertices and lists of elements over it.

mod affine;
pub(crate) mod ball;
mod bodies;
mod body_error;
mod coils;
mod designation;
mod elastic;
mod error;
mod fingerprint;
mod geometry;
mod masses;
mod materials;
mod names;
mod obstacles;
mod parts;
mod primitive;
mod selection;
mod shells;
mod size;
mod spring_error;
mod with_half_spaces;
mod with_loads;
mod with_springs;

use std::ops::Range;

use exact_ccd_mesh::{Frame, MinDistance, Point, PositionsError, TriangleMesh};

use crate::body::Body;
use crate::carriers::Carriers;
use crate::energies::contact::{Barrier, CollisionSet, Surface};
use crate::energies::load::Load;
use crate::prescribed::{Coordinates, ScriptedVertices};
use crate::settings::Formulation;
use bodies::Bodies;
use elastic::Elastic;
use geometry::Geometry;
use parts::Parts;

pub use body_error::{BodyError, Selecting};
pub use designation::Designation;
pub use error::SystemError;
pub use fingerprint::Fingerprint;
pub use primitive::{BodyPrimitive, Primitive};
pub use spring_error::SpringError;

/// The vertices, masses, elements and scripts of a scene.
#[derive(Clone, Debug)]
pub struct System {
    pub(crate) start: Vec<Point>,
    pub(crate) velocities: Vec<Point>,
    pub(crate) masses: Vec<f64>,
    /// The map from unknowns to vertices.
    pub(crate) carriers: Carriers,
    /// The scripts of each vertex.
    pub(crate) scripts: Vec<Coordinates>,
    pub(crate) bodies: Bodies,
    pub(crate) elastic: Elastic,
    pub(crate) geometry: Geometry,
    loads: Vec<Load>,
    size: f64,
    extent: f64,
}

impl System {
    /// The system of some bodies. It has the vertices of the bodies, in their order. `scripts` prescribe
    /// the motion of vertices; along each axis, the script of a vertex that began last applies, and the last
    /// of the scripts that begin at the same time. Obstacles without a script are fixed.
    ///
    /// # Errors
    /// [`SystemError`] names the body or the script, unless it is about the mesh of all bodies.
    pub fn new(bodies: &[Body], scripts: &[ScriptedVertices]) -> Result<Self, SystemError> {
        let listed = Bodies::new(bodies);
        let mut parts = Parts::default();
        for (place, body) in bodies.iter().enumerate() {
            parts.add(body).map_err(|source| SystemError::Body {
                body: listed.designation(place),
                source,
            })?;
        }
        for (number, scripted) in scripts.iter().enumerate() {
            parts.script(number, scripted, &listed)?;
        }
        let is_obstacle = parts.outline.is_obstacle.clone();
        let system = Self {
            geometry: Geometry::new(parts.outline, &listed.ranges, &parts.start, &parts.scripts)?,
            bodies: listed,
            start: parts.start,
            velocities: parts.velocities,
            masses: parts.masses,
            carriers: parts.carriers,
            scripts: parts.scripts,
            elastic: parts.elastic,
            loads: Vec::new(),
            size: 1.0,
            extent: 1.0,
        };
        Ok(system.measured(&is_obstacle))
    }

    /// The distance within which two primitives touch: the sum of their offsets.
    #[must_use]
    pub fn min_distance(&self) -> &MinDistance {
        &self.geometry.min_distance
    }

    /// Returns true if a body has an offset.
    pub(crate) fn is_thick(&self) -> bool {
        self.geometry.offsets.iter().any(|&offset| offset > 0.0)
    }

    /// The surface on which contact acts.
    pub(crate) fn contact_surface(&self, formulation: Formulation) -> Surface<'_> {
        self.geometry.surface(&self.start, formulation)
    }

    /// The least distance between two surfaces at these positions, if it is within the activation distance
    /// of a barrier, in m, and their bodies in their order.
    pub(crate) fn nearest(
        &self,
        formulation: Formulation,
        points: &[Point],
        barrier: Barrier,
    ) -> Option<(f64, [Designation; 2])> {
        let candidates = self.geometry.near_at(points, &barrier);
        let surface = self.contact_surface(formulation);
        let (gap, collision) = CollisionSet::nearest(surface, &candidates, points, barrier)?;
        let [a, b] = self.bodies_of(&collision);
        let bodies = [a.min(b), a.max(b)].map(|body| self.designation(body));
        Some((gap, bodies))
    }

    /// The faces and rods of all bodies. Its loose vertices are particles, and vertices in the interior of
    /// solids.
    #[must_use]
    pub fn surface(&self) -> &TriangleMesh {
        &self.geometry.mesh
    }

    /// The vertices of the meshes of all bodies, increasing: all but the nodes of affine bodies, which are
    /// unknowns and no part of a mesh.
    #[must_use]
    pub fn mesh_vertices(&self) -> Vec<u32> {
        let mut is_node = vec![false; self.start.len()];
        for node in self
            .carriers
            .bodies()
            .iter()
            .flat_map(|body| self.carriers.nodes(body))
        {
            is_node[node as usize] = true;
        }
        (0..self.start.len() as u32)
            .filter(|&vertex| !is_node[vertex as usize])
            .collect()
    }

    /// The vertices that are particles, increasing.
    #[must_use]
    pub fn particles(&self) -> &[u32] {
        &self.geometry.particles
    }

    /// The corners of all tetrahedra, ordered so that the volume at the start is positive.
    #[must_use]
    pub fn tetrahedra(&self) -> &[[u32; 4]] {
        &self.elastic.tetrahedra
    }

    /// The surface, for these positions of all vertices of the system: faces, rods and particles. It has no
    /// vertices in the interior of solids.
    ///
    /// # Errors
    /// [`PositionsError`], if a coordinate is not finite or there are too few positions.
    pub fn surface_frame(&self, positions: &[Point]) -> Result<Frame, PositionsError> {
        let at = |&vertex: &u32| positions.get(vertex as usize).copied();
        let frame = Frame {
            positions: self.geometry.vertices.iter().filter_map(at).collect(),
            mesh: self.geometry.compact.clone(),
        };
        frame.check()?;
        Ok(frame)
    }

    /// The vertices of [`System::surface_frame`] of each body, with its name, or with `body-N` for the Nth
    /// body if it has none. They cover all vertices.
    #[must_use]
    pub fn surface_bodies(&self) -> Vec<(String, Range<u32>)> {
        let kept = &self.geometry.vertices;
        let place = |vertex: u32| kept.partition_point(|&kept| kept < vertex) as u32;
        let ranges = self.bodies.ranges.iter();
        let ranges = ranges.map(|body| place(body.start)..place(body.end));
        self.body_names().into_iter().zip(ranges).collect()
    }

    /// The vertices of the system that are in [`System::surface_frame`], in its order.
    #[must_use]
    pub fn surface_vertices(&self) -> &[u32] {
        &self.geometry.vertices
    }

    /// The offsets of the contact surface at the vertices of [`System::surface_frame`], in m.
    #[must_use]
    pub fn surface_offsets(&self) -> Vec<f64> {
        let vertices = self.geometry.vertices.iter();
        vertices
            .map(|&vertex| self.geometry.offsets[vertex as usize])
            .collect()
    }

    /// The initial positions, in m. They are also the rest shape.
    #[must_use]
    pub fn start(&self) -> &[Point] {
        &self.start
    }

    /// The mass of each vertex, in kg. The vertices of obstacles have mass 0.
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }
}
