//! Queries of curved motion, and their answers.

use alloc::vec::Vec;
use core::cmp::Ordering;
use core::fmt;

use super::bezier::Bezier;
use super::body_pair::BodyPair;
use super::chain::Chain;
use crate::exact::{First, MovingPoints};
use crate::exactly::Exactly;
use crate::filter::{self, CurvedDecision};
use crate::kind::Kind;
use crate::query::NonFinite;
use crate::tables::Point;
use crate::values::{ContactTime, Impact, Intervals, Options};

/// Two primitives that move on curves: as [`Query`](crate::Query), with other paths of the points.
///
/// All answers are exact. Floating-point filters answer first, where their error bounds prove the same.
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
    Bodies { points: K::Points, pair: BodyPair },
}

impl<K: Kind> From<Bezier<K>> for CurvedQuery<K> {
    fn from(motion: Bezier<K>) -> Self {
        Self(Paths::Bezier(motion))
    }
}

impl<K: Kind> CurvedQuery<K> {
    /// The query of points of two rigid bodies, in the order of the kind: the first primitive in the
    /// coordinates of the first body, and the second one in the coordinates of the second body. For
    /// many queries of the same bodies, a [`BodyPair`] is faster.
    ///
    /// # Errors
    /// [`NonFinite`] names the first coordinate that is infinite or not a number.
    pub fn of_bodies(points: K::Points, first: Chain, second: Chain) -> Result<Self, NonFinite> {
        Self::of_pair(points, BodyPair::new(first, second))
    }

    pub(super) fn of_pair(points: K::Points, pair: BodyPair) -> Result<Self, NonFinite> {
        NonFinite::check(&[points.as_ref()])?;
        Ok(Self(Paths::Bodies { points, pair }))
    }

    /// Returns true if the primitives touch at some time of the step.
    #[must_use]
    pub fn collides(&self, options: impl Into<Options>) -> bool {
        let options = options.into();
        match self.filtered(&options) {
            CurvedDecision::Free => false,
            CurvedDecision::Touching { times, .. } if times[1] <= options.until => true,
            _ => self.exactly().collides(options),
        }
    }

    /// The largest f64 not above the first time at which the primitives touch, if they do.
    #[must_use]
    pub fn time_of_impact(&self, options: impl Into<Options>) -> Option<f64> {
        self.first_time(options).map(ContactTime::lower)
    }

    /// The first time at which the primitives touch, if they do.
    #[must_use]
    pub fn first_time(&self, options: impl Into<Options>) -> Option<ContactTime> {
        let options = options.into();
        let rounded = match self.filtered(&options) {
            CurvedDecision::Free => return None,
            CurvedDecision::Touching { times, before } => self.rounded(times, before),
            CurvedDecision::Unknown => None,
        };
        match rounded {
            Some(time) => time.is_at_most(options.until).then_some(time),
            None => self.exactly().first(options).map(|first| first.time()),
        }
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

    /// A time until which the primitives certainly do not touch, and one by which they certainly do, if the
    /// filters decide: both are infinite if the primitives do not touch until the last time that counts.
    /// `None` if integers are needed.
    #[must_use]
    pub fn bracket(&self, options: impl Into<Options>) -> Option<[f64; 2]> {
        match self.filtered(&options.into()) {
            CurvedDecision::Free => Some([f64::INFINITY; 2]),
            CurvedDecision::Touching { times, .. } => Some(times),
            CurvedDecision::Unknown => None,
        }
    }

    /// The same query, answered in integers alone.
    #[must_use]
    pub fn exactly(&self) -> Exactly<K> {
        Exactly::along(self.points())
    }

    fn first(&self, options: impl Into<Options>) -> Option<First<K>> {
        let options = options.into();
        match self.filtered(&options) {
            CurvedDecision::Free => None,
            _ => self.exactly().first(options),
        }
    }

    /// The time of the only contact between two times, given the sign of the volume at the first, if twice
    /// the precision of f64 suffices.
    fn rounded(&self, times: [f64; 2], before: Ordering) -> Option<ContactTime> {
        match &self.0 {
            Paths::Bezier(motion) => {
                let control: Vec<_> = motion.control().iter().map(four::<K>).collect();
                filter::time_on_curves::<K>(&control, times, before)
            }
            Paths::Bodies { points, pair } => {
                filter::time_of_bodies::<K>(&four::<K>(points), pair.relative()?, times, before)
            }
        }
    }

    /// The decision of the filters.
    fn filtered(&self, options: &Options) -> CurvedDecision {
        match &self.0 {
            Paths::Bezier(motion) => {
                let control = motion.control().iter().map(four::<K>);
                filter::decide_curved::<K>(control, options)
            }
            Paths::Bodies { points, pair } => match pair.relative() {
                Some(relative) => filter::decide_of_bodies::<K>(&four::<K>(points), relative, options),
                None => CurvedDecision::Unknown,
            },
        }
    }

    /// x₀ … x₃ in integers.
    fn points(&self) -> MovingPoints {
        match &self.0 {
            Paths::Bezier(motion) => {
                let control: Vec<_> = motion.control().iter().map(four::<K>).collect();
                MovingPoints::along(&control)
            }
            Paths::Bodies { points, pair } => pair.points::<K>(&four::<K>(points)),
        }
    }
}

impl BodyPair {
    /// The query of points of both bodies, in the order of the kind: the first primitive in the
    /// coordinates of the first body, and the second one in the coordinates of the second body.
    ///
    /// # Errors
    /// [`NonFinite`] names the first coordinate that is infinite or not a number.
    pub fn query<K: Kind>(&self, points: K::Points) -> Result<CurvedQuery<K>, NonFinite> {
        CurvedQuery::of_pair(points, self.clone())
    }
}

impl<K: Kind> fmt::Debug for CurvedQuery<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Paths::Bezier(motion) => motion.fmt(f),
            Paths::Bodies { points, pair } => f
                .debug_struct("Bodies")
                .field("points", points)
                .field("chains", pair.chains())
                .finish(),
        }
    }
}

/// x₀ … x₃ among the points of a query.
fn four<K: Kind>(points: &K::Points) -> [Point; 4] {
    K::LAYOUT.map(|i| points.as_ref()[i])
}
