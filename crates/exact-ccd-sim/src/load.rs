//! External loads.

use exact_ccd_mesh::{Point, TriangleMesh};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::gather::gather;

/// A force on some vertices, from one time to another.
///
/// Forces are those at the start of a time step, so that a pressure follows the surface with a delay of one
/// time step. Their work is in no energy of [`Energies`](crate::Energies).
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// The vertices. Tractions and pressures act on the faces of which they are all corners.
    pub vertices: Vec<u32>,
    /// The force.
    pub force: Force,
    /// The time at which it begins, in s.
    pub from: f64,
    /// The time at which it ends, in s. `None`: it does not end.
    pub until: Option<f64>,
}

/// A force by mass or by area.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Force {
    /// A force by mass, in m/s², in addition to gravity.
    Acceleration(Point),
    /// A force by area at the start, in Pa, in a direction that does not change.
    Traction(Point),
    /// A force by current area, in Pa, against the normal of the faces: into a solid if it is positive. The
    /// normal of a shell's face points at the viewer for whom its corners are counterclockwise.
    Pressure(f64),
}

/// A load with a number that is out of range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("load {load}: `{field}` is out of range, expected {expected}")]
pub struct LoadError {
    /// The number of the load, from 0.
    pub load: usize,
    /// The field.
    pub field: &'static str,
    /// The values that are allowed.
    pub expected: &'static str,
}

impl Load {
    /// Checks that all numbers of the load with this number are in range, for a system with this number of
    /// vertices.
    ///
    /// # Errors
    /// [`LoadError`] names the first number that is out of range.
    pub fn check(&self, load: usize, vertex_count: usize) -> Result<(), LoadError> {
        let is_finite = match self.force {
            Force::Acceleration(force) | Force::Traction(force) => force.iter().all(|x| x.is_finite()),
            Force::Pressure(pressure) => pressure.is_finite(),
        };
        let is_known = |&vertex: &u32| (vertex as usize) < vertex_count;
        let checks = [
            ("force", is_finite, "finite numbers"),
            ("from", self.from.is_finite(), "a finite number"),
            (
                "until",
                self.until.is_none_or(|until| until >= self.from),
                "a number not below `from`",
            ),
            (
                "vertices",
                self.vertices.iter().all(is_known),
                "vertices of the system",
            ),
        ];
        match checks.into_iter().find(|(_, is_good, _)| !is_good) {
            None => Ok(()),
            Some((field, _, expected)) => Err(LoadError {
                load,
                field,
                expected,
            }),
        }
    }

    /// Adds the forces on the vertices in a time step that ends at `time`, in N. `rest` and `points` are the
    /// positions at the start of the simulation and of the time step.
    pub(crate) fn add(
        &self,
        forces: &mut [Vector3<f64>],
        mesh: &TriangleMesh,
        masses: &[f64],
        [rest, points]: [&[Point]; 2],
        time: f64,
    ) {
        if time <= self.from || self.until.is_some_and(|until| time > until) {
            return;
        }
        if let Force::Acceleration(acceleration) = self.force {
            for &vertex in &self.vertices {
                let vertex = vertex as usize;
                forces[vertex] += Vector3::from(acceleration) * masses[vertex];
            }
            return;
        }
        let mut is_loaded = vec![false; points.len()];
        self.vertices
            .iter()
            .for_each(|&vertex| is_loaded[vertex as usize] = true);
        for face in mesh.faces() {
            if face.iter().any(|&corner| !is_loaded[corner as usize]) {
                continue;
            }
            // The vector of the area, along the normal.
            let area = |points: &[Point]| {
                let [a, b, c] = gather(points, face);
                (b - a).cross(&(c - a)) * 0.5
            };
            let force = match self.force {
                Force::Acceleration(_) => Vector3::zeros(),
                Force::Traction(traction) => Vector3::from(traction) * area(rest).norm(),
                Force::Pressure(pressure) => area(points) * -pressure,
            };
            face.iter()
                .for_each(|&corner| forces[corner as usize] += force / 3.0);
        }
    }
}
