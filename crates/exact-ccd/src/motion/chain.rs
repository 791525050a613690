//! Products of rigid motions.

use alloc::vec::Vec;

use super::error::InvalidMotion;
use super::rigid_motion::RigidMotion;

/// Up to eight rigid motions, which apply from the last to the first, such as the joints from the base of
/// an arm to a body at its end. None are a body at rest in the coordinates of the world; one is a free body.
///
/// A revolute joint is a motion with quaternions about one axis, and with equal control points of its place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chain(Vec<RigidMotion>);

/// The largest number of motions.
const MOST: usize = 8;

impl Chain {
    /// The chain of these motions.
    ///
    /// # Errors
    /// [`InvalidMotion::Length`], if there are more than eight.
    pub fn new(motions: impl IntoIterator<Item = RigidMotion>) -> Result<Self, InvalidMotion> {
        let motions: Vec<_> = motions.into_iter().collect();
        if motions.len() > MOST {
            return Err(InvalidMotion::Length {
                count: motions.len(),
                most: MOST,
            });
        }
        Ok(Self(motions))
    }

    /// The motions.
    #[must_use]
    pub fn motions(&self) -> &[RigidMotion] {
        &self.0
    }
}

impl From<RigidMotion> for Chain {
    fn from(motion: RigidMotion) -> Self {
        Self([motion].into())
    }
}
