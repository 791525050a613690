//! Half spaces as obstacles: grounds and walls without a mesh.

mod first_contact;
mod side;

use exact_ccd_mesh::{Aabb, Point};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

/// A half space that no body enters: all x with n · (x − p) ≤ 0, for a point p of its boundary and the
/// normal n of the boundary, which points outward.
///
/// The boundary is exactly the plane of these floating-point numbers. Contact with it is decided exactly
/// ([`HalfSpace::is_apart`]), friction and the barrier act on vertices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct HalfSpace {
    /// Its name, which several half spaces may share. Empty for no name.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// A point of the boundary, in m.
    #[serde(default)]
    pub point: Point,
    /// The normal of the boundary, of any length.
    pub normal: Point,
}

/// A half space with a point that is not finite, or without a normal.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the half space {half_space} has the {what} {value:?}, expected {expected}")]
pub struct HalfSpaceError {
    /// The number of the half space, from 0.
    pub half_space: usize,
    /// `point` or `normal`.
    pub what: &'static str,
    /// Its value.
    pub value: Point,
    /// The values that are allowed.
    pub expected: &'static str,
}

impl HalfSpace {
    /// The half space with a point of its boundary and the normal of the boundary, without a name.
    #[must_use]
    pub const fn new(point: Point, normal: Point) -> Self {
        let name = String::new();
        Self { name, point, normal }
    }

    /// The same half space with another name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        let name = name.into();
        Self { name, ..self }
    }

    /// Checks that the point is finite and that the normal has a direction.
    ///
    /// # Errors
    /// [`HalfSpaceError`] has the number `half_space`.
    pub fn check(&self, half_space: usize) -> Result<(), HalfSpaceError> {
        let Self { point, normal, .. } = *self;
        let error = |what, value, expected| HalfSpaceError {
            half_space,
            what,
            value,
            expected,
        };
        if !point.iter().all(|x| x.is_finite()) {
            return Err(error("point", point, "finite numbers"));
        }
        if !Vector3::from(normal).norm_squared().is_normal() {
            return Err(error(
                "normal",
                normal,
                "a vector whose squared length is a normal number",
            ));
        }
        Ok(())
    }

    /// The boundary in floating point, for the barrier and for friction.
    #[must_use]
    pub fn plane(&self) -> Plane {
        Plane {
            point: self.point.into(),
            normal: Vector3::from(self.normal).normalize(),
        }
    }

    /// A square of the boundary beneath a box, for pictures: its corners, counterclockwise for a viewer at
    /// whom the normal points. Its sides are longer than the diagonal of the box.
    #[must_use]
    pub fn square(&self, bounds: &Aabb) -> [Point; 4] {
        let plane = self.plane();
        let [lower, upper] = [bounds.lower, bounds.upper].map(Vector3::from);
        let middle = (lower + upper) * 0.5;
        let center = middle - plane.normal * plane.height(&middle);
        let axis = Vector3::ith(plane.normal.iamin(), 1.0);
        let side = axis.cross(&plane.normal).normalize();
        let other = plane.normal.cross(&side);
        let half = 0.7 * (upper - lower).norm();
        let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
        corners.map(|[a, b]| (center + side * a + other * b).into())
    }

    /// True if a point is farther than `offset` ≥ 0 from the half space: n · (x − p) > `offset` |n|, exactly,
    /// for the numbers as they are. False if a coordinate is not finite.
    ///
    /// A vertex in linear motion has n · (x − p) linear in time, hence at least its lesser value at both
    /// ends: the vertex stays apart in the whole step if and only if it is apart at both ends.
    #[must_use]
    pub fn is_apart(&self, x: Point, offset: f64) -> bool {
        side::is_beyond(self.normal, self.point, x, offset)
    }

    /// The part of a linear motion in which a vertex stays apart, from 0 to 1, in floating point. It is not
    /// certified: [`HalfSpace::is_apart`] decides the step that is taken.
    pub(crate) fn free_part(&self, [from, to]: [Point; 2], offset: f64) -> f64 {
        let plane = self.plane();
        let [before, after] = [from, to].map(|x| plane.height(&x.into()) - offset);
        if after < before {
            (before / (before - after)).clamp(0.0, 1.0)
        } else {
            1.0
        }
    }
}

/// A plane in floating point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of the plane, in m.
    pub point: Vector3<f64>,
    /// Its unit normal.
    pub normal: Vector3<f64>,
}

impl Plane {
    /// The signed distance of a point, in m.
    #[must_use]
    pub fn height(&self, x: &Vector3<f64>) -> f64 {
        self.normal.dot(&(x - self.point))
    }
}
