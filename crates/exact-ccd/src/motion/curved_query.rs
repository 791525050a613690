//! Queries of curved motion, and their answers.

use alloc::vec::Vec;
use core::fmt;

use super::bezier::Bezier;
use super::chain::Chain;
use super::rigid_motion::RigidMotion;
use crate::exact::{First, MovingPoints, Turn};
use crate::kind::Kind;
use crate::query::NonFinite;
use crate::tables::Point;
use crate::values::{Impact, Intervals, Options};

/// Two primitives that move on curves: as [`Query`](crate::Query), with other paths of the points.
///
/// All answers are exact, and decided in integers.
///
/// ```
/// use exact_ccd::motion::{Chain, CurvedQuery, RigidMotion};
/// use exact_ccd::{CONTACT, EdgeEdge};
///
/// // A bar turns by a right angle about the z axis, and swings into a post.
/// let turn = RigidMotion::new([[1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 1.0]], &[[0.0; 3]; 2])?;
/// let bar = [[1.0, 0.0, 0.0], [4.0, 0.0, 0.0]];
/// let post = [[2.0, 2.0, -1.0], [2.0, 2.0, 1.0]];
/// let points = [bar[0], bar[1], post[0], post[1]];
/// let query = CurvedQuery::<EdgeEdge>::of_bodies(points, turn.into(), Chain::default())?;
/// // tan(π / 8) = √2 − 1
/// assert_eq!(query.time_of_impact(CONTACT), Some(0.41421356237309503));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct CurvedQuery<K: Kind>(Paths<K>);

#[derive(Clone, PartialEq)]
enum Paths<K: Kind> {
    Bezier(Bezier<K>),
    Bodies { points: K::Points, chains: [Chain; 2] },
}

impl<K: Kind> From<Bezier<K>> for CurvedQuery<K> {
    fn from(motion: Bezier<K>) -> Self {
        Self(Paths::Bezier(motion))
    }
}

impl<K: Kind> CurvedQuery<K> {
    /// The query of points of two rigid bodies, in the order of the kind: those of the first primitive in the
    /// coordinates of the first body, and those of the second one in the coordinates of the second body.
    ///
    /// # Errors
    /// [`NonFinite`] names the first coordinate that is infinite or not a number.
    pub fn of_bodies(points: K::Points, first: Chain, second: Chain) -> Result<Self, NonFinite> {
        NonFinite::check(&[points.as_ref()])?;
        let chains = [first, second];
        Ok(Self(Paths::Bodies { points, chains }))
    }

    /// Returns true if the primitives touch at some time of the step.
    #[must_use]
    pub fn collides(&self, options: impl Into<Options>) -> bool {
        let options = options.into();
        if options.until >= 1.0 {
            First::<K>::exists_along(self.points(), options.separation)
        } else {
            self.first(options).is_some()
        }
    }

    /// The largest f64 not above the first time at which the primitives touch, if they do.
    #[must_use]
    pub fn time_of_impact(&self, options: impl Into<Options>) -> Option<f64> {
        self.first(options).map(|first| first.time().lower())
    }

    /// All times of the step at which the primitives touch; none if the first is after the last time that
    /// counts.
    #[must_use]
    pub fn intervals(&self, options: impl Into<Options>) -> Intervals {
        self.first(options)
            .map_or_else(Intervals::default, |first| first.intervals())
    }

    /// The first time at which the primitives touch, if they do, with the closest points then. The normal is
    /// in the coordinates of the world.
    #[must_use]
    pub fn impact(&self, options: impl Into<Options>) -> Option<Impact> {
        self.first(options).map(|first| first.impact())
    }

    fn first(&self, options: impl Into<Options>) -> Option<First<K>> {
        let options = options.into();
        First::along(self.points(), options.separation)?.until(options.until)
    }

    /// x₀ … x₃ in integers.
    fn points(&self) -> MovingPoints {
        match &self.0 {
            Paths::Bezier(motion) => {
                let control: Vec<_> = motion.control().iter().map(four::<K>).collect();
                MovingPoints::along(&control)
            }
            Paths::Bodies { points, chains } => {
                let turns = [0, 1].map(|body: usize| {
                    let motions = chains[body].motions().iter();
                    motions.map(RigidMotion::turn).collect::<Vec<Turn<'_>>>()
                });
                MovingPoints::of_bodies::<K>(&four::<K>(points), [&turns[0], &turns[1]])
            }
        }
    }
}

impl<K: Kind> fmt::Debug for CurvedQuery<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Paths::Bezier(motion) => motion.fmt(f),
            Paths::Bodies { points, chains } => f
                .debug_struct("Bodies")
                .field("points", points)
                .field("chains", chains)
                .finish(),
        }
    }
}

/// x₀ … x₃ among the points of a query.
fn four<K: Kind>(points: &K::Points) -> [Point; 4] {
    K::LAYOUT.map(|i| points.as_ref()[i])
}
