//! Boxes that move, in single precision.

use exact_ccd::environment;

use super::aabb::Aabb;
use super::units::Units;

/// A box at both ends of a step, whose sides move at constant speed in between (T = 2), or a box at
/// rest (T = 1).
///
/// Coordinates are in [`Units`], the same for all boxes, and rounded to single precision, which halves the
/// memory traffic. Rounding is monotone: a number that is not greater than another before rounding is not
/// greater after it. So boxes that meet still meet. A thread with
/// another [`environment`] than the default one rounds outward, past the results of all other threads. No
/// coordinate is subnormal, so that comparisons do not depend on the environment.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct MovingBox<const T: usize> {
    /// The least coordinates at each time, as x, y, z and a place for alignment.
    pub(super) lower: [[f32; 4]; T],
    /// The greatest coordinates at each time.
    pub(super) upper: [[f32; 4]; T],
}

impl<const T: usize> MovingBox<T> {
    pub(crate) const EMPTY: Self = Self {
        lower: [[f32::INFINITY; 4]; T],
        upper: [[f32::NEG_INFINITY; 4]; T],
    };

    /// The box from its places at each time.
    #[inline(always)]
    pub(crate) fn new(places: &[Aabb; T], units: &Units<T>) -> Self {
        let lower = |time: usize| units.of(time, places[time].lower);
        let upper = |time: usize| units.of(time, places[time].upper);
        if environment::is_default() {
            Self {
                lower: core::array::from_fn(|time| lower(time).map(nearest)),
                upper: core::array::from_fn(|time| upper(time).map(nearest)),
            }
        } else {
            Self {
                lower: core::array::from_fn(|time| lower(time).map(below)),
                upper: core::array::from_fn(|time| upper(time).map(|x| -below(-x))),
            }
        }
    }

    /// The box that moves from one place to another (T = 2), or the box around both places, each relative to
    /// its origin (T = 1). Where an axis separates two boxes of the second kind, it separates the moving
    /// boxes at both ends, in the same order.
    #[inline(always)]
    pub(crate) fn of_path(places: &[Aabb; 2], units: &Units<2>) -> Self {
        let MovingBox { lower, upper } = MovingBox::<2>::new(places, units);
        let [start, end] = [0, 1].map(|time| MovingBox {
            lower: [lower[time]],
            upper: [upper[time]],
        });
        let around = start.union(&end);
        Self {
            lower: core::array::from_fn(|time| if T == 1 { around.lower[0] } else { lower[time] }),
            upper: core::array::from_fn(|time| if T == 1 { around.upper[0] } else { upper[time] }),
        }
    }

    /// The smallest box around two boxes at all times.
    #[inline(always)]
    pub(crate) fn union(&self, other: &Self) -> Self {
        let mut union = *self;
        for time in 0..T {
            for place in 0..4 {
                // Not f32::min and max: their handling of NaN costs time, and there is no NaN here.
                let (a, b) = (self.lower[time][place], other.lower[time][place]);
                union.lower[time][place] = if b < a { b } else { a };
                let (a, b) = (self.upper[time][place], other.upper[time][place]);
                union.upper[time][place] = if b > a { b } else { a };
            }
        }
        union
    }

    /// The rounded box at each time.
    pub(super) fn places(&self) -> [Aabb; T] {
        let point = |[x, y, z, _]: [f32; 4]| [x, y, z].map(f64::from);
        core::array::from_fn(|time| Aabb {
            lower: point(self.lower[time]),
            upper: point(self.upper[time]),
        })
    }
}

/// The nearest f32, or 0 instead of a subnormal one. Monotone.
#[inline(always)]
fn nearest(x: f64) -> f32 {
    let x = x as f32;
    if x.abs() < f32::MIN_POSITIVE { 0.0 } else { x }
}

/// An f32 that is not above [`nearest`] of a number in [`Units`], which was rounded to x in any
/// floating-point environment, and that is not subnormal.
///
/// x as an f32 is off by at most 2⁻²³ |x| + 2⁻¹²⁶, `nearest` by half of that and 2⁻¹²⁶, the number itself by
/// far less and 2⁻¹²⁰ (`units.rs`), and the three operations here by 2⁻²³ of their results: 2⁻²⁰ |x| + 2⁻¹⁰⁰
/// exceeds the sum. In any environment an overflow is above 2¹²⁶. The result is a multiple of 2⁻¹²⁴ where
/// it is near 0.
#[cold]
fn below(x: f64) -> f32 {
    /// 2¹²⁶, a quarter of the range of f32.
    const LARGE: f32 = f32::from_bits((127 + 126) << 23);
    const RELATIVE: f32 = f32::from_bits((127 - 20) << 23);
    const ABSOLUTE: f32 = f32::from_bits((127 - 100) << 23);
    let x = x as f32;
    if x < -LARGE {
        return f32::NEG_INFINITY;
    }
    let x = x.min(LARGE);
    x - (x.abs() * RELATIVE + ABSOLUTE)
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;

    use super::{MovingBox, below, nearest};
    use crate::broad_phase::{Aabb, Units};

    #[test]
    fn boxes_at_rest_are_around_the_motion_relative_to_the_origins() {
        let mut rng = Rng::with_seed(0);
        let mut numbers = || [0, 1, 2].map(|_| 8.0 * rng.f64() - 4.0);
        for _ in 0..1000 {
            let places = [0, 1].map(|_| [numbers(), numbers()].into_iter().collect::<Aabb>());
            let units = Units::relative_to([numbers(), numbers()]);
            let moving = MovingBox::<2>::of_path(&places, &units).places();
            let [around] = MovingBox::<1>::of_path(&places, &units).places();
            assert_eq!(around, moving[0].union(&moving[1]));
            // Without a motion relative to the origins, it is the box at the start.
            let shift = numbers().map(f64::round);
            let [place, origin] = [Aabb::of([0.5; 3]), Aabb::of([0.25; 3])];
            let moved = |at: &Aabb| {
                [
                    at.lower,
                    core::array::from_fn(|axis| at.lower[axis] + shift[axis]),
                ]
            };
            let units = Units::relative_to(moved(&origin));
            let around = MovingBox::<1>::of_path(&moved(&place).map(Aabb::of), &units);
            assert_eq!(around.places(), [Aabb::of([0.25; 3])]);
        }
    }

    /// The bounds of `below`, with half of the margin for the roundings of its own operations.
    #[test]
    fn numbers_below_leave_room_for_any_rounding_and_little_more() {
        let mut rng = Rng::with_seed(0);
        let [large, relative, absolute] = [126.0, -20.0, -100.0].map(f64::exp2);
        for _ in 0..100_000 {
            let size = f64::exp2(rng.f64() * 300.0 - 170.0);
            let x = size * [-1.0, 0.0, 1.0][rng.usize(..3)];
            let found = f64::from(below(x));
            let margin = relative * x.abs() + absolute;
            assert!(!below(x).is_subnormal() && below(x) <= nearest(x), "{x}");
            if x.abs() < large {
                assert!(
                    found <= x - 0.5 * margin && found >= x - 2.0 * margin,
                    "{x} {found}"
                );
            } else {
                // Where other roundings may overflow, it is −∞, or at most a quarter of the range.
                assert!(found <= x.min(large), "{x} {found}");
                assert_eq!(found == f64::NEG_INFINITY, x < 0.0, "{x} {found}");
            }
        }
    }
}
