//! Contact decided by the signs of integers of fixed width.
//!
//! Where primitives are flat, parallel and in touch, the numbers whose signs decide are zero, or so near to
//! it that no error bound of floating point proves a sign. They are computed exactly here. Contact at t = 0
//! is that of four points at rest. Later, the roots of the cubic are those of its exact coefficients, each
//! rounded only once.

use core::cmp::Ordering;

use super::cubic::Root;
use super::dyadic::Dyadic;
use super::lattice::Integers;
use super::length::Volume;
use super::moment::Moment;
use super::precise_cubic::PreciseCubic;
use super::wide::Wide;
use super::window::{self, Window};
use super::zeros::{narrowed, zeros};
use crate::interval::{Interval, Intervals};
use crate::kind::Kind;
use crate::query::Query;
use crate::time::ContactTime;

const AT_START: Moment = Moment::At(Dyadic::START);

/// The moment of the first contact; `Some(None)` if there certainly is no contact, `None` if that is unknown.
#[inline(never)]
pub(super) fn first_moment<K: Kind>(query: &Query<K>) -> Option<Option<Moment>> {
    let integers = Integers::new(query)?;
    if integers.volume_at_start().is_zero() && integers.touches(&AT_START)? {
        return Some(Some(AT_START));
    }
    let cubic = integers.cubic();
    if cubic == [Volume::ZERO; 4] {
        let touches = integers.touches(&Moment::Later)?;
        return (!touches).then_some(None);
    }
    for moment in zeros(&cubic)? {
        let (moment, touches) = decided(&integers, &cubic, moment)?;
        if touches {
            return Some(Some(moment));
        }
    }
    Some(None)
}

/// The first time of contact, if it is certain.
pub(super) fn first<K: Kind>(query: &Query<K>) -> Option<ContactTime> {
    time(query, &first_moment(query)??)
}

/// All times of contact, if they certainly are isolated moments.
pub(super) fn moments<K: Kind>(query: &Query<K>) -> Option<Intervals> {
    let integers = Integers::new(query)?;
    let cubic = integers.cubic();
    if cubic == [Volume::ZERO; 4] {
        let only_at_start = integers.touches(&AT_START)? && !integers.touches(&Moment::Later)?;
        return only_at_start.then(|| {
            [Interval::moment(ContactTime::exactly(0.0))]
                .into_iter()
                .collect()
        });
    }
    let of_contact =
        zeros(&cubic)?
            .into_iter()
            .filter_map(|moment| match decided(&integers, &cubic, moment) {
                Some((_, false)) => None,
                Some((moment, true)) => Some(rounded(&cubic, &moment)),
                None => Some(None),
            });
    of_contact.map(|time| time.map(Interval::moment)).collect()
}

/// A moment at which the cubic vanishes, in a narrower window if that is necessary, and true if the
/// primitives touch then; `None` if that is not certain.
fn decided<K: Kind>(integers: &Integers<K>, cubic: &[Volume; 4], moment: Moment) -> Option<(Moment, bool)> {
    if let Some(touches) = integers.touches(&moment) {
        return Some((moment, touches));
    }
    let narrow = narrowed(cubic, &moment)?;
    let touches = integers.touches(&narrow)?;
    Some((narrow, touches))
}

/// The time of a root of the coplanarity cubic in a bracket.
pub(super) fn round<K: Kind>(query: &Query<K>, root: &Root) -> Option<ContactTime> {
    time(query, &Moment::Root(Window::STEP, *root))
}

/// The time of a moment of contact.
pub(super) fn time<K: Kind>(query: &Query<K>, moment: &Moment) -> Option<ContactTime> {
    if let Moment::At(time) = moment {
        return Some(time.time());
    }
    rounded(&Integers::new(query)?.cubic(), moment)
}

/// The time at which a cubic vanishes, if it is certain.
///
/// In the step as a window, many are multiples of 2⁻¹⁰, and twice the precision suffices for most others.
fn rounded(cubic: &[Volume; 4], moment: &Moment) -> Option<ContactTime> {
    match moment {
        Moment::At(time) => Some(time.time()),
        Moment::Root(window, root) => {
            let fast = (*window == Window::STEP).then(|| {
                let short = short_time(root).filter(|&time| window::sign_at(cubic, time).is_eq());
                short.map_or_else(|| between_adjacent(cubic, root), |time| Some(time.time()))
            });
            fast.flatten().or_else(|| window.time(cubic, root))
        }
        // An interval of times has none.
        Moment::Later => None,
    }
}

/// The multiple of 2⁻¹⁰ next to a root of the step, if it is in the bracket.
fn short_time(root: &Root) -> Option<Dyadic> {
    const PARTS: f64 = (1 << 10) as f64;
    let time = libm::round(root.near * PARTS) / PARTS;
    Dyadic::new(time).filter(|_| time > root.low && time < root.high)
}

/// The time of a root of the step between two adjacent f64, if the signs of the cubic at both are certain.
fn between_adjacent(cubic: &[Volume; 4], root: &Root) -> Option<ContactTime> {
    let (precise, [c0, c1, c2, c3]) = precise(cubic);
    // The slope in the units of the integers.
    let [a1, a2, a3] = [c1 - 3.0 * c0, c2 - 2.0 * c1 + 3.0 * c0, c3 - c2 + c1 - c0];
    let slope = (3.0 * a3 * root.near + 2.0 * a2) * root.near + a1;
    precise.round(&Root { slope, ..*root })
}

/// The signs of the Bernstein coefficients of the coplanarity cubic from t = 0 to a time, if that is a multiple
/// of the unit of windows.
#[inline(never)]
pub(super) fn signs_until<K: Kind>(query: &Query<K>, time: f64) -> Option<[Ordering; 4]> {
    let window = Window::new(Dyadic::START, Dyadic::new(time)?)?;
    let cubic = Integers::new(query)?.cubic();
    Some(window.cubic(&cubic).map(|coefficient| coefficient.sign()))
}

/// The cubic in twice the precision, and its coefficients, rounded.
///
/// The bound of [`PreciseCubic::new`] holds with the largest coefficient as magnitude: one in twice the
/// precision is off by 2⁻¹⁰⁴ of itself, less than one operation, of which seven lead to a coefficient there.
fn precise(cubic: &[Volume; 4]) -> (PreciseCubic, [f64; 4]) {
    let values = cubic.map(Wide::approximate);
    let rounded = values.map(|value| value.high);
    let largest = rounded.into_iter().map(f64::abs).fold(0.0, f64::max);
    (PreciseCubic::new(values, largest), rounded)
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;

    /// The coefficients of the product of linear functions, given at both ends of the step.
    fn product(factors: [[i128; 2]; 3]) -> [Volume; 4] {
        let [[a, b], [c, d], [e, f]] = factors.map(|ends| ends.map(Volume::from));
        [
            a * c * e,
            b * c * e + a * d * e + a * c * f,
            b * d * e + b * c * f + a * d * f,
            b * d * f,
        ]
    }

    /// The times at which a cubic vanishes, if they are certain.
    fn times(cubic: &[Volume; 4]) -> Option<Vec<ContactTime>> {
        zeros(cubic)?
            .iter()
            .map(|moment| rounded(cubic, moment))
            .collect()
    }

    /// The time a / (a + b).
    fn quotient(a: i128, b: i128) -> ContactTime {
        let nearest = a as f64 / (a + b) as f64;
        // Positive if the nearest f64 is above the quotient.
        let excess = libm::fma(nearest, (a + b) as f64, -(a as f64));
        if excess == 0.0 {
            ContactTime::exactly(nearest)
        } else if excess > 0.0 {
            ContactTime::just_above(nearest.next_down())
        } else {
            ContactTime::just_above(nearest)
        }
    }

    #[test]
    fn double_and_triple_roots_are_certain_at_times_with_few_digits() {
        let parts = 1 << 3;
        for roots in (0..10_i128.pow(3)).map(|index| [100, 10, 1].map(|power| index / power % 10)) {
            // The product of linear functions from −a to 8 − a, some of which vanish at an end, or outside.
            let cubic = product(roots.map(|a| [-a, parts - a]));
            let mut expected: Vec<_> = roots.into_iter().filter(|&a| a <= parts).collect();
            expected.sort_unstable();
            expected.dedup();
            let expected: Vec<_> = expected.into_iter().map(|a| quotient(a, parts - a)).collect();
            assert_eq!(times(&cubic), Some(expected), "{roots:?}");
        }
    }

    #[test]
    fn roots_next_to_each_other_are_certain() {
        for digits in 3..=61 {
            let half = 1_i128 << (digits - 1);
            for [x, y] in [[-1, 0], [-1, 1], [1, 2], [-3, 1]] {
                // The roots are 1/2 and two others, or one, some units of 2⁻ᵏ before it or after it.
                let cubic = product([0, x, y].map(|units| [-half - units, half - units]));
                let time = |units| {
                    Dyadic::START
                        .plus(((half + units) as i64) << (62 - digits))
                        .time()
                };
                let distinct = [-3, -1, 0, 1, 2]
                    .into_iter()
                    .filter(|units| [0, x, y].contains(units));
                let expected: Vec<_> = distinct.map(time).collect();
                assert_eq!(times(&cubic), Some(expected), "{digits} {x} {y}");
            }
        }
    }

    #[test]
    fn a_root_next_to_a_fraction_of_the_step_is_not_taken_for_it() {
        // The roots are 1/2 and a / (2 a ± 1), before it or after it.
        for a in [300, 1000, 100_000, 1 << 40] {
            let half = ContactTime::exactly(0.5);
            for (ends, expected) in [
                ([-a, a + 1], [quotient(a, a + 1), half]),
                ([-a - 1, a], [half, quotient(a + 1, a)]),
            ] {
                let cubic = product([[-1, 1], ends, [1, 1]]);
                assert_eq!(times(&cubic), Some(expected.to_vec()), "{ends:?}");
            }
        }
    }

    #[test]
    fn a_narrower_window_has_the_same_root() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut narrow = 0;
        for _ in 0..300 {
            let roots = [(); 3].map(|()| [random.i128(1..1 << 20), random.i128(1..1 << 20)]);
            let cubic = product(roots.map(|[a, b]| [-a, b]));
            for moment in zeros(&cubic).expect("the roots are apart") {
                if let Some(found) = narrowed(&cubic, &moment) {
                    assert_eq!(rounded(&cubic, &found), rounded(&cubic, &moment));
                    narrow += 1;
                }
            }
        }
        assert!(narrow > 800, "{narrow}");
    }
}
