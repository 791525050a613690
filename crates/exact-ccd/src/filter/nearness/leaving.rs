//! The time at which primitives within d of each other leave.
//!
//! For fixed parameters, F is linear in t and |F| convex. So if |F| < d at two times, then D < d at all times
//! between. Steps lead from the closest points at one time to the time at which their distance is nearly d,
//! which is before the primitives leave, and nearer with each step.

use core::cmp::Ordering;

use super::crossing::{Crossings, Sense};
use super::is_certainly_within;
use crate::filter::vector::dot;
use crate::kind::Kind;
use crate::time::ContactTime;

/// The difference of d and the distance to which steps lead, 2⁻⁴⁴: enough for the roundings.
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
    fn within_until<K: Kind>(&self, from: f64) -> f64 {
        const STEPS: usize = 16;
        /// Newton's method continues from such a distance of the last time.
        const SETTLED: f64 = 1.0 / 4096.0;
        let d = self.rough.separation();
        let mut within = from;
        for _ in 0..STEPS {
            let now = self.rough.at::<K>(within);
            let (x, v) = (now.point(), self.rough.velocity(now.closest));
            // The later root of |x + v s|² = (d − 2⁻⁴⁴)².
            let (a, b) = (dot(v, v), dot(x, v));
            let target = (d - MARGIN) * (d - MARGIN);
            let c = dot(x, x) - target;
            let root = libm::sqrt(b * b - a * c);
            let step = if b > 0.0 { -c / (b + root) } else { (root - b) / a };
            let next = within + step;
            let next = if next < 1.0 { next } else { 1.0 };
            let is_below = |t: f64| is_certainly_within(self.rough.place(t, now.closest), d);
            // At first, D may be just below d.
            let begins = is_below(within) || self.precise.is_within(within, now.closest);
            if !(next > within && begins && is_below(next)) {
                break;
            }
            let is_settled = b > 0.0 && next - within < SETTLED;
            within = next;
            if within == 1.0 || is_settled {
                break;
            }
        }
        within
    }
}
