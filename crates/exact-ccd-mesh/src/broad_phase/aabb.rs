//! Axis-aligned boxes around moving points.

use exact_ccd::Point;

use super::outward::{Format, difference_below, sum_above};

/// A closed axis-aligned box.
///
/// Boxes of points and their unions are made by comparisons alone: no coordinate is rounded. A
/// point that moves in a straight line stays in the box of its two ends, and an edge or a face in
/// the union of its vertices' boxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The least coordinates.
    pub lower: Point,
    /// The greatest coordinates.
    pub upper: Point,
}

impl Aabb {
    /// The empty box: the neutral element of [`union`](Self::union).
    pub const EMPTY: Self = Self {
        lower: [f64::INFINITY; 3],
        upper: [f64::NEG_INFINITY; 3],
    };

    /// The box of one point.
    #[must_use]
    pub fn of(point: Point) -> Self {
        Self {
            lower: point,
            upper: point,
        }
    }

    /// The smallest box around two boxes.
    #[must_use]
    #[inline(always)]
    pub fn union(&self, other: &Self) -> Self {
        // Not f64::min and max: their handling of NaN costs time, and there is no NaN here.
        let lesser = |a: f64, b: f64| if b < a { b } else { a };
        let greater = |a: f64, b: f64| if b > a { b } else { a };
        Self {
            lower: core::array::from_fn(|axis| lesser(self.lower[axis], other.lower[axis])),
            upper: core::array::from_fn(|axis| greater(self.upper[axis], other.upper[axis])),
        }
    }

    /// The same box, unbounded on the sides that are not numbers.
    pub(super) fn without_nan(&self) -> Self {
        let or = |bound: f64| move |x: f64| if x.is_nan() { bound } else { x };
        Self {
            lower: self.lower.map(or(f64::NEG_INFINITY)),
            upper: self.upper.map(or(f64::INFINITY)),
        }
    }

    /// Returns true if a point is in the box.
    #[must_use]
    pub fn contains(&self, point: &Point) -> bool {
        (0..3).all(|axis| (self.lower[axis]..=self.upper[axis]).contains(&point[axis]))
    }

    /// The center, rounded. NaN for an empty box.
    #[must_use]
    pub fn center(&self) -> Point {
        // Halved before they are added: the sum of two finite numbers may overflow.
        core::array::from_fn(|axis| 0.5 * self.lower[axis] + 0.5 * self.upper[axis])
    }

    /// The lengths of the sides, rounded.
    #[must_use]
    pub fn sides(&self) -> Point {
        core::array::from_fn(|axis| self.upper[axis] - self.lower[axis])
    }

    /// The axis of the longest side; of equally long sides, the first axis.
    pub(super) fn longest_side(&self) -> usize {
        let sides = self.sides();
        (0..3).fold(0, |longest, axis| {
            if sides[axis] > sides[longest] {
                axis
            } else {
                longest
            }
        })
    }

    /// Returns true if the boxes have a common point. Boxes that touch have one.
    #[must_use]
    #[inline]
    pub fn overlaps(&self, other: &Self) -> bool {
        meet(&[*self], &[*other])
    }

    /// The box with each side moved outwards by at least `margin`, which is not negative; the same
    /// box for 0.
    ///
    /// The result contains every point within `margin`, along each axis, of a point of the box, in any
    /// floating-point environment.
    #[must_use]
    #[inline]
    pub fn inflated(&self, margin: f64) -> Self {
        if margin.is_zero() {
            return *self;
        }
        Self {
            lower: self.lower.map(|x| difference_below(x, margin)),
            upper: self.upper.map(|x| sum_above(x, margin)),
        }
    }
}

/// Returns true unless an axis separates two boxes at all of T times, in the same order at each.
///
/// For T = 2 and boxes whose sides move at constant speed, two boxes that are separated at both
/// ends are separated at all times in between, because the gap is linear in time.
#[inline]
pub(crate) fn meet<const T: usize>(a: &[Aabb; T], b: &[Aabb; T]) -> bool {
    // Without short circuit: the comparisons cost less than a branch that is hard to predict.
    let is_before = |p: &[Aabb; T], q: &[Aabb; T], axis: usize| {
        (0..T).fold(true, |all, time| {
            all & (p[time].upper[axis] < q[time].lower[axis])
        })
    };
    (0..3).fold(true, |all, axis| {
        all & !is_before(a, b, axis) & !is_before(b, a, axis)
    })
}

/// The smallest box around some points.
impl FromIterator<Point> for Aabb {
    fn from_iter<T: IntoIterator<Item = Point>>(points: T) -> Self {
        points
            .into_iter()
            .fold(Self::EMPTY, |aabb, point| aabb.union(&Self::of(point)))
    }
}

#[cfg(test)]
mod tests {
    use super::{Aabb, meet};

    /// Of integers, whose sums and halves are exact.
    #[test]
    fn a_box_contains_what_is_between_its_sides() {
        let mut rng = fastrand::Rng::with_seed(1);
        let mut contained = 0;
        for _ in 0..1000 {
            let mut integers = |least, most| [0, 1, 2].map(|_| f64::from(rng.i32(least..=most)));
            let [lower, lengths] = [integers(-8, 8), integers(0, 8)];
            let upper = [0, 1, 2].map(|axis: usize| lower[axis] + lengths[axis]);
            let aabb = Aabb { lower, upper };
            assert_eq!(aabb.sides(), lengths);
            assert_eq!(
                aabb.center(),
                [0, 1, 2].map(|axis: usize| lower[axis] + 0.5 * lengths[axis])
            );
            let point = [0, 1, 2].map(|axis: usize| lower[axis] + f64::from(rng.i32(-1..10)));
            let is_between = (0..3).all(|axis| lower[axis] <= point[axis] && point[axis] <= upper[axis]);
            assert_eq!(aabb.contains(&point), is_between, "{aabb:?} {point:?}");
            contained += usize::from(is_between);
        }
        assert!((50..950).contains(&contained), "{contained}");
    }

    #[test]
    fn the_center_of_a_finite_box_is_finite() {
        for x in [f64::MAX, -f64::MAX, f64::from_bits(2)] {
            assert_eq!(Aabb::of([x; 3]).center(), [x; 3]);
        }
        assert!(Aabb::EMPTY.center().iter().all(|x| x.is_nan()));
    }

    #[test]
    fn sides_of_an_inflated_box_are_beyond_the_margin_and_by_little() {
        let mut rng = fastrand::Rng::with_seed(0);
        for _ in 0..1000 {
            let size = f64::exp2(rng.f64() * 100.0 - 50.0);
            let lower = [0, 1, 2].map(|_| 2.0 * rng.f64() - 1.0);
            let upper = lower.map(|x| x + rng.f64());
            let inflated = Aabb { lower, upper }.inflated(size);
            for axis in 0..3 {
                for (from, to) in [
                    (inflated.lower[axis], lower[axis]),
                    (upper[axis], inflated.upper[axis]),
                ] {
                    // Rounded once more.
                    let off = to - from - size;
                    let unit = f64::EPSILON * (2.0 + size);
                    assert!(off >= -unit && off <= 4.0 * unit, "{lower:?} {upper:?} {size}");
                }
            }
        }
    }

    /// Of integers; boxes at rest, and boxes that move.
    #[test]
    fn boxes_meet_unless_an_axis_separates_them_in_one_order_at_all_times() {
        fn expected<const T: usize>(a: &[Aabb; T], b: &[Aabb; T]) -> bool {
            let reach = |p: &[Aabb; T], q: &[Aabb; T], axis: usize| {
                (0..T).any(|t| p[t].upper[axis] >= q[t].lower[axis])
            };
            (0..3).all(|axis| reach(a, b, axis) && reach(b, a, axis))
        }
        let mut rng = fastrand::Rng::with_seed(2);
        let mut met = [0; 2];
        for _ in 0..2000 {
            let [a, b] = [(); 2].map(|()| {
                [(); 2].map(|()| {
                    let lower = [0, 1, 2].map(|_| f64::from(rng.u8(..6)));
                    let upper = lower.map(|x| x + f64::from(rng.u8(..4)));
                    Aabb { lower, upper }
                })
            });
            assert_eq!(meet(&a, &b), expected(&a, &b), "{a:?} {b:?}");
            assert_eq!(a[0].overlaps(&b[0]), expected(&[a[0]], &[b[0]]), "{a:?} {b:?}");
            assert_eq!(a[0].inflated(0.0), a[0]);
            met[0] += usize::from(meet(&a, &b));
            met[1] += usize::from(a[0].overlaps(&b[0]));
        }
        assert!(met.iter().all(|met| (200..1900).contains(met)), "{met:?}");
    }
}
