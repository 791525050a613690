//! External loads.

use exact_ccd_mesh::{Point, TriangleMesh};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::term::gather;
use crate::digest::{Digest, Hash};
use crate::range::{OutOfRange, check, check_finite};

/// A force on some vertices, from one time to another.
///
/// A force is computed at the start of a time step, so that a pressure follows the surface with a delay of
/// one time step. Their work is in no energy of [`Energies`](crate::Energies).
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// The vertices. Tractions and pressures act on the faces whose corners are all among them.
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

impl Load {
    /// Checks that all numbers are in range.
    ///
    /// # Errors
    /// [`OutOfRange`] names the first number that is out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        match &self.force {
            Force::Acceleration(force) | Force::Traction(force) => check_finite("force", force)?,
            Force::Pressure(pressure) => check(pressure.is_finite(), "force", pressure, "a finite number")?,
        }
        check(self.from.is_finite(), "from", self.from, "a finite number")?;
        let until = self.until.unwrap_or(f64::INFINITY);
        check(until >= self.from, "until", until, "a number not below `from`")
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

impl Digest for Force {
    fn digest(&self, hash: &mut Hash) {
        match self {
            Self::Acceleration(force) => (0_u32, force).digest(hash),
            Self::Traction(force) => (1_u32, force).digest(hash),
            Self::Pressure(pressure) => (2_u32, pressure).digest(hash),
        }
    }
}

impl Digest for Load {
    fn digest(&self, hash: &mut Hash) {
        let Self {
            vertices,
            force,
            from,
            until,
        } = self;
        ((vertices, force), (from, until)).digest(hash);
    }
}
