//! A window: a part of the step, and the coefficients of polynomials in it.
//!
//! Near a root that is almost double or triple, a polynomial is far smaller than its coefficients, and than
//! their rounding errors. In a narrow window around the root, the coefficients are as small as the
//! polynomial. They are computed exactly from the coefficients in the step, by blossoms, and then rounded.

use core::array::from_fn;
use core::cmp::Ordering;

use super::dyadic::Dyadic;
use super::fraction::Fraction;
use super::length::{Area, Volume};
use super::wide::Wide;
use crate::numbers::cubic::Root;
use crate::values::ContactTime;

/// An integer of 576 bits.
///
/// [Coefficients of a cubic](super::length::Length) are below 2³⁷⁸, three times one below 2³⁸⁰. The weights
/// of a time add up to 2⁶² if it is a [`Dyadic`], and to less than 2⁶⁴ if it is a [`Fraction`]; there are
/// three, one for each argument of the blossom. So coefficients in a window are 2¹⁸⁶ times as large, three
/// times that below 2⁵⁶⁸, and [without roots at the ends](super::zeros::without_ends) below 2⁵⁷¹; a value is
/// below 2⁵⁷².
pub(super) type Integer = Wide<9>;

/// An interval of times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Window {
    low: Dyadic,
    high: Dyadic,
}

impl Window {
    /// All of the step.
    pub(crate) const STEP: Self = Self {
        low: Dyadic::START,
        high: Dyadic::END,
    };

    /// The window from the first time to a later one.
    pub(super) fn new(low: Dyadic, high: Dyadic) -> Option<Self> {
        (low < high).then_some(Self { low, high })
    }

    pub(super) fn ends(&self) -> [Dyadic; 2] {
        [self.low, self.high]
    }

    /// The number of units from end to end.
    pub(super) fn units(&self) -> i64 {
        self.high.units() - self.low.units()
    }

    /// The length of this window, rounded.
    pub(super) fn width(&self) -> f64 {
        self.units() as f64 / Dyadic::END.units() as f64
    }

    /// The time at a place of this window, from 0 to 1; within three roundings.
    pub(super) fn time_at(&self, place: f64) -> f64 {
        self.low.units() as f64 / Dyadic::END.units() as f64 + place * self.width()
    }

    /// The last time that is not after a place of this window, and the first that is not before it. A place
    /// that is not from 0 to 1 is taken for the nearer one of these.
    ///
    /// A place is m 2⁻ᵏ, with m below 2⁵³, and a window has at most 2⁶² units: the product is below 2¹¹⁵.
    pub(super) fn around(&self, place: f64) -> [Dyadic; 2] {
        const BITS: u32 = f64::MANTISSA_DIGITS - 1;
        // NaN included.
        if place.is_nan() || place <= 0.0 {
            return [self.low; 2];
        }
        let bits = place.min(1.0).to_bits();
        let exponent = (bits >> BITS) as u32;
        let shift = 1023 + BITS - exponent;
        // Places below 2⁻⁶⁴, subnormal ones included, are less than a unit.
        if shift > BITS + 64 {
            return [self.low, self.low.plus(1)];
        }
        let mantissa = i128::from(bits & ((1 << BITS) - 1) | 1 << BITS);
        let product = mantissa * i128::from(self.units());
        let floor = self.low.plus((product >> shift) as i64);
        let is_exact = product >> shift << shift == product;
        [floor, if is_exact { floor } else { floor.plus(1) }]
    }

    /// The ends of a bracket, rounded outward.
    pub(super) fn bracket(&self, root: &Root) -> [Dyadic; 2] {
        let [low, _] = self.around(root.low);
        let [_, high] = self.around(root.high);
        [low, high]
    }

    /// The time strictly inside a bracket that has the fewest digits.
    pub(super) fn shortest(&self, root: &Root) -> Option<Dyadic> {
        let [low, high] = self.bracket(root);
        Dyadic::between(low, high)
    }

    /// The coefficients of c₀ (1−t)³ + c₁ (1−t)² t + c₂ (1−t) t² + c₃ t³ in this window, in the same form and
    /// some unit.
    pub(super) fn cubic(&self, cubic: &[Volume; 4]) -> [Integer; 4] {
        if *self == Self::STEP {
            return cubic.map(Wide::widened);
        }
        let [low, high] = self.ends().map(Fraction::from);
        let cubic = of_cubic(cubic);
        let at_low: [_; 3] = interpolate(&cubic, low);
        let at_high: [_; 3] = interpolate(&cubic, high);
        let low_low: [_; 2] = interpolate(&at_low, low);
        let low_high: [_; 2] = interpolate(&at_low, high);
        let high_high: [_; 2] = interpolate(&at_high, high);
        let [b0] = interpolate(&low_low, low);
        let [b1] = interpolate(&low_low, high);
        let [b2] = interpolate(&low_high, high);
        let [b3] = interpolate(&high_high, high);
        [b0, b1.times(3), b2.times(3), b3]
    }

    /// The coefficients of q₀ (1−t)² + q₁ (1−t) t + q₂ t² in this window, rounded, in the same form and some
    /// unit.
    pub(super) fn quadratic<A: Area>(&self, quadratic: [A; 3]) -> [f64; 3] {
        if *self == Self::STEP {
            return quadratic.map(A::value);
        }
        let [low, high] = self.ends().map(Fraction::from);
        let quadratic = of_quadratic(quadratic);
        let at_low: [_; 2] = interpolate(&quadratic, low);
        let at_high: [_; 2] = interpolate(&quadratic, high);
        let [start] = interpolate(&at_low, low);
        let [middle] = interpolate(&at_low, high);
        let [end] = interpolate(&at_high, high);
        [start, middle + middle, end].map(|q| q.approximate().high)
    }

    /// The time of the root of a cubic in a bracket of this window: an f64 there at which the cubic vanishes,
    /// or between two adjacent ones, found by bisection with exact signs.
    ///
    /// The bracket has no other root, and the cubic opposite signs on both sides of it. The root stays
    /// between `before` and `after`. Before 2⁻¹⁰, the f64 between these may be no multiples of the unit.
    pub(super) fn time(&self, cubic: &[Volume; 4], root: &Root) -> Option<ContactTime> {
        let [low, high] = self.bracket(root).map(|end| Fraction::from(end).time());
        let (mut before, mut after) = (low.lower(), high.upper());
        while before.next_up() < after {
            let middle = 0.5 * (before + after);
            // An f64 between the ends rounded outward is between the ends.
            match sign_at(cubic, Dyadic::new(middle)?) {
                Ordering::Equal => return Some(ContactTime::exactly(middle)),
                sign if sign == root.before => before = middle,
                _ => after = middle,
            }
        }
        Some(ContactTime::just_above(before))
    }
}

/// The sign of c₀ (1−t)³ + c₁ (1−t)² t + c₂ (1−t) t² + c₃ t³ at a time.
pub(super) fn sign_at(cubic: &[Volume; 4], time: impl Into<Fraction>) -> Ordering {
    cubic_value(&of_cubic(cubic), time.into()).sign()
}

/// Returns true if a cubic certainly has one root between two times, and none at these.
///
/// The bracket of a root is rounded outward to units of time, so that it may contain two roots. The number of
/// sign changes is at least the number of roots, and has the same parity (Descartes' rule).
pub(super) fn has_one_root(cubic: &[Volume; 4], [low, high]: [Dyadic; 2]) -> bool {
    Window::new(low, high).is_some_and(|window| {
        let coefficients = window.cubic(cubic);
        let is_zero_at_end = coefficients[0].is_zero() || coefficients[3].is_zero();
        !is_zero_at_end && changes_of_sign(&coefficients) == 1
    })
}

/// The number of sign changes in the sequence of nonzero coefficients.
pub(super) fn changes_of_sign<const N: usize>(coefficients: &[Wide<N>; 4]) -> usize {
    let signs = coefficients.map(|c| c.sign());
    let nonzero = signs.into_iter().filter(|sign| sign.is_ne());
    nonzero
        .clone()
        .zip(nonzero.skip(1))
        .filter(|(before, sign)| before != sign)
        .count()
}

/// The coefficients of the powers of the units since a time, rounded, of this cubic in some unit.
pub(super) fn powers_since(time: Dyadic, cubic: &[Volume; 4]) -> [f64; 4] {
    let time = Fraction::from(time);
    let cubic = of_cubic(cubic);
    let slope: [_; 3] = differences(&cubic);
    let bend: [_; 2] = differences(&slope);
    let [third] = differences(&bend);
    let [second] = interpolate(&bend, time);
    let powers = [
        cubic_value(&cubic, time),
        quadratic_value(&slope, time).times(3),
        second.times(3),
        third,
    ];
    powers.map(|power| power.approximate().high)
}

/// The sign of q₀ (1−t)² + q₁ (1−t) t + q₂ t² at a time.
pub(super) fn quadratic_sign_at<A: Area>(quadratic: [A; 3], time: Fraction) -> Ordering {
    quadratic_value(&of_quadratic(quadratic), time).sign()
}

/// The sign of the linear function with these values at the ends of the step, at a time. The sum of the
/// weights is below 2⁶⁴: the values must be below 2⁶⁴ᵂ⁻⁶⁵.
pub(super) fn linear_sign_at<const W: usize>(ends: &[Wide<W>; 2], time: Fraction) -> Ordering {
    let [value] = interpolate(ends, time);
    value.sign()
}

/// Three times its Bernstein coefficients.
fn of_cubic([c0, c1, c2, c3]: &[Volume; 4]) -> [Integer; 4] {
    let [c0, c1, c2, c3] = [c0, c1, c2, c3].map(|c| c.widened());
    [c0 + c0 + c0, c1, c2, c3 + c3 + c3]
}

/// Twice its Bernstein coefficients: [areas](super::length::Length) are below 2²⁵¹, and two weights of the
/// blossom make twice that at most 2¹²⁸ times as large, less than 2³⁸⁰; twice that in the middle of a window.
fn of_quadratic<A: Area>(quadratic: [A; 3]) -> [Volume; 3] {
    let [q0, q1, q2] = quadratic.map(|q| q.widened().widened());
    [q0 + q0, q1, q2 + q2]
}

/// The value of the polynomial with these Bernstein coefficients at a time, in some unit.
fn cubic_value(cubic: &[Integer; 4], time: Fraction) -> Integer {
    quadratic_value(&interpolate(cubic, time), time)
}

/// The same, of degree two.
fn quadratic_value<const W: usize>(quadratic: &[Wide<W>; 3], time: Fraction) -> Wide<W> {
    let linear: [_; 2] = interpolate(quadratic, time);
    let [value] = interpolate(&linear, time);
    value
}

/// The Bernstein coefficients after one argument of a blossom is given, times the parts of that time: one
/// coefficient fewer.
#[inline(always)]
fn interpolate<const W: usize, const N: usize, const M: usize>(
    b: &[Wide<W>; N],
    time: Fraction,
) -> [Wide<W>; M] {
    const { assert!(M + 1 == N, "one coefficient fewer") };
    let [left, elapsed] = time.weights();
    let mut values = [Wide::ZERO; M];
    for (i, value) in values.iter_mut().enumerate() {
        *value = b[i].weighted(left, b[i + 1], elapsed);
    }
    values
}

/// The differences of successive coefficients.
fn differences<const N: usize, const M: usize>(b: &[Integer; N]) -> [Integer; M] {
    const { assert!(M + 1 == N, "one coefficient fewer") };
    from_fn(|i| b[i + 1] - b[i])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn window(low: f64, high: f64) -> Window {
        let [low, high] = [low, high].map(|time| Dyadic::new(time).expect("a multiple of the unit"));
        Window::new(low, high).expect("a window")
    }

    #[test]
    fn places_are_between_times() {
        let around = |window: &Window, place| window.around(place).map(Dyadic::units);
        for (place, units) in [(0.5, 1 << 61), (0.75, 3 << 60), (1.0, 1 << 62), (0.0, 0)] {
            assert_eq!(around(&Window::STEP, place), [units; 2]);
        }
        let narrow = Window::new(Dyadic::START.plus(5), Dyadic::START.plus(8)).expect("a window");
        for (place, units) in [
            (-1.0, [5, 5]),
            (-0.0, [5, 5]),
            (f64::NAN, [5, 5]),
            (0.0, [5, 5]),
            (5e-324, [5, 6]),
            (1e-300, [5, 6]),
            (0.3, [5, 6]),
            (0.34, [6, 7]),
            (0.66, [6, 7]),
            (0.67, [7, 8]),
            (1.0_f64.next_down(), [7, 8]),
            (1.0, [8, 8]),
            (f64::INFINITY, [8, 8]),
        ] {
            assert_eq!(around(&narrow, place), units, "{place}");
        }
    }

    #[test]
    fn places_of_the_step_are_rounded_from_all_their_digits() {
        let mut random = fastrand::Rng::with_seed(1);
        for _ in 0..1000 {
            // Scaled by a power of two, a place is exact, and so are the integers around it.
            let place = libm::ldexp(random.f64().next_up(), -random.i32(0..80));
            let units = place * Dyadic::END.units() as f64;
            let found = Window::STEP.around(place).map(Dyadic::units);
            assert_eq!(
                found,
                [libm::floor(units), libm::ceil(units)].map(|x| x as i64),
                "{place}"
            );
        }
    }

    #[test]
    fn polynomials_in_a_window_have_their_values_there() {
        let mut random = fastrand::Rng::with_seed(1);
        for [low, high] in [[0.0, 1.0], [0.25, 0.75], [0.375, 0.5], [0.5, 1.0]] {
            let window = window(low, high);
            for _ in 0..200 {
                let all = [(); 4].map(|()| random.i128(-20..=20));
                let [c0, c1, c2, c3] = all.map(|c| c as f64);
                let quadratic = |t: f64| c0 * (1.0 - t) * (1.0 - t) + c1 * (1.0 - t) * t + c2 * t * t;
                let cubic = |t: f64| quadratic(t) * (1.0 - t) + c3 * t * t * t;
                // At both ends and the middle in a common unit, eight times as large.
                let [q0, q1, q2] = window.quadratic([all[0], all[1], all[2]]);
                let of_quadratic = [8.0 * q0, 2.0 * (q0 + q1 + q2), 8.0 * q2];
                let c = all.map(Volume::from);
                let [b0, b1, b2, b3] = window.cubic(&c).map(|c| c.approximate().high);
                let of_cubic = [8.0 * b0, b0 + b1 + b2 + b3, 8.0 * b3];
                let times = [low, 0.5 * (low + high), high];
                for (found, expected) in [(of_quadratic, times.map(quadratic)), (of_cubic, times.map(cubic))]
                {
                    for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                        assert_eq!(found[i] * expected[j], found[j] * expected[i]);
                    }
                    let signs = |values: [f64; 3]| values.map(|value| value.partial_cmp(&0.0));
                    assert_eq!(signs(found), signs(expected));
                }
                for (t, dyadic) in [(low, window.low), (high, window.high)] {
                    assert_eq!(Some(sign_at(&c, dyadic)), cubic(t).partial_cmp(&0.0));
                    let sign = quadratic_sign_at([all[0], all[1], all[2]], dyadic.into());
                    assert_eq!(Some(sign), quadratic(t).partial_cmp(&0.0));
                }
            }
        }
    }

    #[test]
    fn powers_are_those_of_the_units_since_a_time() {
        // t − 1/4 and its powers.
        let at = Dyadic::START.plus(1 << 60);
        let unit = 1.0 / Dyadic::END.units() as f64;
        for (cubic, power) in [([-1, 1, 5, 3], 1), ([1, -5, 3, 9], 2), ([-1, 9, -27, 27], 3)] {
            let powers = powers_since(at, &cubic.map(Volume::from));
            let expected: [f64; 4] = from_fn(|i| if i == power { powers[power] } else { 0.0 });
            assert_eq!(powers, expected, "{power}");
            assert!(powers[power] > 0.0);
        }
        // 1 + (t − 1/4): the quotient is a unit.
        let [value, slope, ..] = powers_since(at, &[3, 13, 17, 7].map(Volume::from));
        assert_eq!(slope / value, unit);
    }

    #[test]
    fn times_in_windows_are_those_of_the_roots() {
        let mut found = 0;
        for (a, b) in (1_i32..40).flat_map(|a| (1..40).map(move |b| (a, b))) {
            // (b t − a (1 − t)) ((1 − t)² + t²), which vanishes at a / (a + b) only.
            let sign = if (a + b) % 2 == 0 { 1 } else { -1 };
            let cubic = [-a, b, -a, b].map(|c| Volume::from(i128::from(sign * c)));
            let [elapsed, whole] = [a, a + b].map(f64::from);
            let nearest = elapsed / whole;
            // The sign of the remainder is exact: a fused operation has one rounding.
            let remainder = nearest.mul_add(whole, -elapsed);
            let expected = if remainder == 0.0 {
                ContactTime::exactly(nearest)
            } else {
                let floor = if remainder > 0.0 {
                    nearest.next_down()
                } else {
                    nearest
                };
                ContactTime::just_above(floor)
            };
            for parts in [1024.0, 1000.0] {
                let [low, high] = [-0.5, 0.5].map(|offset| {
                    let time = (nearest * parts + offset).floor() / parts;
                    Dyadic::new(time).expect("a multiple of the unit")
                });
                let Some(window) = Window::new(low, high) else {
                    continue;
                };
                let digit = (nearest.next_up() - nearest) / window.width();
                let place = (nearest - window.time_at(0.0)) / window.width();
                if !(0.1..0.9).contains(&place) {
                    continue;
                }
                for (below, above) in (1..40).flat_map(|below| [0, 3, 40].map(|above| (below, above))) {
                    let root = Root {
                        low: place - f64::from(below) * 0.4 * digit - digit,
                        high: place + f64::from(above) * 0.4 * digit + 0.6 * digit,
                        near: place,
                        slope: 0.0,
                        before: 0.cmp(&sign),
                    };
                    let time = window.time(&cubic, &root);
                    assert_eq!(time, Some(expected), "{a} {b} {below} {above}");
                    found += 1;
                }
            }
        }
        assert!(found > 1000, "{found}");
    }
}
