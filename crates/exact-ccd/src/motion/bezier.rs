//! Points on Bézier curves.

use alloc::vec::Vec;
use core::fmt;

use super::error::InvalidMotion;
use super::pose::check_points;
use crate::kind::Kind;

/// The motion of the points of a query on Bézier curves of one degree p, 1 to 8, from t = 0 to t = 1.
///
/// It is given by p + 1 sets of control points, each in the order of the kind. The first and the last are the
/// positions at t = 0 and t = 1. Two sets are straight motion, as that of a [`Query`](crate::Query); three
/// are motion with constant acceleration.
#[derive(Clone, PartialEq)]
pub struct Bezier<K: Kind>(Vec<K::Points>);

/// The largest number of control points: degree 8.
const MOST: usize = 9;

impl<K: Kind> Bezier<K> {
    /// The motion with these sets of control points, which are taken exactly.
    ///
    /// # Errors
    /// [`InvalidMotion`], if there are fewer than two sets or more than nine, or if a coordinate is not
    /// finite.
    pub fn new(control: &[K::Points]) -> Result<Self, InvalidMotion> {
        if !(2..=MOST).contains(&control.len()) {
            return Err(InvalidMotion::Degree {
                count: control.len(),
                most: MOST,
            });
        }
        check_points(control)?;
        Ok(Self(control.into()))
    }

    /// The sets of control points.
    #[must_use]
    pub fn control(&self) -> &[K::Points] {
        &self.0
    }
}

impl<K: Kind> fmt::Debug for Bezier<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Bezier").field(&self.0).finish()
    }
}
