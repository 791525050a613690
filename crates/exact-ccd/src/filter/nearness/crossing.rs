//! The first time within d between two adjacent f64, where D decreases through d.

use super::advance::Advancement;
use super::scaled::Scaled;
use super::snapshot::{Moving, Precision};
use crate::filter::double_double::DoubleDouble;
use crate::filter::number::Number;
use crate::filter::vector::dot;
use crate::kind::Kind;
use crate::query::Query;
use crate::time::ContactTime;

/// The first time within d, or none until the time `until`, when D > d is known before the time `free`;
/// `None` if that is not certain.
///
/// Newton's method guesses an f64 t. Two proofs make it certain: the distance is above d from
/// `free` to t, and below d at the next f64.
pub(super) fn first_between<K: Kind>(
    query: &Query<K>,
    scaled: &Scaled,
    [free, until]: [f64; 2],
) -> Option<Option<ContactTime>> {
    let advancement = Advancement::of(scaled);
    let never = || (advancement.free_after::<K>(free, until) == until).then_some(None);
    if !scaled.d_is_exact {
        return never();
    }
    let rough = Moving::<f64>::new(query, scaled);
    let precise = Moving::<DoubleDouble>::new(query, scaled);
    let near = newton::<K, _>(&rough, [free, until], free)
        .and_then(|near| newton::<K, _>(&precise, [free, until], near));
    let Some(end) = near else {
        return never();
    };
    // The last stretch ends next to the distance d and needs twice the precision.
    let last = precise.at::<K>(end);
    let is_beyond = |start: f64| precise.at::<K>(start).is_beyond_until(&last);
    if !is_beyond(free) && !is_beyond(advancement.free_after::<K>(free, end)) {
        return None;
    }
    if end == until {
        return Some(None);
    }
    let next = precise.at::<K>(end.next_up());
    next.is_within().then(|| Some(ContactTime::just_above(end)))
}

/// A guess of the largest f64 between two times before D first reaches d, from another guess on;
/// `None` if D does not seem to decrease to d.
fn newton<K: Kind, T: Precision>(moving: &Moving<T>, [free, until]: [f64; 2], guess: f64) -> Option<f64> {
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
            down(floor, step).clamp(free, until)
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
