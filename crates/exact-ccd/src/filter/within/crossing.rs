//! The times at which D passes through d, each between two adjacent f64.

use super::advance::Advancement;
use super::approach::Approach;
use super::scaled::Scaled;
use super::snapshot::{Headed, Moving, Precision, Snapshot};
use crate::numbers::double_double::DoubleDouble;
use crate::numbers::number::Number;
use crate::numbers::vector::dot;
use crate::tables::{Points, Tables};
use crate::values::ContactTime;

/// A query for which d is neither tiny nor out of range, in f64 and in twice the precision.
pub(super) struct Crossings {
    pub(super) advancement: Advancement<f64>,
    pub(super) rough: Moving<f64>,
    pub(super) precise: Moving<DoubleDouble>,
}

impl Crossings {
    pub(super) fn new<K: Tables>(points: &Points<f64>, scaled: &Scaled) -> Self {
        Self {
            advancement: Advancement::of(scaled),
            rough: Moving::new::<K>(points, scaled),
            precise: Moving::new::<K>(points, scaled),
        }
    }

    /// The first time within d, or none until the time `until`, when D > d is known before the time `free`;
    /// `None` if that is not certain.
    ///
    /// Newton's method guesses an f64 t. Two proofs make it certain: the distance is above d from
    /// `free` to t, and below d at the next f64.
    pub(super) fn first_between<K: Tables>(&self, [free, until]: [f64; 2]) -> Option<Option<ContactTime>> {
        // The last stretch ends next to the distance d and needs twice the precision.
        let Some((end, last)) = self.guess::<K>([free, until], free, Sense::Falling) else {
            return (self.advancement.free_after::<K>(free, until) == until).then_some(None);
        };
        let at_end = Headed::new(&last)?;
        let is_beyond = |start: f64| self.is_beyond_between::<K>(start, &at_end);
        if !is_beyond(free) && !is_beyond(self.advancement.free_after::<K>(free, end)) {
            return None;
        }
        if end == until {
            return Some(None);
        }
        let next = end.next_up();
        let is_within = self.precise.is_within(next, last.closest) || self.precise.at::<K>(next).is_within();
        is_within.then(|| Some(ContactTime::just_above(end)))
    }

    /// Returns true if the distance is certainly above d from one time to another one, given that it is at
    /// the latter. At the former, it mostly is not next to d, so that f64 suffice.
    pub(super) fn is_beyond_between<K: Tables>(&self, t: f64, other: &Headed<'_>) -> bool {
        let precisely = || {
            let now = self.precise.at::<K>(t);
            Headed::new(&now).is_some_and(|now| now.is_beyond_across(other))
        };
        other.is_beyond_from(&self.advancement.at::<K>(t)) || precisely()
    }

    /// A guess of the largest f64 between two times before D passes through d, from another guess on, and the
    /// corners then.
    ///
    /// The rough guess, in f64, may be beyond the time at which a small distance is least.
    pub(super) fn guess<K: Tables>(
        &self,
        range: [f64; 2],
        from: f64,
        sense: Sense,
    ) -> Option<(f64, Snapshot<DoubleDouble>)> {
        const BACK: f64 = 16.0 * <f64 as Precision>::SETTLED;
        let [first, last] = range;
        let (near, _) = newton::<K, _>(&self.rough, range, from, sense)?;
        let precise = |near: f64| newton::<K, _>(&self.precise, range, near, sense);
        precise(near).or_else(|| match sense {
            Sense::Falling => precise((near - BACK).max(first)),
            Sense::Rising => precise((near + BACK).min(last)),
        })
    }

    /// The closest points in the bracket of a time, if they are certain.
    pub(super) fn approach<K: Tables>(&self, time: ContactTime) -> Option<Approach> {
        self.approach_from::<K>(&self.precise.at::<K>(time.lower()), time)
    }

    /// The same, given the corners at the beginning of the bracket.
    pub(super) fn approach_from<K: Tables>(
        &self,
        now: &Snapshot<DoubleDouble>,
        time: ContactTime,
    ) -> Option<Approach> {
        Approach::new::<K>(now, &self.precise, time.upper() - time.lower())
    }
}

/// The way in which D passes through d.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Sense {
    Falling,
    Rising,
}

/// A guess of the largest f64 between two times before D passes through d, from another guess on, and the
/// corners at the last guess but one, which is equal in twice the precision. `None` if D does not seem to
/// pass through d.
fn newton<K: Tables, T: Precision>(
    moving: &Moving<T>,
    [free, until]: [f64; 2],
    guess: f64,
    sense: Sense,
) -> Option<(f64, Snapshot<T>)> {
    const STEPS: usize = 24;
    // D may fall before it rises through d; where it rises at first, it may never fall.
    let mut approaching = (sense == Sense::Rising).then_some(until);
    let mut floor = guess;
    for _ in 0..STEPS {
        let now = moving.at::<K>(floor);
        let point = now.point();
        // For D = |F| and with D² − d² = (D − d) (D + d): (D − d) / D′ = (D² − d²) D / ((D + d) F ·
        // F′).
        let distance = libm::sqrt(dot(point, point));
        let slope = dot(point, moving.velocity(now.closest));
        let is_approaching = match sense {
            Sense::Falling => slope < 0.0,
            Sense::Rising => slope > 0.0,
        };
        let next = if is_approaching {
            approaching = Some(floor);
            let step = -now.excess().value() * distance / ((distance + moving.d) * slope);
            down(floor, step).clamp(free, until)
        } else {
            // D no longer falls, or does not rise yet: the time of d is on the other side.
            0.5 * (floor + approaching?)
        };
        if (next - floor).abs() <= T::SETTLED {
            return Some((next, now));
        }
        floor = next;
    }
    None
}

/// a + b, rounded down.
fn down(a: f64, b: f64) -> f64 {
    let sum = a + b;
    let error = DoubleDouble::difference(a, -b) - DoubleDouble::difference(sum, 0.0);
    if error.value() < 0.0 { sum.next_down() } else { sum }
}
