//! The first time at which a vertex in linear motion reaches a half space, exactly.

use std::cmp::Ordering::{self, Equal, Greater};

use dashu_int::IBig;
use exact_ccd::{Point, Separation};

use super::HalfSpace;
use crate::vector::{dot, minus};

/// The number times 2¹⁰⁷⁴, which is an integer for every finite f64.
fn integer(number: f64) -> IBig {
    let bits = number.to_bits();
    let fraction = bits & ((1 << 52) - 1);
    let exponent = (bits >> 52 & 0x7ff) as usize;
    let (mantissa, shift) = if exponent == 0 {
        (fraction, 0)
    } else {
        (fraction | 1 << 52, exponent - 1)
    };
    let magnitude = IBig::from(mantissa) << shift;
    if number.is_sign_negative() {
        -magnitude
    } else {
        magnitude
    }
}

/// 1074: [`integer`] is a number in units of 2⁻¹⁰⁷⁴.
const UNIT: usize = 1074;

impl HalfSpace {
    /// The first time t in [0, 1] at which x₀ + t (x₁ − x₀) is at most d outside of the half space, exactly:
    /// the adjacent f64 between which t lies, or the same one twice. `None` if there is no such time.
    ///
    /// The coordinates are taken as they are, without rounding. If a coordinate is not finite, the answer is
    /// 0.
    ///
    /// ```
    /// use exact_ccd_mesh::{HalfSpace, Separation};
    ///
    /// let ground = HalfSpace::new([0.0; 3], [0.0, 0.0, 2.0]);
    /// let half = Separation::new(0.5)?;
    /// let falling = [[7.0, 0.0, 2.0], [8.0, 0.0, -1.0]];
    /// // 2/3 is not an f64, 1/2 is one.
    /// let third: f64 = 2.0 / 3.0;
    /// assert_eq!(ground.first_contact(falling, Separation::ZERO), Some([third, third.next_up()]));
    /// assert_eq!(ground.first_contact(falling, half), Some([0.5, 0.5]));
    /// assert_eq!(ground.first_contact([[0.0, 0.0, 2.0], [0.0, 0.0, 1.0]], half), None);
    /// # Ok::<(), exact_ccd_mesh::InvalidSeparation>(())
    /// ```
    #[must_use]
    pub fn first_contact(&self, [x0, x1]: [Point; 2], d: Separation) -> Option<[f64; 2]> {
        let numbers = [self.normal, self.point, x0, x1];
        let is_finite = numbers.as_flattened().iter().all(|number| number.is_finite());
        if !is_finite {
            return Some([0.0; 2]);
        }
        let height = Height::new([self.normal, self.point], [x0, x1], d);
        if height.above_distance(0.0) != Greater {
            return Some([0.0; 2]);
        }
        match height.above_distance(1.0) {
            Greater => None,
            Equal => Some([1.0; 2]),
            Ordering::Less => Some(height.first_root(self.estimate([x0, x1], d))),
        }
    }

    /// The first time in floating point. It may be any number.
    fn estimate(&self, positions: [Point; 2], d: Separation) -> f64 {
        let normal = self.unit_normal();
        let height = |x: Point| dot(normal, minus(x, self.point));
        let [before, after] = positions.map(|x| height(x) - d.get());
        before / (before - after)
    }
}

/// The height n · (x(t) − p) = a + t b of a vertex above a plane, with a and b in units of 2⁻²¹⁴⁸, and the
/// square of d |n| in units of 2⁻⁴²⁹⁶.
pub(super) struct Height {
    start: IBig,
    change: IBig,
    least_squared: IBig,
}

impl Height {
    /// The height of a vertex with these positions at both ends, above the plane of a normal and a point.
    pub(super) fn new(plane: [Point; 2], positions: [Point; 2], d: Separation) -> Self {
        let [normal, point] = plane.map(|vector| vector.map(integer));
        let [x0, x1] = positions.map(|position| position.map(integer));
        let along = |from: &[IBig; 3], to: &[IBig; 3]| -> IBig {
            (0..3).map(|axis| &normal[axis] * (&to[axis] - &from[axis])).sum()
        };
        let squared: IBig = normal.iter().map(|n| n * n).sum();
        let d = integer(d.get());
        Self {
            start: along(&point, &x0),
            change: along(&x0, &x1),
            least_squared: &d * &d * squared,
        }
    }

    /// The order of the height at a time t in [0, 1] and d |n|: both sides times 2¹⁰⁷⁴, as t has that unit.
    pub(super) fn above_distance(&self, t: f64) -> Ordering {
        let height = (&self.start << UNIT) + integer(t) * &self.change;
        if height < IBig::ZERO {
            Ordering::Less
        } else {
            (&height * &height).cmp(&(&self.least_squared << (2 * UNIT)))
        }
    }

    /// The f64 around the time at which the height is d |n|: above at t = 0, below at t = 1.
    ///
    /// The f64 in [0, 1] have the order of their bits. From the guess on, the stride doubles until there are
    /// times on both sides of the root, and is at most half of the distance between them: a good guess needs
    /// few comparisons, and a bad one at most twice as many as a bisection.
    fn first_root(&self, guess: f64) -> [f64; 2] {
        let (mut before, mut after) = (0, 1f64.to_bits());
        let mut next = guess.to_bits();
        let mut stride: u64 = 1;
        while after - before > 1 {
            let bits = next.clamp(before + 1, after - 1);
            let order = self.above_distance(f64::from_bits(bits));
            match order {
                Greater => before = bits,
                Equal => return [f64::from_bits(bits); 2],
                Ordering::Less => after = bits,
            }
            stride = (2 * stride).min((after - before) / 2);
            next = if order == Greater {
                before + stride
            } else {
                after - stride
            };
        }
        [before, after].map(f64::from_bits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The time as a fraction: of the motion of a vertex above the plane z = 0, from height a to −b, it is
    /// a / (a + b).
    #[test]
    fn times_are_the_fraction_between_adjacent_numbers() {
        let mut random = fastrand::Rng::with_seed(31);
        let ground = HalfSpace::new([0.0; 3], [0.0, 0.0, 3.0]);
        for _ in 0..2000 {
            let [a, b] = [0, 1].map(|_| {
                let bits = random.u32(1..31);
                random.u32(1..1 << bits)
            });
            let motion = [[0.0, 0.0, a.into()], [1.0, 0.0, -f64::from(b)]];
            let [lower, upper] = ground.first_contact(motion, Separation::ZERO).unwrap();
            // t (a + b) and a in units of 2⁻¹⁰⁷⁴.
            let at = |t: f64| integer(t) * (u64::from(a) + u64::from(b));
            let a = IBig::from(a) << UNIT;
            assert!(at(lower) <= a && a <= at(upper), "{motion:?} {lower} {upper}");
            assert!(upper == lower || upper == lower.next_up() && at(lower) < a && a < at(upper));
        }
    }

    /// The distance is a multiple of √2 away from the plane x + y = 0, along x: the times are irrational.
    #[test]
    fn times_at_which_a_distance_is_reached_are_between_adjacent_numbers() {
        let mut random = fastrand::Rng::with_seed(33);
        let half_space = HalfSpace::new([0.0; 3], [1.0, 1.0, 0.0]);
        for _ in 0..2000 {
            let [b, d] = [0, 1].map(|_| random.u32(1..1 << 20));
            let a = 2 * d + b;
            let motion = [[f64::from(a), 0.0, 7.0], [-f64::from(b), 0.0, 7.0]];
            let distance = Separation::new(d.into()).expect("not negative");
            let [lower, upper] = half_space.first_contact(motion, distance).unwrap();
            // x > √2 d, in units of 2⁻¹⁰⁷⁴.
            let is_apart = |t: f64| {
                let x = (IBig::from(a) << UNIT) - integer(t) * (a + b);
                x > IBig::ZERO && &x * &x > IBig::from(2 * u64::from(d) * u64::from(d)) << (2 * UNIT)
            };
            assert_eq!(upper, lower.next_up(), "{motion:?} {d}");
            assert!(is_apart(lower) && !is_apart(upper), "{motion:?} {d}");
        }
    }

    /// Before the time, the vertex is apart at rest, and from it on, it is not: by [`HalfSpace::is_apart`],
    /// for a motion whose positions at these times are f64.
    #[test]
    fn the_vertex_is_apart_before_the_time_only() {
        let mut random = fastrand::Rng::with_seed(32);
        let mut inside = 0;
        for _ in 0..2000 {
            let mut number = || f64::from(random.i32(-99..100));
            let normal = [number(), number(), number()];
            let half_space = HalfSpace::new([number(), number(), number()], normal);
            let d = Separation::new(number().abs()).expect("a magnitude is not negative");
            let x1 = [number(), number(), number()];
            if half_space.check().is_err() {
                continue;
            }
            let motion = [[0.0; 3], x1];
            let at = |t: f64| x1.map(|x| t * x);
            let first = half_space.first_contact(motion, d);
            for eighth in 0..=8 {
                let t = f64::from(eighth) / 8.0;
                let is_before = first.is_none_or(|[lower, upper]| t < lower || t == lower && lower < upper);
                // A vertex that leaves is not apart at the start, and then is: only the first time counts.
                if first != Some([0.0; 2]) {
                    assert_eq!(
                        half_space.is_apart(at(t), d),
                        is_before,
                        "{half_space:?} {x1:?} {t}"
                    );
                } else if eighth == 0 {
                    assert!(!half_space.is_apart(at(0.0), d));
                }
            }
            inside += usize::from(first.is_some_and(|[lower, _]| lower > 0.0));
        }
        assert!(inside > 100, "{inside}");
    }

    #[test]
    fn numbers_of_any_magnitude_have_their_times() {
        let ground = HalfSpace::new([0.0; 3], [0.0, 0.0, f64::MAX / 1e160]);
        let first =
            |from: f64, to: f64| ground.first_contact([[0.0, 0.0, from], [0.0, 0.0, to]], Separation::ZERO);
        let tiny = f64::from_bits(1);
        assert_eq!(first(tiny, -tiny), Some([0.5; 2]));
        assert_eq!(first(f64::MAX, -f64::MAX), Some([0.5; 2]));
        // 1 / (1 + 2⁵²) = 2⁻⁵² − 2⁻¹⁰⁴ + 2⁻¹⁵⁶ − …, where the f64 are 2⁻¹⁰⁵ apart.
        let below = f64::EPSILON - f64::EPSILON * f64::EPSILON;
        assert_eq!(first(tiny, -f64::MIN_POSITIVE), Some([below, below.next_up()]));
        // The exact time is 1 − 2⁻¹⁰⁷⁴ / (2⁻¹⁰⁷⁴ + MAX), and the smallest one is below all positive f64.
        assert_eq!(first(f64::MAX, -tiny), Some([1f64.next_down(), 1.0]));
        assert_eq!(first(tiny, -f64::MAX), Some([0.0, tiny]));
        assert_eq!(first(f64::NAN, 1.0), Some([0.0; 2]));
        assert_eq!(
            (first(1.0, 0.0), first(0.0, 1.0)),
            (Some([1.0; 2]), Some([0.0; 2]))
        );
    }
}
