//! The boundaries of half spaces in floating point, for the barrier and for friction, which act on vertices.

pub use exact_ccd_mesh::HalfSpace;
use exact_ccd_mesh::{Aabb, Point};
use nalgebra::Vector3;

/// A plane in floating point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of the plane, in m.
    pub point: Vector3<f64>,
    /// Its unit normal.
    pub normal: Vector3<f64>,
}

impl Plane {
    /// The boundary of a half space.
    #[must_use]
    pub fn of(half_space: &HalfSpace) -> Self {
        Self {
            point: half_space.point.into(),
            normal: half_space.unit_normal().into(),
        }
    }

    /// The signed distance of a point, in m.
    #[must_use]
    pub fn height(&self, x: &Vector3<f64>) -> f64 {
        self.normal.dot(&(x - self.point))
    }

    /// A square of the plane beneath a box, for pictures: its corners, counterclockwise for a viewer at whom
    /// the normal points. Its sides are longer than the diagonal of the box.
    #[must_use]
    pub fn square(&self, bounds: &Aabb) -> [Point; 4] {
        let [lower, upper] = [bounds.lower, bounds.upper].map(Vector3::from);
        let middle = (lower + upper) * 0.5;
        let center = middle - self.normal * self.height(&middle);
        let axis = Vector3::ith(self.normal.iamin(), 1.0);
        let side = axis.cross(&self.normal).normalize();
        let other = self.normal.cross(&side);
        let half = 0.7 * (upper - lower).norm();
        let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
        corners.map(|[a, b]| (center + side * a + other * b).into())
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
