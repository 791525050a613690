//! The answers to a query: floating-point filters first, then the exact path.

use crate::collision::Collision;
use crate::exact;
use crate::kind::Kind;
use crate::query::Query;
use crate::values::{DistanceBounds, Impact, Intervals, Options, Stage, TimeOutOfStep};

impl<K: Kind> Query<K> {
    /// Returns true if the primitives touch at some time of the step.
    #[must_use]
    #[inline]
    pub fn collides(&self, options: impl Into<Options>) -> bool {
        K::collides(self.points(), options.into())
    }

    /// The collision, if the primitives touch: [`collides`](Self::collides) with the intermediate
    /// results from which all further answers follow.
    #[must_use]
    #[inline]
    pub fn collision(&self, options: impl Into<Options>) -> Option<Collision<'_, K>> {
        self.decided(options.into()).ok()
    }

    /// [`collision`](Self::collision), and the stage that decided.
    #[must_use]
    #[inline]
    pub fn decide(&self, options: impl Into<Options>) -> (Option<Collision<'_, K>>, Stage) {
        match self.decided(options.into()) {
            Ok(collision) => {
                let stage = collision.stage();
                (Some(collision), stage)
            }
            Err(stage) => (None, stage),
        }
    }

    /// The largest f64 not above the first time at which the primitives touch, if they do.
    #[must_use]
    pub fn time_of_impact(&self, options: impl Into<Options>) -> Option<f64> {
        self.collision(options)
            .map(|collision| collision.time_of_impact())
    }

    /// The first time at which the primitives touch, if they do, with the closest points then. The last time
    /// that counts changes no bit of it.
    #[must_use]
    pub fn impact(&self, options: impl Into<Options>) -> Option<Impact> {
        self.collision(options).map(|collision| collision.impact())
    }

    /// All times of the step at which the primitives touch; none if the first is after the last time that
    /// counts.
    #[must_use]
    pub fn intervals(&self, options: impl Into<Options>) -> Intervals {
        self.collision(options)
            .map_or_else(Intervals::default, |collision| collision.intervals())
    }

    /// The distance of the primitives at time `t`, between two adjacent f64 or exactly: computed in integers
    /// alone.
    ///
    /// # Errors
    /// [`TimeOutOfStep`], if `t` is not in [0, 1].
    pub fn distance_at(&self, t: f64) -> Result<DistanceBounds, TimeOutOfStep> {
        TimeOutOfStep::check(t)?;
        Ok(exact::distance_at::<K>(&self.four(), t))
    }

    #[inline]
    fn decided(&self, options: Options) -> Result<Collision<'_, K>, Stage> {
        K::decide(self.points(), options).map(|decided| Collision::new(self, decided))
    }
}
