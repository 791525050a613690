//! Two bodies in motion, prepared for many queries.

use alloc::sync::Arc;
use alloc::vec::Vec;
use core::fmt;

use super::chain::Chain;
use super::rigid_motion::RigidMotion;
use crate::exact::{MovingPoints, Turn};
use crate::filter::Relative;
use crate::kind::Kind;
use crate::tables::Point;

/// Two bodies with their motions in a step: the motion of the first one relative to the second one is
/// computed once for all queries of their points.
///
/// ```
/// use exact_ccd::motion::{BodyPair, Chain, RigidMotion};
/// use exact_ccd::{CONTACT, VertexVertex};
///
/// let turn = RigidMotion::new([[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]], &[[0.0; 3]; 2])?;
/// let pair = BodyPair::new(turn.into(), Chain::default());
/// let meets = |point| pair.query::<VertexVertex>([[2.0, 0.0, 0.0], point]);
/// assert_eq!(meets([0.0, 2.0, 0.0])?.time_of_impact(CONTACT), Some(0.5));
/// assert!(!meets([0.0, 2.5, 0.0])?.collides(CONTACT));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct BodyPair(Arc<Motions>);

struct Motions {
    chains: [Chain; 2],
    /// None if the filters do not decide: the degree or a number is too large.
    relative: Option<Relative>,
}

impl BodyPair {
    /// The pair of a body with the first motion and one with the second motion.
    #[must_use]
    pub fn new(first: Chain, second: Chain) -> Self {
        let chains = [first, second];
        let turns = chains.each_ref().map(turns);
        let relative = Relative::new([&turns[0], &turns[1]]);
        Self(Arc::new(Motions { chains, relative }))
    }

    /// The motions of both.
    #[must_use]
    pub fn chains(&self) -> &[Chain; 2] {
        &self.0.chains
    }

    /// The least and the greatest coordinates of a box around the path of a point of the first body, in the
    /// coordinates of the second one, rounded outward; infinite where no bound is known, as for a turn of
    /// 180° in a quarter of the step.
    ///
    /// An edge or a face is in the box around its vertices' boxes, and a point at most r away is in the box
    /// that is larger by r on all sides.
    #[must_use]
    pub fn bounds(&self, point: Point) -> [Point; 2] {
        let bounds = self.relative().and_then(|relative| relative.bounds(point));
        bounds.unwrap_or([[f64::NEG_INFINITY; 3], [f64::INFINITY; 3]])
    }

    pub(super) fn relative(&self) -> Option<&Relative> {
        self.0.relative.as_ref()
    }

    /// x₀ … x₃ in integers.
    pub(super) fn points<K: Kind>(&self, points: &[Point; 4]) -> MovingPoints {
        let turns = self.0.chains.each_ref().map(turns);
        MovingPoints::of_bodies::<K>(points, [&turns[0], &turns[1]])
    }
}

fn turns(chain: &Chain) -> Vec<Turn<'_>> {
    chain.motions().iter().map(RigidMotion::turn).collect()
}

impl PartialEq for BodyPair {
    fn eq(&self, other: &Self) -> bool {
        self.chains() == other.chains()
    }
}

impl fmt::Debug for BodyPair {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("BodyPair").field(self.chains()).finish()
    }
}
