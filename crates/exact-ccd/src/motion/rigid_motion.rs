//! The motion of a rigid body in a step.

use alloc::vec::Vec;

use super::error::InvalidMotion;
use super::pose::{Pose, check_points, check_rotation};
use crate::exact::{Turn, vanishes};
use crate::tables::Point;

/// The motion of a rigid body from t = 0 to t = 1: it turns by q(t) = (1 − t) q₀ + t q₁, and its origin moves
/// on a Bézier curve o(t) of degree 1 to 3. The point v of the body is at o(t) + q v q* / |q|².
///
/// The quaternions, scalar first, are taken exactly, and need not have length 1. If they have the same
/// length, the orientations are those of spherical interpolation (slerp) at other times: the turn is faster
/// half way than at both ends. Where a body also translates, this is another motion than slerp. q₁ and −q₁
/// are the same orientation, but one of them leads there by a turn of more than 180° (see
/// [`Pose::nearer_turn`]).
#[derive(Clone, Debug, PartialEq)]
pub struct RigidMotion {
    quaternions: [[f64; 4]; 2],
    places: Vec<Point>,
}

/// The largest number of control points of a place: degree 3.
const MOST_PLACES: usize = 4;

impl RigidMotion {
    /// The motion with these quaternions at t = 0 and t = 1, scalar first, and with these two to four control
    /// points of the place of the origin. Free fall has three.
    ///
    /// # Errors
    /// [`InvalidMotion`], if a number is not finite, if a quaternion is 0, if the quaternion vanishes in the
    /// step (q₁ = −λ q₀ for a positive λ), or for another number of control points.
    pub fn new(quaternions: [[f64; 4]; 2], places: &[Point]) -> Result<Self, InvalidMotion> {
        for (time, &quaternion) in quaternions.iter().enumerate() {
            check_rotation(quaternion, Some(time))?;
        }
        if !(2..=MOST_PLACES).contains(&places.len()) {
            return Err(InvalidMotion::Degree {
                count: places.len(),
                most: MOST_PLACES,
            });
        }
        check_points(places.iter().map(core::slice::from_ref))?;
        if vanishes(quaternions) {
            return Err(InvalidMotion::Vanishes);
        }
        Ok(Self {
            quaternions,
            places: places.into(),
        })
    }

    /// The motion from one pose to another, with a straight path of the origin.
    ///
    /// # Errors
    /// [`InvalidMotion::Vanishes`], if the quaternions are opposite up to a positive factor.
    pub fn between(start: &Pose, end: &Pose) -> Result<Self, InvalidMotion> {
        Self::new([start.rotation(), end.rotation()], &[start.place(), end.place()])
    }

    /// The quaternions at t = 0 and t = 1.
    #[must_use]
    pub fn quaternions(&self) -> [[f64; 4]; 2] {
        self.quaternions
    }

    /// The control points of the place of the origin.
    #[must_use]
    pub fn places(&self) -> &[Point] {
        &self.places
    }

    pub(super) fn turn(&self) -> Turn<'_> {
        Turn {
            quaternions: self.quaternions,
            places: &self.places,
        }
    }
}
