//! A query of chords, near the query of curves.

use exact_ccd::{NonFinite, Query, Separation};

use crate::error::SearchError;
use crate::kind::{CurvedKind, points};
use crate::rounding::add_up;
use crate::trajectory::{Chord, Trajectory};

/// A query of two primitives whose points move along chords, for an interval of times.
///
/// A point of a primitive is a convex combination of its vertices, with the same weights on the curves
/// and on the chords. So it deviates by at most the largest deviation of a vertex. With Δ, the sum of
/// the largest deviations of both primitives:
///
/// - F on the curves differs from F on the chords by at most Δ, at each (t, u, v).
/// - The distance of the curved primitives differs from the distance of the chords by at most Δ, at each
///   time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Straight<K: CurvedKind> {
    pub(crate) query: Query<K>,
    /// Δ; infinite if nothing is known.
    pub(crate) deviation: f64,
    pub(crate) start: f64,
    pub(crate) end: f64,
}

impl<K: CurvedKind> Straight<K> {
    /// The query of the chords of some trajectories.
    pub(crate) fn of<T: Trajectory>(trajectories: &[T], start: f64, end: f64) -> Result<Self, SearchError> {
        let chords = trajectories.iter().map(|x| Chord::of(x, start, end));
        let chords = chords.collect::<Result<Vec<_>, _>>()?;
        let [t0, t1] = [0, 1].map(|time: usize| points::<K>(|point| chords[point].ends[time]));
        let query = Query::new(t0, t1);
        let query = query.map_err(|source: NonFinite| SearchError::Position { start, end, source })?;
        Chord::check(&chords, start, end)?;
        let largest = |chords: &[Chord]| chords.iter().fold(0.0_f64, |m, chord| m.max(chord.deviation));
        let (first, second) = chords.split_at(K::FIRST);
        Ok(Self {
            query,
            deviation: add_up(largest(first), largest(second)),
            start,
            end,
        })
    }

    /// Before this time, the curved primitives are certainly more than d apart; `None` if they are at
    /// all times from the start to the end, both included.
    ///
    /// Where they are within d, the chords are within d + Δ.
    pub(crate) fn free_until(&self, d: Separation) -> Option<f64> {
        let Ok(threshold) = Separation::new(add_up(d.get(), self.deviation)) else {
            return Some(self.start);
        };
        let first = self.query.time_of_impact(threshold)?;
        Some(time_before(first, self.start, self.end))
    }

    /// At a time not after this one, the curved primitives are certainly at most d apart; `None` if
    /// this does not follow from the chords.
    ///
    /// The curved primitives are within d where the chords are within d − Δ.
    pub(crate) fn within_by(&self, d: Separation) -> Option<f64> {
        let threshold = if self.deviation == 0.0 {
            d
        } else {
            Separation::new((d.get() - self.deviation).next_down()).ok()?
        };
        let first = self.query.collision(threshold)?.time().upper();
        Some(self.after(first))
    }

    /// The end of the next chord, which begins at `start`. If this chord comes within d at a time t, the
    /// next one is 2 (t − `start`) long. It ends in the middle of this chord at the latest.
    ///
    /// The error of t has the order of the error of the free times, quadratic in the length of the chord.
    /// So the chords shrink quadratically where the distance is not stationary.
    pub(crate) fn cut(&self, d: Separation, start: f64) -> f64 {
        let middle = start + 0.5 * (self.end - start);
        let guess = self.query.time_of_impact(d).map(|first| self.after(first));
        guess.map_or(middle, |guess| {
            middle.min(guess + (guess - start).max(f64::EPSILON))
        })
    }

    /// An upper bound of the time in the step at a relative time. If the chord lasts the whole step, both
    /// are equal.
    fn after(&self, relative: f64) -> f64 {
        if is_whole(self.start, self.end) {
            return relative;
        }
        let elapsed = (relative * (self.end - self.start).next_up()).next_up();
        (self.start + elapsed).next_up().clamp(self.start, self.end)
    }
}

/// A lower bound of the time in the step at a relative time. If the chord lasts the whole step, both are
/// equal.
///
/// The difference, the product and the sum of lower bounds are each below the real value.
pub(crate) fn time_before(relative: f64, start: f64, end: f64) -> f64 {
    if is_whole(start, end) {
        return relative;
    }
    let elapsed = (relative * (end - start).next_down()).next_down();
    (start + elapsed).next_down().clamp(start, end)
}

/// Returns true for the whole step: its times are the relative ones.
fn is_whole(start: f64, end: f64) -> bool {
    start == 0.0 && end == 1.0
}
