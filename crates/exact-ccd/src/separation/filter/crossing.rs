//! The first time within d between two adjacent f64, where D decreases through d.

use super::advance;
use super::corners::Scaled;
use super::moment::{Moment, Moving, Precision};
use crate::filter::{DoubleDouble, Number, dot};
use crate::kind::Kind;
use crate::query::Query;
use crate::time::ContactTime;

/// A stretch of time is cut into at most two to this power of pieces.
const DEPTH: u32 = 5;

/// The same where the distance does not seem to reach d: it may become nearly as small.
const GRAZING_DEPTH: u32 = 12;

/// The first time within d, or none, when D > d is known before the time `free`; `None` if that is
/// not certain.
///
/// Newton's method guesses an f64 t. Two proofs make it certain: the distance is above d from
/// `free` to t, and below d at the next f64.
pub(super) fn first_after<K: Kind>(
    query: &Query<K>,
    scaled: &Scaled,
    free: f64,
) -> Option<Option<ContactTime>> {
    if !scaled.d_is_exact {
        return None;
    }
    let rough = Moving::<f64>::new(query, scaled);
    let precise = Moving::<DoubleDouble>::new(query, scaled);
    let stretch = Stretch {
        scaled,
        precise: &precise,
    };
    let floor = newton::<K, _>(&rough, [free, free]).and_then(|near| newton::<K, _>(&precise, [free, near]));
    let end = floor.unwrap_or(1.0);
    let is_beyond = match floor {
        Some(end) => stretch.is_beyond::<K>([free, end], DEPTH),
        None => advance::is_beyond::<K>(scaled, free, 1.0, GRAZING_DEPTH),
    };
    if !is_beyond {
        return None;
    }
    if end == 1.0 {
        return Some(None);
    }
    let next = precise.at::<K>(end.next_up());
    next.is_within().then(|| Some(ContactTime::just_above(end)))
}

/// A stretch of time in both precisions.
struct Stretch<'a> {
    scaled: &'a Scaled,
    precise: &'a Moving<DoubleDouble>,
}

impl Stretch<'_> {
    /// True if the distance is certainly above d from one time to another: in one piece, or cut in
    /// the middle. The last piece ends next to the distance d and needs twice the precision.
    fn is_beyond<K: Kind>(&self, [start, end]: [f64; 2], depth: u32) -> bool {
        let moment = |t| -> Moment<DoubleDouble> { self.precise.at::<K>(t) };
        let middle = 0.5 * (start + end);
        if moment(start).is_beyond_until(&moment(end)) {
            return true;
        }
        if depth == 0 || middle <= start || middle >= end {
            return false;
        }
        // The later part first: it is nearer to the distance d, so its proof fails more often.
        self.is_beyond::<K>([middle, end], depth - 1)
            && advance::is_beyond::<K>(self.scaled, start, middle, depth - 1)
    }
}

/// A guess of the largest f64 in [`free`, 1] before D first reaches d, from another guess on;
/// `None` if D does not seem to decrease to d.
fn newton<K: Kind, T: Precision>(moving: &Moving<T>, [free, guess]: [f64; 2]) -> Option<f64> {
    const STEPS: usize = 24;
    let (mut floor, mut approaching) = (guess, None);
    for _ in 0..STEPS {
        let now = moving.at::<K>(floor);
        let point = now.point();
        // For D = |F| and with D² − d² = (D − d) (D + d): (D − d) / D′ = (D² − d²) D / ((D + d) F ·
        // F′).
        let distance = libm::sqrt(dot(point, point));
        let slope = dot(point, moving.velocity(now.closest));
        let next = if slope < 0.0 {
            approaching = Some(floor);
            let step = -now.excess().value() * distance / ((distance + moving.separation()) * slope);
            down(floor, step).clamp(free, 1.0)
        } else {
            // D no longer decreases here: the time of d is earlier.
            0.5 * (floor + approaching?)
        };
        if (next - floor).abs() <= T::SETTLED {
            return Some(next);
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
