//! The boundaries of half spaces in floating point, for the barrier and for friction, which act on vertices.

pub use exact_ccd_mesh::HalfSpace;
use exact_ccd_mesh::Point;
use nalgebra::Vector3;

/// A plane in floating point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Plane {
    /// A point of the plane, in m.
    point: Vector3<f64>,
    /// Its unit normal.
    pub(crate) normal: Vector3<f64>,
}

impl Plane {
    /// The boundary of a half space.
    pub(crate) fn of(half_space: &HalfSpace) -> Self {
        Self {
            point: half_space.point.into(),
            normal: half_space.unit_normal().into(),
        }
    }

    /// The signed distance of a point, in m.
    pub(crate) fn height(&self, x: &Vector3<f64>) -> f64 {
        self.normal.dot(&(x - self.point))
    }

    /// The part of a linear motion in which a vertex stays apart, from 0 to 1. It is not certified:
    /// [`HalfSpace::is_apart`] decides the step that is taken.
    pub(crate) fn free_part(&self, [from, to]: [Point; 2], offset: f64) -> f64 {
        let [before, after] = [from, to].map(|x| self.height(&x.into()) - offset);
        if after < before {
            (before / (before - after)).clamp(0.0, 1.0)
        } else {
            1.0
        }
    }
}
