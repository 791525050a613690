//! F at the corners of its domain, and what its hull proves at once.

use core::f64::consts::SQRT_2;

use crate::filter::{Lanes, UNIT, scaled};
use crate::kind::Kind;
use crate::point::Point;
use crate::query::Query;

/// 2⁻²⁰⁰: the least scaled distance that the filters compute with.
const LEAST: f64 = f64::from_bits((1023 - 200) << 52);

/// F at the corners of its domain of (u, v), at t = 0 and at t = 1, each component rounded once.
pub(super) struct Corners {
    pub(super) at: [[Point; 4]; 2],
    /// The largest magnitude of a component on each axis.
    reach: Point,
}

impl Corners {
    #[inline]
    pub(super) fn new<K: Kind>(query: &Query<K>) -> Self {
        let mut at = [[[0.0; 3]; 4]; 2];
        let mut reach = [0.0; 3];
        for (corners, points) in at.iter_mut().zip(query.points()) {
            for (corner, (i, j)) in corners.iter_mut().zip(K::CORNERS) {
                for axis in 0..3 {
                    let x = points[i][axis] - points[j][axis];
                    corner[axis] = x;
                    reach[axis] = if x.abs() > reach[axis] {
                        x.abs()
                    } else {
                        reach[axis]
                    };
                }
            }
        }
        Self { at, reach }
    }

    /// True if all components on an axis are above d, or below −d. Exact: rounding is monotone and
    /// d an f64, so that a difference that exceeds d when rounded exceeds it before.
    #[inline]
    pub(super) fn are_beyond_axis(&self, d: f64) -> bool {
        (0..3).any(|axis| {
            let on_axis = || self.at.as_flattened().iter().map(|corner| corner[axis]);
            on_axis().all(|x| x > d) || on_axis().all(|x| x < -d)
        })
    }

    /// True if all corners are farther than d from a plane x = ±y, y = ±z or z = ±x, on one side.
    ///
    /// The distance from the plane is |x ± y| / √2. With x and y rounded once, the sum once more,
    /// it is off by at most 2 u (|x| + |y|) (1 + u); `SQRT_2` is above √2.
    #[inline]
    pub(super) fn are_beyond_diagonal(&self, d: f64) -> bool {
        for [i, j] in [[0, 1], [1, 2], [2, 0]] {
            let slack = 8.0 * UNIT * (self.reach[i] + self.reach[j]);
            // Infinite if a component is, so that a sum that is not a number proves nothing.
            let least = (d * SQRT_2 + slack).next_up().next_up();
            let ([mut low, mut high], [mut lowest, mut highest]) = (
                [f64::INFINITY, f64::NEG_INFINITY],
                [f64::INFINITY, f64::NEG_INFINITY],
            );
            for corner in self.at.as_flattened() {
                let (sum, difference) = (corner[i] + corner[j], corner[i] - corner[j]);
                low = Lanes::min(sum, low);
                high = Lanes::max(sum, high);
                lowest = Lanes::min(difference, lowest);
                highest = Lanes::max(difference, highest);
            }
            if low > least || high < -least || lowest > least || highest < -least {
                return true;
            }
        }
        false
    }

    /// The corners and d, scaled by a power of two; `None` if they are out of range.
    pub(super) fn scaled(&self, d: f64) -> Option<Scaled> {
        const RANGE: i64 = 1000;
        let reach = self
            .reach
            .into_iter()
            .fold(0.0, |a: f64, b| if b > a { b } else { a });
        let exponent = (reach.to_bits() >> 52) as i64 - 1022;
        if !(-RANGE..=RANGE).contains(&exponent) {
            return None;
        }
        let factor = f64::from_bits(((1023 - exponent) as u64) << 52);
        let d = d * factor;
        let mut at = self.at;
        for corner in at.as_flattened_mut() {
            *corner = scaled(*corner, factor);
        }
        Some(Scaled {
            factor,
            at,
            reach: scaled(self.reach, factor),
            d: if d < LEAST { LEAST } else { d },
            d_is_exact: d >= LEAST,
        })
    }
}

/// Corners scaled so that the largest component is in [1/2, 1).
///
/// Scaling is exact, except that it may be off by 2⁻¹⁰⁷⁵ where the result is subnormal.
pub(super) struct Scaled {
    pub(super) factor: f64,
    pub(super) at: [[Point; 4]; 2],
    /// The largest magnitude of a component on each axis.
    pub(super) reach: Point,
    /// d, scaled, or more if that is tiny.
    pub(super) d: f64,
    pub(super) d_is_exact: bool,
}
