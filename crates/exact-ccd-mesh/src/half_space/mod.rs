//! Half spaces: grounds and walls without a mesh.

mod first_contact;
mod side;

use exact_ccd::{Point, Separation};

use crate::vector::{DIRECTION, dot, has_direction};

/// A half space that no vertex enters: all x with n · (x − p) ≤ 0, for a point p of its boundary and the
/// normal n of the boundary, which points outward.
///
/// The boundary is exactly the plane of these floating-point numbers. Contact with it is decided exactly
/// ([`HalfSpace::is_apart`]).
///
/// ```
/// use exact_ccd_mesh::{HalfSpace, Separation};
///
/// let ground = HalfSpace::new([0.0, 0.0, 0.1], [0.0, 0.0, 3.0]);
/// assert!(ground.is_apart([0.0, 0.0, 0.1_f64.next_up()], Separation::ZERO));
/// assert!(!ground.is_apart([0.0, 0.0, 0.1], Separation::ZERO));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct HalfSpace {
    /// Its name, which several half spaces may share. Empty for no name.
    pub name: String,
    /// A point of the boundary.
    pub point: Point,
    /// The normal of the boundary, of any length.
    pub normal: Point,
}

/// A half space with a point that is not finite, or without a normal.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("the {what} is {value:?}, expected {expected}")]
pub struct HalfSpaceError {
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
    /// [`HalfSpaceError`] names the one that is wrong.
    pub fn check(&self) -> Result<(), HalfSpaceError> {
        let Self { point, normal, .. } = *self;
        let error = |what, value, expected| HalfSpaceError {
            what,
            value,
            expected,
        };
        if !point.iter().all(|x| x.is_finite()) {
            return Err(error("point", point, "finite numbers"));
        }
        if !has_direction(normal) {
            return Err(error("normal", normal, DIRECTION));
        }
        Ok(())
    }

    /// The normal divided by its length, in floating point.
    #[must_use]
    pub fn unit_normal(&self) -> Point {
        let length = dot(self.normal, self.normal).sqrt();
        self.normal.map(|x| x / length)
    }

    /// Returns true if a point is farther than d from the half space: n · (x − p) > d |n|, exactly, for the
    /// numbers as they are. False if a coordinate is not finite.
    ///
    /// A vertex in linear motion has n · (x − p) linear in time, hence at least its lesser value at both
    /// ends: the vertex stays apart in the whole step if and only if it is apart at both ends.
    #[must_use]
    pub fn is_apart(&self, x: Point, d: Separation) -> bool {
        side::is_beyond(self.normal, self.point, x, d)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_point_and_a_wrong_normal_are_errors() {
        let what = |point, normal| HalfSpace::new(point, normal).check().map_err(|error| error.what);
        let normal = [0.0, 3.0, -4.0];
        assert_eq!(what([0.0; 3], normal), Ok(()));
        for axis in 0..3 {
            let mut point = [0.0; 3];
            point[axis] = f64::INFINITY;
            assert_eq!(what(point, normal), Err("point"));
        }
        assert_eq!(what([0.0; 3], [0.0; 3]), Err("normal"));
    }

    #[test]
    fn a_unit_normal_has_the_direction_of_the_normal() {
        let half_space = HalfSpace::new([1.0; 3], [0.0, 3.0, -4.0]);
        assert_eq!(half_space.unit_normal(), [0.0, 0.6, -0.8]);
    }
}
