//! The loads of a system.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::body_error::Selecting;
use super::selection;
use super::{System, SystemError};
use crate::energies::load::{Force, Load};
use crate::range::check;

impl System {
    /// The same system with these loads, in place of its own.
    ///
    /// # Errors
    /// [`SystemError::Load`] names the first one with a number that is out of range, or a vertex that the
    /// system does not have; [`BodyError::Partly`](super::BodyError::Partly) one that accelerates a part of
    /// an affine body.
    pub fn with_loads(self, mut loads: Vec<Load>) -> Result<Self, SystemError> {
        let count = self.start.len();
        for (number, load) in loads.iter().enumerate() {
            let unknown = load.vertices.iter().find(|&&vertex| vertex as usize >= count);
            let known = unknown.map_or(Ok(()), |vertex| {
                let found = format_args!("a list with {vertex}");
                check(false, "vertices", found, format_args!("indices below {count}"))
            });
            load.check()
                .and(known)
                .map_err(|source| SystemError::Load { load: number, source })?;
        }
        for (number, load) in loads.iter_mut().enumerate() {
            // Tractions and pressures act on faces.
            if let Force::Acceleration(_) = load.force {
                let what = Selecting::Load(number);
                load.vertices = selection::unknowns(&self.carriers, &self.bodies, &load.vertices, what)?;
            }
        }
        Ok(Self { loads, ..self })
    }

    /// The accelerations of the vertices by all loads, in a time step from these positions that ends at
    /// `time`, in m/s². Vertices without mass are not accelerated. `None` without loads.
    pub(crate) fn accelerations(&self, positions: &[Point], time: f64) -> Option<Vec<Vector3<f64>>> {
        if self.loads.is_empty() {
            return None;
        }
        let mut forces = vec![Vector3::zeros(); positions.len()];
        let points = [self.start.as_slice(), positions];
        for load in &self.loads {
            load.add(&mut forces, &self.geometry.mesh, &self.masses, points, time);
        }
        self.carriers.collect(&mut forces);
        let pairs = forces.into_iter().zip(&self.masses);
        let accelerations = pairs.map(|(force, &mass)| {
            if mass > 0.0 {
                force / mass
            } else {
                Vector3::zeros()
            }
        });
        Some(accelerations.collect())
    }
}
