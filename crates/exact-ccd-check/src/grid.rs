//! Positions at two times, rounded down to a grid of 64-bit integers.
//!
//! Let X be the rounded coordinate and x the exact one, in units of the grid: X ≤ x < X + 1. Most
//! proofs need no more than X. For integers g, not all 0, let |g| be the sum of their absolute values,
//! and consider vertices i and j: g · (x_i − x_j) > g · (X_i − X_j) − |g|, because each of the
//! fractions that rounding took away is in [0, 1), so that the difference of two is strictly between −1
//! and 1. If the right side is at least d times the length of g, the vertices are more than d apart
//! along g.

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use crate::mesh::Pair;
use crate::motion::{Motion, Point, Time};

/// The bits of a coordinate on the grid.
const BITS: usize = 60;

/// The positions at t = 0 and at t = T, rounded down, and the distance, rounded up.
pub struct Grid {
    /// The positions.
    pub(crate) at: [Vec<[i64; 3]>; 2],
    /// The distance: at most 2^62, which is more than any difference of two coordinates.
    pub(crate) distance: i64,
}

impl Grid {
    /// The grid of a motion up to a time T.
    pub fn new(motion: &Motion, until: f64) -> Self {
        let times = Time::together([0.0, until]);
        let power = times[0].power;
        let vertices = 0..motion.ends[0].len() as u32;
        let exact =
            times.map(|time| vertices.clone().map(|vertex| motion.at(vertex, &time)).collect::<Vec<_>>());
        let bits = exact.iter().flatten().flatten().map(BitTest::bit_len).max().unwrap_or(0);
        let rounded = |x: &IBig| {
            if bits > BITS { x >> (bits - BITS) } else { x << (BITS - bits) }
        };
        let small = |x: &IBig| i64::try_from(rounded(x)).unwrap_or(i64::MAX);
        let distance = -rounded(&-(&motion.distance << power));
        let at = exact.map(|points| points.iter().map(|point| point.each_ref().map(small)).collect());
        Self { at, distance: i64::try_from(distance).unwrap_or(i64::MAX).min(1 << 62) }
    }

    /// Returns true if the grid proves that the first primitive of a pair is beyond the second along a
    /// direction, by more than the distance, at these ends of the motion. If it is at t = 0 and at t =
    /// T, it is at all times between, as g · x is linear.
    ///
    /// No sum overflows: coordinates are at most 2^60 in magnitude, components of g below 2^48.
    pub fn separates(&self, pair: &Pair<'_>, g: &Point, ends: &[usize]) -> bool {
        let g = g.each_ref().map(|component| i64::try_from(component).unwrap_or(i64::MAX));
        if g == [0; 3] || g.iter().any(|&component| component.unsigned_abs() >= 1 << 48) {
            return false;
        }
        let g = g.map(i128::from);
        let sum: i128 = g.iter().map(|component| component.abs()).sum();
        let length = || g.iter().map(|component| component * component).sum::<i128>().isqrt() + 1;
        let has_distance = pair.has_distance && self.distance > 0;
        let needed = sum + if has_distance { i128::from(self.distance) * length() } else { 0 };
        ends.iter().all(|&end| {
            let along = |vertex: &u32| {
                let [x, y, z] = self.at[end][*vertex as usize].map(i128::from);
                g[0] * x + g[1] * y + g[2] * z
            };
            let least = pair.first.iter().map(along).min();
            let most = pair.second.iter().map(along).max();
            least.zip(most).is_some_and(|(least, most)| least - most >= needed)
        })
    }
}
