//! The time at which primitives within d of each other leave.
//!
//! For fixed parameters, F is linear in t and |F| convex. So if |F| < d at two times, then D < d at all times
//! between. So does a quadratic in t with control points below d, where the parameters change linearly.

use core::cmp::Ordering;

use super::crossing::{Crossings, Sense};
use super::is_certainly_within;
use crate::filter::vector::dot;
use crate::kind::Kind;
use crate::time::ContactTime;

/// The difference of d and the distance to which a step leads, 2⁻⁴⁴: enough for the roundings.
const MARGIN: f64 = f64::from_bits((1023 - 44) << 52);

impl Crossings {
    /// The first time after which the primitives are farther than d apart, if they are within d at an earlier
    /// one and until the end of the step otherwise; `None` if it is not certain.
    ///
    /// Two proofs make it certain: D < d until t, and D grows from there to the next f64, where it is above
    /// d.
    pub(super) fn last_after<K: Kind>(&self, from: f64) -> Option<ContactTime> {
        let within = self.within_until::<K>(from);
        if within == 1.0 {
            return Some(ContactTime::exactly(1.0));
        }
        let end = self.guess::<K>([within, 1.0], within, Sense::Rising)?;
        let now = self.precise.at::<K>(end);
        let is_within = now.is_within() && self.precise.is_within(within, now.closest);
        if !is_within || end == 1.0 {
            return None;
        }
        let last = ContactTime::just_above(end);
        let leaves = self.approach::<K>(last)?.sense() == Some(Ordering::Greater);
        (leaves && self.precise.at::<K>(end.next_up()).is_beyond()).then_some(last)
    }

    /// A time until which D certainly is below d, near the last one, given an earlier one at which it is.
    ///
    /// Let the parameters change linearly from those at a time a to those at a time b. F is affine in
    /// them, so that it is a quadratic in t then, with the control points F(a, pₐ), (F(a, p_b) + F(b, pₐ))
    /// / 2 and F(b, p_b). If all have lengths below d, then so has F between. The sum has one more rounding.
    ///
    /// Such stretches follow the first step, whose length is of the order of the time within d. The next
    /// one is twice as long if one is proved, otherwise half as long.
    fn within_until<K: Kind>(&self, from: f64) -> f64 {
        /// The longest and the shortest stretch that are tried, in units of the first step.
        const LONGEST: f64 = 4.0;
        const SHORTEST: f64 = 1.0 / 64.0;
        const ATTEMPTS: usize = 100;
        let d = self.rough.separation();
        let mut within = self.step::<K>(from);
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
            let [a, b] = [self.rough.place(within, then.closest), self.rough.place(end, now)];
            let middle = [0, 1, 2].map(|axis: usize| 0.5 * (a[axis] + b[axis]));
            let is_below = is_certainly_within(then.point(), d) && is_certainly_within(middle, d);
            if is_below && end > within {
                (within, now) = (end, then.closest);
                length *= 2.0;
            } else {
                length *= 0.5;
            }
        }
        within
    }

    /// A later time until which D certainly is below d, or the same if there is none: the time at which the
    /// distance of the closest points is nearly d, if they keep their parameters.
    fn step<K: Kind>(&self, from: f64) -> f64 {
        let d = self.rough.separation();
        let now = self.rough.at::<K>(from);
        let (x, v) = (now.point(), self.rough.velocity(now.closest));
        // The later root of |x + v s|² = (d − 2⁻⁴⁴)².
        let (a, b) = (dot(v, v), dot(x, v));
        let c = dot(x, x) - (d - MARGIN) * (d - MARGIN);
        let root = libm::sqrt(b * b - a * c);
        let step = if b > 0.0 { -c / (b + root) } else { (root - b) / a };
        let next = from + step;
        let next = if next < 1.0 { next } else { 1.0 };
        let is_below = |t: f64| is_certainly_within(self.rough.place(t, now.closest), d);
        // At first, D may be just below d.
        let begins = is_below(from) || self.precise.is_within(from, now.closest);
        if next > from && begins && is_below(next) {
            next
        } else {
            from
        }
    }
}
