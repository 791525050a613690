//! The time at which primitives within d of each other leave.
//!
//! For fixed parameters, F is linear in t and |F| convex. So if |F| < d at two times, then D < d at all times
//! between. Where the parameters change linearly, F is a quadratic in t: then control points
//! shorter than d suffice.

use core::cmp::Ordering;

use super::closest::Closest;
use super::crossing::{Crossings, Sense};
use super::is_certainly_within;
use super::snapshot::Snapshot;
use crate::numbers::double_double::DoubleDouble;
use crate::numbers::vector::dot;
use crate::tables::Tables;
use crate::values::ContactTime;

/// The difference of d and the distance to which a step leads, 2⁻⁴⁴: enough for the roundings.
const MARGIN: f64 = f64::from_bits((1023 - 44) << 52);

/// The last time of an interval within d.
pub(super) struct Leaving {
    pub(super) time: ContactTime,
    /// The corners at the end of its bracket, after which D seems to be above d; none at the end of the step.
    pub(super) next: Option<Snapshot<DoubleDouble>>,
}

impl Leaving {
    fn at_end() -> Self {
        let time = ContactTime::exactly(1.0);
        Self { time, next: None }
    }
}

impl Crossings {
    /// The last time of the interval within d that has begun, if D is above d at the next f64; the end of the
    /// step if it does not end before; `None` if it is not certain.
    ///
    /// Two proofs make it certain: D < d until t, and D grows from there to the next f64. For the first, one
    /// stretch often suffices.
    pub(super) fn last_after<K: Tables>(&self, from: f64) -> Option<Leaving> {
        let now = self.rough.at::<K>(from);
        let reached = self.step(from, &now);
        if reached == 1.0 {
            return Some(Leaving::at_end());
        }
        let is_within_until = |end: f64, then: Closest| {
            self.is_within(reached, then)
                || reached > from && self.middle_is_within([from, end], [now.closest, then])
        };
        self.leaving::<K>(reached, is_within_until).or_else(|| {
            let within = self.within_until::<K>(from, reached);
            if within == 1.0 {
                return Some(Leaving::at_end());
            }
            self.leaving::<K>(within, |_, then| self.is_within(within, then))
        })
    }

    /// The time at which the primitives leave, by a guess from an earlier one on. The proof is given a time
    /// at which D < d, and the closest points then; it proves D < d from the earlier one to this time.
    fn leaving<K: Tables>(
        &self,
        from: f64,
        is_within_until: impl FnOnce(f64, Closest) -> bool,
    ) -> Option<Leaving> {
        let (end, now) = self.guess::<K>([from, 1.0], from, Sense::Rising)?;
        if end == 1.0 || !now.is_within() || !is_within_until(end, now.closest) {
            return None;
        }
        let time = ContactTime::just_above(end);
        let grows = self.approach_from::<K>(&now, time)?.sense() == Some(Ordering::Greater);
        grows.then(|| Leaving {
            time,
            next: Some(self.precise.at::<K>(end.next_up())),
        })
    }

    /// A time until which D certainly is below d, near the last one, given a [step](Self::step).
    ///
    /// Stretches follow the step, whose length is of the order of the time within d. The next one is twice as
    /// long if one is proved, otherwise half as long.
    fn within_until<K: Tables>(&self, from: f64, reached: f64) -> f64 {
        /// The longest and the shortest stretch that are tried, in units of the first step.
        const LONGEST: f64 = 4.0;
        const SHORTEST: f64 = 1.0 / 64.0;
        const ATTEMPTS: usize = 100;
        let d = self.rough.d;
        let mut within = reached;
        let mut length = LONGEST * (within - from);
        let shortest = SHORTEST * (within - from);
        let first = self.rough.at::<K>(within);
        let mut now = first.closest;
        if !is_certainly_within(first.point(), d) {
            return within;
        }
        for _ in 0..ATTEMPTS {
            if within == 1.0 || length <= shortest {
                break;
            }
            let end = (within + length).min(1.0);
            let then = self.rough.at::<K>(end);
            let is_below = is_certainly_within(then.point(), d)
                && self.middle_is_within([within, end], [now, then.closest]);
            if is_below && end > within {
                (within, now) = (end, then.closest);
                length *= 2.0;
            } else {
                length *= 0.5;
            }
        }
        within
    }

    /// Returns true if D certainly is below d between two times, given that F is at both, at certain
    /// parameters.
    ///
    /// Let the parameters change linearly from those at the time a to those at the time b. F is affine in
    /// them, so that it is a quadratic in t then, with the control points F(a, pₐ), (F(a, p_b) + F(b, pₐ))
    /// / 2 and F(b, p_b). If all have lengths below d, then so has F between. The sum has one more rounding.
    fn middle_is_within(&self, [a, b]: [f64; 2], [of_a, of_b]: [Closest; 2]) -> bool {
        let [x, y] = [self.rough.place(a, of_b), self.rough.place(b, of_a)];
        let middle = [0, 1, 2].map(|axis: usize| 0.5 * (x[axis] + y[axis]));
        is_certainly_within(middle, self.rough.d)
    }

    /// Returns true if |F| is certainly less than d at one time, at the closest points of another one. It may
    /// be just below d.
    fn is_within(&self, t: f64, closest: Closest) -> bool {
        is_certainly_within(self.rough.place(t, closest), self.rough.d) || self.precise.is_within(t, closest)
    }

    /// A later time until which D certainly is below d, or the same if there is none: the time at which the
    /// distance of the closest points is nearly d, if they keep their parameters.
    fn step(&self, from: f64, now: &Snapshot<f64>) -> f64 {
        let d = self.rough.d;
        let (x, v) = (now.point(), self.rough.velocity(now.closest));
        // The later root of |x + v s|² = (d − 2⁻⁴⁴)².
        let (a, b) = (dot(v, v), dot(x, v));
        let c = dot(x, x) - (d - MARGIN) * (d - MARGIN);
        let root = libm::sqrt(b * b - a * c);
        let step = if b > 0.0 { -c / (b + root) } else { (root - b) / a };
        let next = from + step;
        let next = if next < 1.0 { next } else { 1.0 };
        let is_below = is_certainly_within(self.rough.place(next, now.closest), d);
        if next > from && is_below && self.is_within(from, now.closest) {
            next
        } else {
            from
        }
    }
}
