//! The first two filters, [`Stage::BoundingBox`](crate::Stage::BoundingBox) and
//! [`Stage::Diagonals`](crate::Stage::Diagonals): one query at a time, the coordinates of both
//! times side by side.
//!
//! Both only compare differences of coordinates, place by place, so that no transposition is needed.

use fearless_simd::f64x8;
use fearless_simd::prelude::*;

use super::row::{PLACES, Row};
use crate::kind::Kind;

/// Returns true if a plane x = 0, y = 0 or z = 0, or one at 45° between two of them, separates the
/// primitives.
#[inline(always)]
pub(super) fn are_separated<S: Simd, K: Kind>(simd: S, [a, b, c, d]: [&Row; 4]) -> bool {
    let points = [a, b, c, d].map(
        #[inline(always)]
        |row| f64x8::from_slice(simd, &row.0),
    );
    let zero = f64x8::splat(simd, 0.0);
    let corner = |index: usize| {
        let (i, j) = K::CORNERS[index];
        points[i] - points[j]
    };
    let d = corner(0);
    let mut above = d.simd_gt(zero);
    let mut below = d.simd_lt(zero);
    for index in 1..4 {
        let d = corner(index);
        above &= d.simd_gt(zero);
        below &= d.simd_lt(zero);
    }
    if is_certain(above.to_bitmask()) | is_certain(below.to_bitmask()) {
        return true;
    }
    let next = d.slide::<1>(d);
    let mut sides = [
        d.simd_gt(next),
        d.simd_lt(next),
        d.simd_gt(-next),
        d.simd_lt(-next),
    ];
    for index in 1..4 {
        let d = corner(index);
        let next = d.slide::<1>(d);
        sides[0] &= d.simd_gt(next);
        sides[1] &= d.simd_lt(next);
        sides[2] &= d.simd_gt(-next);
        sides[3] &= d.simd_lt(-next);
    }
    let [a, b, c, d] = sides;
    is_certain(a.to_bitmask())
        | is_certain(b.to_bitmask())
        | is_certain(c.to_bitmask())
        | is_certain(d.to_bitmask())
}

/// Returns true if a place is set for both times.
#[inline(always)]
fn is_certain(places: u64) -> bool {
    places & (places >> 4) & PLACES != 0
}
