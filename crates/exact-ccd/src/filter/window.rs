//! A part of the step, and the coefficients of polynomials there from their exact ones.
//!
//! Near a root that is almost a double or a triple one, a polynomial is far smaller than its coefficients,
//! and than their rounding errors. In a narrow window around it, the coefficients are as small as the
//! polynomial. They are computed exactly, by blossoms, and rounded only then.

use core::cmp::Ordering;

use super::cubic::Root;
use super::length::Area;
use super::wide::Wide;
use crate::time::ContactTime;

/// An integer of 512 bits.
///
/// [Coefficients of a cubic](super::length::Length) are below 2²⁵², three times one below 2²⁵⁴, and three
/// weights of 2⁶² each make them 2¹⁸⁶ times as large.
type Integer = Wide<8>;

/// The binary digits of a time.
const DIGITS: u32 = 62;

/// An interval of times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Window {
    low: f64,
    high: f64,
}

impl Window {
    /// All of the step.
    pub(super) const STEP: Self = Self { low: 0.0, high: 1.0 };

    /// A window between two times, if both are multiples of 2⁻⁶².
    pub(super) fn new(low: f64, high: f64) -> Option<Self> {
        let is_valid = low < high && parts(low).is_some() && parts(high).is_some();
        is_valid.then_some(Self { low, high })
    }

    /// The length of this window, rounded.
    pub(super) fn width(&self) -> f64 {
        self.high - self.low
    }

    /// The time at a place of this window, from 0 to 1; within three roundings.
    pub(super) fn time_at(&self, place: f64) -> f64 {
        self.low + place * self.width()
    }

    /// Three times the Bernstein coefficients of c₀ (1−t)³ + c₁ (1−t)² t + c₂ (1−t) t² + c₃ t³ in this
    /// window, in some unit.
    pub(super) fn cubic<const N: usize>(&self, cubic: &[Wide<N>; 4]) -> Option<[Integer; 4]> {
        let (low, high) = (parts(self.low)?, parts(self.high)?);
        let value = |times| blossom(of_cubic(cubic), times);
        Some([
            value([low, low, low]),
            value([low, low, high]),
            value([low, high, high]),
            value([high, high, high]),
        ])
    }

    /// The coefficients of q₀ (1−t)² + q₁ (1−t) t + q₂ t² in this window, in the same form and some unit.
    pub(super) fn quadratic<A: Area>(&self, [q0, q1, q2]: [A; 3]) -> Option<[f64; 3]> {
        if *self == Self::STEP {
            return Some([q0, q1, q2].map(A::value));
        }
        let (low, high) = (parts(self.low)?, parts(self.high)?);
        let [q0, q1, q2] = [q0, q1, q2].map(|q| q.widened().widened::<5>());
        let value = |times| blossom([q0 + q0, q1, q2 + q2], times);
        let [start, middle, end] = [[low, low], [low, high], [high, high]].map(value);
        Some([start, middle + middle, end].map(|q| q.approximate().high))
    }

    /// The time of the root of a cubic in a bracket of this window: an f64 there at which the cubic vanishes,
    /// or between two adjacent ones.
    ///
    /// The bracket has no other root, and the cubic opposite signs at its ends. If the width of the window is
    /// 2⁻ᵏ and an f64 near the root is a multiple of 2⁻⁶², then its place in the window is exact.
    pub(super) fn time<const N: usize>(&self, cubic: &[Wide<N>; 4], root: &Root) -> Option<ContactTime> {
        const STEPS: usize = 8;
        let width = self.width();
        let is_exact = width.to_bits().trailing_zeros() >= 52;
        let place = |t: f64| (is_exact && parts(t).is_some()).then(|| (t - self.low) / width);
        let below = if root.rising {
            Ordering::Less
        } else {
            Ordering::Greater
        };
        let (mut low, mut floor) = (root.low, self.low + root.low * width);
        // If the width is a power of two, the product is exact, and `floor` the nearest f64: the next one is
        // above `low`. Otherwise there are no places.
        for _ in 0..STEPS {
            let next = floor.next_up();
            if place(floor)? > low {
                floor = floor.next_down();
            } else if place(next)? >= root.high {
                return Some(ContactTime::just_above(floor));
            } else {
                let sign = blossom(of_cubic(cubic), [parts(next)?; 3]).sign();
                if sign.is_eq() {
                    return Some(ContactTime::exactly(next));
                }
                if sign != below {
                    return Some(ContactTime::just_above(floor));
                }
                (low, floor) = (place(next)?, next);
            }
        }
        None
    }
}

/// Three times its Bernstein coefficients.
fn of_cubic<const N: usize>([c0, c1, c2, c3]: &[Wide<N>; 4]) -> [Integer; 4] {
    let [c0, c1, c2, c3] = [c0, c1, c2, c3].map(|c| c.widened());
    [c0 + c0 + c0, c1, c2, c3 + c3 + c3]
}

/// The parts into which a time splits the step, in units of 2⁻⁶², if they are integers.
fn parts(t: f64) -> Option<[i64; 2]> {
    const WHOLE: i64 = 1 << DIGITS;
    let elapsed = t * WHOLE as f64;
    let integer = elapsed as i64;
    let is_exact = (0.0..=1.0).contains(&t) && integer as f64 == elapsed;
    is_exact.then_some([WHOLE - integer, integer])
}

/// The blossom of the polynomial with these Bernstein coefficients, times 2⁶² for each argument: one
/// interpolation after another.
fn blossom<const W: usize, const N: usize, const D: usize>(
    mut b: [Wide<W>; N],
    times: [[i64; 2]; D],
) -> Wide<W> {
    for (count, [left, elapsed]) in (1..N).rev().zip(times) {
        for i in 0..count {
            b[i] = b[i].times(left) + b[i + 1].times(elapsed);
        }
    }
    b[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::filter::length::Volume;

    #[test]
    fn windows_lie_between_two_multiples_of_their_unit() {
        let unit = 1.0 / (1_u64 << DIGITS) as f64;
        for [low, high] in [[0.0, 1.0], [0.25, 0.75], [unit, 2.0 * unit]] {
            let window = Window::new(low, high).expect("a window");
            assert_eq!(window.time_at(0.5), 0.5 * (low + high));
        }
        let after = 1.0 + f64::EPSILON;
        for [low, high] in [
            [0.25, 0.25],
            [0.5, 0.25],
            [0.5 * unit, 0.5],
            [unit, 1.5 * unit],
            [0.5, after],
        ] {
            assert_eq!(Window::new(low, high), None);
        }
    }

    #[test]
    fn places_are_exact_or_unknown() {
        // The root is 2/5. Places in a window whose width is no power of two are rounded.
        let cubic = [-2, 3, -2, 3].map(|c| Volume::from(i128::from(c)));
        for (high, is_known) in [(0.5, true), (0.625, false)] {
            let window = Window::new(0.25, high).expect("a window");
            let near = (0.4 - 0.25) / window.width();
            let root = Root {
                low: near - 1e-15,
                high: near + 1e-15,
                near,
                slope: 0.0,
                rising: true,
            };
            assert_eq!(window.time(&cubic, &root).is_some(), is_known, "{high}");
        }
    }

    #[test]
    fn quadratics_in_a_window_have_their_values_there() {
        let mut random = fastrand::Rng::with_seed(1);
        for [low, high] in [[0.0, 1.0], [0.25, 0.75], [0.375, 0.5]] {
            let window = Window::new(low, high).expect("a window");
            for _ in 0..200 {
                let q = [(); 3].map(|()| random.i128(-20..=20));
                let [q0, q1, q2] = q.map(|q| q as f64);
                let at = |t: f64| q0 * (1.0 - t) * (1.0 - t) + q1 * (1.0 - t) * t + q2 * t * t;
                let [start, middle, end] = window.quadratic(q).expect("the window is exact");
                // In a common unit, four times as large in the middle.
                let found = [4.0 * start, start + middle + end, 4.0 * end];
                let expected = [low, 0.5 * (low + high), high].map(at);
                for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                    assert_eq!(found[i] * expected[j], found[j] * expected[i]);
                }
                let signs = |values: [f64; 3]| values.map(|value| value.total_cmp(&0.0));
                assert_eq!(signs(found), signs(expected));
            }
        }
    }

    #[test]
    fn times_in_windows_are_those_of_the_roots() {
        let mut found = [0; 2];
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
            let parts = 1024.0;
            let low = (nearest * parts - 0.5).floor() / parts;
            let Some(window) = Window::new(low, low + 1.0 / parts) else {
                continue;
            };
            let digit = (nearest.next_up() - nearest) * parts;
            let place = (nearest - low) * parts;
            for (below, above) in (1..40).flat_map(|below| [0, 3, 40].map(|above| (below, above))) {
                let root = Root {
                    low: place - f64::from(below) * 0.4 * digit - digit,
                    high: place + f64::from(above) * 0.4 * digit + 0.6 * digit,
                    near: place,
                    slope: 0.0,
                    rising: sign > 0,
                };
                let time = window.time(&cubic, &root);
                assert!(time.is_none_or(|time| time == expected), "{a} {b} {time:?}");
                found[usize::from(time.is_some())] += 1;
                assert!(time.is_some() || below > 4, "{a} {b} {below}");
            }
        }
        assert!(found.iter().all(|&count| count > 1000), "{found:?}");
    }
}
