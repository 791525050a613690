//! Contact decided by the signs of integers of fixed width.
//!
//! Where primitives are flat, parallel and in touch, the numbers whose signs decide are zero, or so near to
//! it that no error bound of floating point proves a sign. They are computed exactly here. Contact at t = 0
//! is that of four points at rest. Later, the roots of the cubic are those of its exact coefficients, each
//! rounded only once.

use core::cmp::Ordering;

use arrayvec::ArrayVec;

use super::cubic::{Cubic, Root};
use super::lattice::{Integers, without_ends};
use super::length::Volume;
use super::moment::Moment;
use super::precise_cubic::PreciseCubic;
use super::wide::Wide;
use super::window::Window;
use crate::interval::{Interval, Intervals};
use crate::kind::Kind;
use crate::query::Query;
use crate::time::ContactTime;

/// The number of times at which a cubic may vanish, with the ends of the step.
const MAX_MOMENTS: usize = 5;

/// The moment of the first contact; `Some(None)` if there certainly is no contact, `None` if that is unknown.
#[inline(never)]
pub(super) fn first_moment<K: Kind>(query: &Query<K>) -> Option<Option<Moment>> {
    let integers = Integers::new(query)?;
    if integers.volume_at_start().is_zero() && integers.touches(&Moment::Start)? {
        return Some(Some(Moment::Start));
    }
    let cubic = integers.cubic();
    if cubic == [Volume::ZERO; 4] {
        let touches = integers.touches(&Moment::Later)?;
        return (!touches).then_some(None);
    }
    for moment in flat_moments(&cubic)? {
        if integers.touches(&moment)? {
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
        let only_at_start = integers.touches(&Moment::Start)? && !integers.touches(&Moment::Later)?;
        return only_at_start.then(|| {
            [Interval::moment(ContactTime::exactly(0.0))]
                .into_iter()
                .collect()
        });
    }
    let of_contact = flat_moments(&cubic)?
        .into_iter()
        .filter_map(|moment| match integers.touches(&moment) {
            Some(false) => None,
            Some(true) => Some(match &moment {
                Moment::Root(window, root) => rounded(integers.bits(), &cubic, window, root),
                moment => time(query, moment),
            }),
            None => Some(None),
        });
    of_contact.map(|time| time.map(Interval::moment)).collect()
}

/// The time of a root of the coplanarity cubic in a bracket.
pub(super) fn round<K: Kind>(query: &Query<K>, root: &Root) -> Option<ContactTime> {
    time(query, &Moment::Root(Window::STEP, *root))
}

/// The time of a moment of contact.
pub(super) fn time<K: Kind>(query: &Query<K>, moment: &Moment) -> Option<ContactTime> {
    match moment {
        Moment::Root(window, root) => {
            let integers = Integers::new(query)?;
            rounded(integers.bits(), &integers.cubic(), window, root)
        }
        Moment::End => Some(ContactTime::exactly(1.0)),
        Moment::Start => Some(ContactTime::exactly(0.0)),
        // An interval of times has none.
        Moment::Later => None,
    }
}

/// The moments at which a cubic that is not zero vanishes, in increasing order, if they are certain.
///
/// The bounds of [`Cubic::new`] hold with the largest coefficient as magnitude: each coefficient is rounded
/// once, n = 1 of the ten roundings there, and the largest rounded one is below its integer by one rounding
/// at most. Coefficients are below 2²⁵² ([`Length`](super::length::Length)): nothing overflows. The largest
/// is at least 1, so that what underflows is far below the bounds.
fn flat_moments(cubic: &[Volume; 4]) -> Option<ArrayVec<Moment, MAX_MOMENTS>> {
    let (inner, [at_start, at_end]) = without_ends(*cubic);
    let values = inner.map(|c| c.approximate().high);
    let cubic = Cubic::new(values, largest(values));
    let mut moments = ArrayVec::new();
    moments.extend(at_start.then_some(Moment::Start));
    match cubic.roots() {
        Some(roots) => moments.extend(roots.into_iter().map(|root| Moment::Root(Window::STEP, root))),
        None => {
            let almost_triple = roots_in_windows(&inner, &[cubic.inflection()]);
            moments.extend(almost_triple.or_else(|| roots_in_windows(&inner, &cubic.cuts()))?);
        }
    }
    moments.extend(at_end.then_some(Moment::End));
    Some(moments)
}

/// The roots of a cubic, if they are certain, in windows around these times, and between them: those at which
/// it may have almost double or triple roots.
///
/// The signs of the coefficients in a window are exact: without two opposite ones, there is no root.
/// Otherwise the bounds of [`Cubic::new`] hold as in [`flat_moments`], with one more rounding.
fn roots_in_windows(inner: &[Volume; 4], middles: &[f64]) -> Option<ArrayVec<Moment, 3>> {
    let mut moments = ArrayVec::new();
    let mut low = 0.0;
    for high in around(middles).into_iter().chain([1.0]) {
        let window = Window::new(low, high)?;
        let coefficients = window.cubic(inner)?;
        let signs = coefficients.map(|c| c.sign());
        if signs[0].is_eq() || signs[3].is_eq() {
            return None;
        }
        if signs != [signs[0]; 4] {
            let [b0, b1, b2, b3] = coefficients.map(|c| c.approximate().high);
            let magnitude = largest([b0, b1, b2, b3]);
            let roots = Cubic::new([b0, 3.0 * b1, 3.0 * b2, b3], magnitude).roots()?;
            for root in roots {
                moments.try_push(Moment::Root(window, root)).ok()?;
            }
        }
        low = high;
    }
    Some(moments)
}

/// The ends of the windows around some times, 2⁻⁴³ wide, in increasing order; one window for two near times.
fn around(times: &[f64]) -> ArrayVec<f64, 4> {
    const HALF: f64 = 1.0 / (1_u64 << 44) as f64;
    const UNITS: f64 = (1_u64 << 52) as f64;
    let mut ends = ArrayVec::new();
    for &time in times {
        let middle = libm::round(time * UNITS) / UNITS;
        let [low, high] = [middle - HALF, middle + HALF];
        let is_apart = ends.last().is_none_or(|&last| low > last);
        if is_apart && low > 0.0 && high < 1.0 {
            ends.extend([low, high]);
        }
    }
    ends
}

fn largest(values: [f64; 4]) -> f64 {
    values.into_iter().map(f64::abs).fold(0.0, f64::max)
}

/// The time of the only root of a cubic in a bracket: a multiple of 2⁻¹⁰, as many are in flat worlds, or
/// between two adjacent f64.
fn rounded(bits: u32, cubic: &[Volume; 4], window: &Window, root: &Root) -> Option<ContactTime> {
    if *window != Window::STEP {
        return window.time(cubic, root);
    }
    let dyadic = fraction(root).and_then(|fraction| at_fraction(bits, cubic, fraction));
    dyadic.or_else(|| between_adjacent(cubic, root))
}

/// The number of parts of the step whose ends are tried.
const PARTS: i64 = 1 << 10;

/// The number of such parts that have elapsed at the end next to a root, if that is in the bracket.
fn fraction(root: &Root) -> Option<i64> {
    let elapsed = libm::round(root.near * PARTS as f64);
    let t = elapsed / PARTS as f64;
    (t > root.low && t < root.high).then_some(elapsed as i64)
}

/// The time at which this part of the step has elapsed, if the cubic of coordinates of b bits vanishes then.
///
/// In 2ᵏ parts, a fraction in lowest terms, the points are multiples of 2⁻ᵏ. With 2ᵏ as the unit, their
/// coordinates are below 2ᵇ⁺ᵏ, and the volume, which is the cubic at that time, is below 6 · 2³⁽ᵇ⁺ᵏ⁺¹⁾ <
/// 2³⁽ᵇ⁺ᵏ⁾⁺⁶: it is exact if b + k ≤ 83.
fn at_fraction(bits: u32, &[c0, c1, c2, c3]: &[Volume; 4], elapsed: i64) -> Option<ContactTime> {
    let common = elapsed.trailing_zeros().min(PARTS.trailing_zeros());
    let [t, s] = [elapsed, PARTS - elapsed].map(|part| part >> common);
    let is_exact = bits + (PARTS.trailing_zeros() - common) <= 83;
    let value = || c0.times(s * s * s) + c1.times(s * s * t) + c2.times(s * t * t) + c3.times(t * t * t);
    (is_exact && value().is_zero()).then(|| ContactTime::exactly(elapsed as f64 / PARTS as f64))
}

/// The root in a bracket between two adjacent f64, if the signs of the cubic at both are certain.
fn between_adjacent(cubic: &[Volume; 4], root: &Root) -> Option<ContactTime> {
    let (precise, [c0, c1, c2, c3]) = precise(cubic);
    // The slope in the units of the integers.
    let [a1, a2, a3] = [c1 - 3.0 * c0, c2 - 2.0 * c1 + 3.0 * c0, c3 - c2 + c1 - c0];
    let slope = (3.0 * a3 * root.near + 2.0 * a2) * root.near + a1;
    precise.round(&Root { slope, ..*root })
}

/// The sign of the coplanarity cubic at a time, if it is certain.
#[inline(never)]
pub(super) fn sign_at<K: Kind>(query: &Query<K>, time: f64) -> Option<Ordering> {
    let integers = Integers::new(query)?;
    let cubic = integers.cubic();
    let elapsed = time * PARTS as f64;
    if elapsed == libm::trunc(elapsed) && at_fraction(integers.bits(), &cubic, elapsed as i64).is_some() {
        return Some(Ordering::Equal);
    }
    precise(&cubic).0.sign_at(time)
}

/// The cubic in twice the precision, and its coefficients, rounded.
///
/// The bound of [`PreciseCubic::new`] holds as in [`flat_moments`]: a coefficient in twice the precision is
/// off by 2⁻¹⁰⁴ of itself, less than one operation, of which seven lead to a coefficient there.
fn precise(cubic: &[Volume; 4]) -> (PreciseCubic, [f64; 4]) {
    let values = cubic.map(Wide::approximate);
    let rounded = values.map(|value| value.high);
    (PreciseCubic::new(values, largest(rounded)), rounded)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The coefficients of the product of linear functions, given at both ends of the step.
    fn product([[a, b], [c, d], [e, f]]: [[i128; 2]; 3]) -> [i128; 4] {
        [
            a * c * e,
            b * c * e + a * d * e + a * c * f,
            b * d * e + b * c * f + a * d * f,
            b * d * f,
        ]
    }

    #[test]
    fn a_fraction_of_the_step_is_found_where_the_cubic_vanishes() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut found = 0;
        for _ in 0..200 {
            // The product of linear functions from −a to b, each of which vanishes at a / (a + b).
            let factors = [(); 3].map(|()| {
                let a = random.i128(1..8);
                [-a, 8 - a]
            });
            let coefficients = product(factors);
            let cubic = coefficients.map(Volume::from);
            for elapsed in 0..=PARTS {
                let [t, s] = [elapsed, PARTS - elapsed].map(i128::from);
                let linear = |[x, y]: [i128; 2]| x * s + y * t;
                let is_root = factors.into_iter().any(|ends| linear(ends) == 0);
                let time = at_fraction(8, &cubic, elapsed);
                let expected = ContactTime::exactly(elapsed as f64 / PARTS as f64);
                assert_eq!(time, is_root.then_some(expected), "{coefficients:?} {elapsed}");
                found += u32::from(is_root);
            }
        }
        assert!(found > 200, "{found}");
    }

    #[test]
    fn a_root_next_to_a_fraction_of_the_step_is_not_taken_for_it() {
        // The roots are 1/2 and a / (2 a ± 1), before it or after it.
        for [a, b] in [300, 1000, 100_000]
            .into_iter()
            .flat_map(|a| [[a, a + 1], [a + 1, a]])
        {
            let cubic = product([[-1, 1], [-a, b], [1, 1]]).map(Volume::from);
            let moments = flat_moments(&cubic).expect("the roots are apart");
            let times = moments.iter().map(|moment| match moment {
                Moment::Root(window, root) => rounded(20, &cubic, window, root),
                _ => None,
            });
            let nearest = a as f64 / (a + b) as f64;
            // Positive if the nearest f64 is above the root.
            let excess = libm::fma(nearest, (a + b) as f64, -(a as f64));
            let floor = if excess > 0.0 {
                nearest.next_down()
            } else {
                nearest
            };
            let other = ContactTime::just_above(floor);
            let half = ContactTime::exactly(0.5);
            let expected = if a < b { [other, half] } else { [half, other] };
            assert!(times.eq(expected.map(Some)), "{a}");
        }
    }

    #[test]
    fn a_root_at_the_end_of_a_window_is_not_certain() {
        // The roots are 1/2 and 1/2 ± 2⁻ᵏ; windows are 2⁻⁴³ wide.
        for (digits, is_certain) in [(44, false), (45, true), (46, true)] {
            let half = 1_i128 << (digits - 1);
            let (x, y) = (half - 1, half + 1);
            let square = x * x + y * y;
            let cubic = [-x * y, x * y + square, -x * y - square, x * y].map(Volume::from);
            let moments = roots_in_windows(&cubic, &[0.5]);
            assert_eq!(moments.is_some(), is_certain, "{digits}");
            let times = moments
                .unwrap_or_default()
                .into_iter()
                .map(|moment| match moment {
                    Moment::Root(window, root) => window.time(&cubic, &root),
                    _ => None,
                });
            let step = 1.0 / (1_u64 << digits) as f64;
            let all = [0.5 - step, 0.5, 0.5 + step].map(|t| Some(ContactTime::exactly(t)));
            assert!(!is_certain || times.eq(all), "{digits}");
        }
    }
}
