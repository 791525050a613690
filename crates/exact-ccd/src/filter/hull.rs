//! Separating directions: F(t, u, v) lies in the convex hull of its values at the corners of the
//! domain. So F has no root if all these values lie strictly on one side of a plane through the
//! origin.

use core::f64::consts::SQRT_2;
use core::ops::Add;

use super::coplanarity::length_bound;
use super::gap::Gap;
use crate::numbers::number::{Lanes, subtract};
use crate::numbers::roundoff::{LARGEST, UNDERFLOW, UNIT, margin};
use crate::numbers::vector::{dot, minus, towards};
use crate::tables::{Point, Points, Tables};

/// The eight values of F at the corners of its domain, by axis. A vertex-face query has six corners; two of
/// them are repeated.
pub(crate) struct Hull<T> {
    corners: [[T; 8]; 3],
    low: [T; 3],
    high: [T; 3],
}

impl<T: Lanes> Hull<T> {
    #[inline(always)]
    pub(crate) fn new<K: Tables>(points: &Points<T>) -> Self {
        let mut corners = points[0][0].map(|x| [x; 8]);
        for (corner, &difference) in K::CORNERS.iter().enumerate() {
            for (time, at_time) in subtract::<T>(points, difference).iter().enumerate() {
                for axis in 0..3 {
                    corners[axis][4 * time + corner] = at_time[axis];
                }
            }
        }
        let (mut low, mut high) = (corners.map(|row| row[0]), corners.map(|row| row[0]));
        for axis in 0..3 {
            for (i, &x) in corners[axis].iter().enumerate().skip(1) {
                // The others are repeated.
                if i % 4 < K::FEATURES.vertices.len() {
                    low[axis] = x.min(low[axis]);
                    high[axis] = x.max(high[axis]);
                }
            }
        }
        Self { corners, low, high }
    }

    /// The largest magnitude of the corners along an axis.
    #[inline(always)]
    fn reach(&self, axis: usize) -> T {
        self.high[axis].max(-self.low[axis])
    }

    /// The same of all axes.
    #[inline(always)]
    pub(crate) fn reaches(&self) -> [T; 3] {
        [self.reach(0), self.reach(1), self.reach(2)]
    }

    /// True where a coordinate of a corner, or the gap, exceeds [`LARGEST`].
    #[inline(always)]
    pub(crate) fn is_out_of_range<G: Gap<T>>(&self, gap: G) -> T::Mask {
        let largest = self.low[0].splat(LARGEST);
        let far = self.reach(0).gt(largest) | self.reach(1).gt(largest) | self.reach(2).gt(largest);
        if G::IS_POSITIVE {
            far | gap.value(largest).gt(largest)
        } else {
            far
        }
    }

    /// The corners at t = 0 or at t = 1.
    #[inline(always)]
    pub(crate) fn corners(&self, time: usize) -> [[T; 3]; 4] {
        let [x, y, z] = &self.corners;
        let i = 4 * time;
        [
            [x[i], y[i], z[i]],
            [x[i + 1], y[i + 1], z[i + 1]],
            [x[i + 2], y[i + 2], z[i + 2]],
            [x[i + 3], y[i + 3], z[i + 3]],
        ]
    }

    #[inline(always)]
    pub(super) fn along(&self, direction: [T; 3]) -> [T; 8] {
        let [x, y, z] = &self.corners;
        let mut along = *x;
        for i in 0..8 {
            along[i] = direction[0] * x[i] + direction[1] * y[i] + direction[2] * z[i];
        }
        along
    }

    /// The error bound of a scalar product: one rounding of the corner, one product and two sums, n = 4.
    #[inline(always)]
    pub(super) fn error_along(&self, direction: [T; 3]) -> T {
        let [x, y, z] = direction.map(Lanes::abs);
        (x * self.reach(0) + y * self.reach(1) + z * self.reach(2)) * (margin(4) * UNIT) + UNDERFLOW
    }

    /// True where all corners are certainly farther than the gap from the plane through the origin with
    /// this normal, on the same side.
    #[inline(always)]
    pub(crate) fn is_beyond<G: Gap<T>>(&self, direction: [T; 3], gap: G) -> T::Mask {
        let limit = self.limit_along(direction, gap);
        let [first, rest @ ..] = self.along(direction);
        let (mut above, mut below) = (first.gt(limit), (-first).gt(limit));
        for value in rest {
            above = above & value.gt(limit);
            below = below & (-value).gt(limit);
        }
        above | below
    }

    /// The bound of scalar products, all errors included, that proves a distance above the gap.
    ///
    /// No component of the direction exceeds its length: the length times the error for the sum of the
    /// reaches bounds [`error_along`](Self::error_along). A sum of at least 2⁻⁹⁰⁰ keeps that error from
    /// underflow, however long the direction is. The length has five roundings, two products one each, the
    /// other factor four, and the sum the last: twelve.
    #[inline(always)]
    pub(super) fn limit_along<G: Gap<T>>(&self, direction: [T; 3], gap: G) -> T {
        const NORMAL: f64 = f64::from_bits((1023 - 900) << 52);
        if !G::IS_POSITIVE {
            return self.error_along(direction);
        }
        let [x, y, z] = self.reaches();
        let reach = (x + y + z).max(x.splat(NORMAL));
        let least = gap.value(x) + reach * (margin(4) * UNIT);
        least * (length_bound(direction) * (1.0 + margin(12) * UNIT)) + UNDERFLOW
    }
}

/// The least |x ± y| that proves a distance above d from a plane x = ±y, given the sum of the reaches of
/// both axes, or more.
///
/// The distance is |x ± y| / √2. With x and y rounded once, the sum once more, the sum is off by n = 2
/// roundings of |x| + |y|. `SQRT_2` is above √2. The other part has four roundings, and the product may be
/// subnormal. The limit is infinite if a component is, so that a sum that is not a number proves nothing.
#[inline(always)]
pub(crate) fn diagonal_limit<D: Lanes, T: Lanes + Add<D, Output = T>>(d: D, reaches: T) -> T {
    reaches * (margin(2) * UNIT) + (d * (SQRT_2 * (1.0 + margin(4) * UNIT)) + f64::MIN_POSITIVE)
}

impl Hull<f64> {
    /// Returns true if all corners are farther than the gap from the origin on an axis, on one side.
    /// Exact: rounding is monotone and the gap an f64, so that a difference that exceeds it when rounded
    /// exceeds it before, even when it overflows or is subnormal.
    #[inline]
    pub(super) fn is_beyond_axis(&self, gap: impl Gap<f64>) -> bool {
        let d = gap.value(0.0);
        (0..3).any(|axis| self.low[axis] > d || self.high[axis] < -d)
    }

    /// Returns true if all corners are farther than the gap from a plane x = ±y, y = ±z or z = ±x, on
    /// one side.
    ///
    /// Without a gap this is exact: a difference that is rounded has the sign of the exact one, even when it
    /// overflows or is subnormal. With one, [`diagonal_limit`] of the reaches of all axes is the
    /// bound, one for the three pairs.
    #[inline]
    pub(super) fn is_beyond_diagonal<G: Gap<f64>>(&self, gap: G) -> bool {
        let least = if G::IS_POSITIVE {
            let [x, y, z] = self.reaches();
            diagonal_limit(gap.value(0.0), x + y + z)
        } else {
            0.0
        };
        let is_beyond = |i: usize, j: usize| {
            let [x, y] = [&self.corners[i], &self.corners[j]];
            are_beyond(least, |corner| x[corner] - y[corner])
                || are_beyond(least, |corner| x[corner] + y[corner])
        };
        is_beyond(0, 1) || is_beyond(1, 2) || is_beyond(2, 0)
    }

    /// Returns true if Gilbert's iteration ([`approach_origin`]) finds a separating direction in a few steps.
    #[inline(never)]
    pub(super) fn some_direction_separates<K: Tables>(&self, gap: impl Gap<f64>) -> bool {
        let corner = |i: usize| [0, 1, 2].map(|axis: usize| self.corners[axis][i]);
        let (first, _) = lowest::<K>(|i| dot(corner(i), corner(i)));
        let lowest_along = |direction: Point| {
            let values = self.along(direction);
            let (lowest, value) = lowest::<K>(|i| values[i]);
            (corner(lowest), value)
        };
        let limit = |direction: Point| self.limit_along(direction, gap);
        approach_origin(corner(first), gap.value(0.0), lowest_along, limit).is_some()
    }
}

/// A direction along which all points of a hull are certainly farther than d from the origin, if Gilbert's
/// iteration (An iterative procedure for computing the minimum of a quadratic form on a convex set, 1966)
/// finds one in a few steps, given the lowest point along a direction and the limit that proves the distance.
///
/// It starts at the point next to the origin, and approaches the point of the hull next to it. Each point is
/// a direction. The next point is the point next to the origin in a triangle: the point, the lowest one
/// along it, and the lowest one before (Gilbert, Johnson and Keerthi 1988). If a point is within d, no
/// direction separates.
///
/// Any direction may be tried: one so long that a value is not finite has no finite limit, and proves
/// nothing.
#[inline(always)]
pub(super) fn approach_origin(
    start: Point,
    d: f64,
    lowest_along: impl Fn(Point) -> (Point, f64),
    limit: impl Fn(Point) -> f64,
) -> Option<Point> {
    const STEPS: usize = 5;
    let mut nearest = start;
    let mut last = nearest;
    for _ in 0..STEPS {
        let (lowest, value) = lowest_along(nearest);
        if value > limit(nearest) {
            return Some(nearest);
        }
        if dot(nearest, nearest) <= d * d {
            return None;
        }
        nearest = next_to_origin(nearest, lowest, last);
        last = lowest;
    }
    None
}

/// The corner with the lowest value, and that value. Where values are not a number, no limit is finite.
#[inline(always)]
fn lowest<K: Tables>(value_of: impl Fn(usize) -> f64) -> (usize, f64) {
    // The others are repeated.
    let corners = (1..8).filter(|i| i % 4 < K::FEATURES.vertices.len());
    corners.fold((0, value_of(0)), |lowest, i| {
        let value = value_of(i);
        if value < lowest.1 { (i, value) } else { lowest }
    })
}

/// A guess of the point next to the origin in the triangle x, a, b. x is the point next to the origin in a
/// segment that ends at b: x is orthogonal to it, or one of its ends.
#[inline(always)]
fn next_to_origin(x: Point, a: Point, b: Point) -> Point {
    let (u, v) = (minus(a, x), minus(b, x));
    let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
    let along = -dot(x, u);
    if uv < 0.0 {
        let determinant = uu * vv - uv * uv;
        if along * (vv - uv) < determinant {
            let scale = along / determinant;
            return towards(towards(x, u, scale * vv), v, -scale * uv);
        }
        let e = minus(b, a);
        return towards(a, e, (-dot(a, e) / dot(e, e)).clamp(0.0, 1.0));
    }
    towards(x, u, (along / uu).clamp(0.0, 1.0))
}

/// Returns true if all values are above a limit, or all below its opposite. The first one says which.
#[inline]
fn are_beyond(least: f64, value: impl Fn(usize) -> f64) -> bool {
    let first = value(0);
    if first > least {
        (1..8).all(|corner| value(corner) > least)
    } else {
        first < -least && (1..8).all(|corner| value(corner) < -least)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::filter::gap::{Touching, Within};
    use crate::tables::{EdgeEdge, VertexFace, VertexVertex};

    /// Points that move in small integers: the distances from the planes x = ±y, y = ±z and z = ±x are exact
    /// apart from a factor of √2, and none is near the gap.
    #[test]
    fn diagonals_prove_what_all_corners_have() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut proved = [0; 12];
        for _ in 0..20_000 {
            let mut corner = || [(); 3].map(|()| f64::from(random.i32(-8..=8)));
            let [start, end] = [corner(), corner()];
            let origin = [0.0; 3];
            let hull =
                Hull::new::<VertexVertex>(&[[start, start, origin, origin], [end, end, origin, origin]]);
            let sides = |[x, y, z]: Point| {
                [
                    x - y,
                    y - x,
                    x + y,
                    -x - y,
                    y - z,
                    z - y,
                    y + z,
                    -y - z,
                    z - x,
                    x - z,
                    z + x,
                    -z - x,
                ]
            };
            let both = sides(start).into_iter().zip(sides(end));
            let least = both
                .map(|(a, b)| a.min(b))
                .collect::<arrayvec::ArrayVec<f64, 12>>();
            for d in [0.0, 1.0, 2.0, 4.0] {
                let is_beyond = least.iter().any(|&side| side > d * SQRT_2);
                let found = if d == 0.0 {
                    hull.is_beyond_diagonal(Touching)
                } else {
                    hull.is_beyond_diagonal(Within(d))
                };
                assert_eq!(found, is_beyond, "{start:?} {end:?} {d}");
                if let Ok([side]) = <[usize; 1]>::try_from(
                    (0..12)
                        .filter(|&i| least[i] > d * SQRT_2)
                        .collect::<alloc::vec::Vec<_>>(),
                ) {
                    proved[side] += 1;
                }
            }
        }
        assert!(proved.iter().all(|&count| count > 10), "{proved:?}");
    }

    fn proves<K: Tables>(hull: &Hull<f64>, direction: Point, gap: impl Gap<f64>) -> bool {
        hull.is_beyond_axis(gap)
            || hull.is_beyond_diagonal(gap)
            || hull.is_beyond(direction, gap)
            || hull.some_direction_separates::<K>(gap)
    }

    /// One corner is beyond the origin, or at it, and all others are far on the other side.
    fn one_corner_prevents_proofs<K: Tables>() {
        for &((i, j), _) in K::FEATURES.vertices {
            for (end, axis) in (0..2).flat_map(|end| (0..3).map(move |axis| (end, axis))) {
                for (sign, value) in [(1.0, -2.0), (-1.0, -2.0), (1.0, 0.0), (-1.0, 0.0)] {
                    let mut points = [[[0.0; 3]; 4]; 2];
                    for (time, now) in points.iter_mut().enumerate() {
                        for (point, place) in now.iter_mut().enumerate() {
                            let is_near = time == end && (point == i || point == j);
                            place[axis] = sign
                                * match (point < K::CORNERS[0].1, is_near) {
                                    (true, false) => 6.0,
                                    (false, false) => -4.0,
                                    (true, true) => 0.0,
                                    (false, true) => -value,
                                };
                        }
                    }
                    let hull = Hull::new::<K>(&points);
                    let mut direction = [0.0; 3];
                    direction[axis] = 1.0;
                    assert!(!proves::<K>(&hull, direction, Touching), "{points:?}");
                    assert!(!proves::<K>(&hull, direction, Within(1.0)), "{points:?}");
                }
            }
        }
    }

    #[test]
    fn nothing_separates_if_one_corner_is_beyond_the_origin() {
        one_corner_prevents_proofs::<VertexFace>();
        one_corner_prevents_proofs::<EdgeEdge>();
    }

    #[test]
    fn each_axis_and_the_gap_have_a_range() {
        for axis in 0..3 {
            for far in [2.0 * LARGEST, -2.0 * LARGEST] {
                let mut points = [[[0.0; 3]; 4]; 2];
                points[1][0][axis] = far;
                let hull = Hull::new::<EdgeEdge>(&points);
                assert!(hull.is_out_of_range(Touching) && hull.is_out_of_range(Within(1.0)));
            }
        }
        let near = Hull::new::<EdgeEdge>(&[[[0.0; 3]; 4]; 2]);
        assert!(!near.is_out_of_range(Within(LARGEST)) && near.is_out_of_range(Within(2.0 * LARGEST)));
    }

    /// Corners next to the plane x = y, off it by about the roundings of their coordinates.
    #[test]
    fn diagonals_prove_nothing_by_roundings() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut proved = 0;
        for _ in 0..20_000 {
            let mut units = || random.i64(-(1 << 25)..=1 << 25);
            let off = [[units(), units()], [units(), units()]];
            let points: Points<f64> = [0, 1].map(|time: usize| {
                let s = [0.03125, -0.03125][time];
                let [x, y] = off[time].map(|n| libm::ldexp(n as f64, -80));
                [[s, s, 0.0], [s, s, 0.0], [x, y, 0.0], [x, y, 0.0]]
            });
            if Hull::new::<VertexVertex>(&points).is_beyond_diagonal(Within(libm::ldexp(1.0, -300))) {
                let [a, b] = off.map(|[x, y]| (y - x).signum());
                assert!(a != 0 && a == b, "{off:?}");
                proved += 1;
            }
        }
        assert!(proved > 100, "{proved}");
    }
}
