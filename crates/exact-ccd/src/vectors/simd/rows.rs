//! The first two filters, [`Stage::BoundingBox`](crate::Stage::BoundingBox) and
//! [`Stage::Diagonals`](crate::Stage::Diagonals): one query at a time, the coordinates of both
//! times side by side.
//!
//! Both only compare differences of coordinates, place by place, so that no transposition is needed.

use fearless_simd::prelude::*;
use fearless_simd::{f64x8, mask64x8};

use crate::filter::{Gap, diagonal_limit};
use crate::tables::Tables;
use crate::vectors::row::{PLACES, Row};

/// Returns true if all corners are farther than the gap from a plane x = 0, y = 0 or z = 0, or from one at
/// 45° between two of them, on one side.
///
/// [`diagonal_limit`] has the bound. Without a gap, x and ±y are only compared.
#[inline(always)]
pub(super) fn are_beyond<S: Simd, K: Tables, G: Gap<f64>>(simd: S, rows: [&Row; 4], gap: G) -> bool {
    let corners = corners::<S, K>(simd, rows);
    let d = gap.value(0.0);
    if are_beyond_axis(corners, f64x8::splat(simd, d)) {
        return true;
    }
    if !G::IS_POSITIVE {
        return on_one_side(
            corners,
            #[inline(always)]
            |x, next| {
                [
                    x.simd_gt(next),
                    x.simd_lt(next),
                    x.simd_gt(-next),
                    x.simd_lt(-next),
                ]
            },
        );
    }
    let [a, b, c, e] = corners;
    let reach = a.abs().max(b.abs()).max(c.abs().max(e.abs()));
    let least = diagonal_limit(d, reach + reach.slide::<1>(reach));
    on_one_side(
        corners,
        #[inline(always)]
        |x, next| {
            let (sum, difference) = (x + next, x - next);
            [
                difference.simd_gt(least),
                (-difference).simd_gt(least),
                sum.simd_gt(least),
                (-sum).simd_gt(least),
            ]
        },
    )
}

#[inline(always)]
fn corners<S: Simd, K: Tables>(simd: S, rows: [&Row; 4]) -> [f64x8<S>; 4] {
    let points = rows.map(
        #[inline(always)]
        |row| f64x8::from_slice(simd, &row.0),
    );
    let corner = |index: usize| {
        let (i, j) = K::CORNERS[index];
        points[i] - points[j]
    };
    [corner(0), corner(1), corner(2), corner(3)]
}

/// Returns true if all components on an axis are above d, or below −d. Exact: rounding is monotone and
/// d an f64, so that a difference that exceeds d when rounded exceeds it before.
#[inline(always)]
fn are_beyond_axis<S: Simd>([first, rest @ ..]: [f64x8<S>; 4], d: f64x8<S>) -> bool {
    let (mut above, mut below) = (first.simd_gt(d), first.simd_lt(-d));
    for corner in rest {
        above &= corner.simd_gt(d);
        below &= corner.simd_lt(-d);
    }
    is_certain(above.to_bitmask()) | is_certain(below.to_bitmask())
}

/// Returns true if all corners are on the same of four sides, of a plane through the next axis.
#[inline(always)]
fn on_one_side<S: Simd>(
    [first, rest @ ..]: [f64x8<S>; 4],
    sides_of: impl Fn(f64x8<S>, f64x8<S>) -> [mask64x8<S>; 4],
) -> bool {
    let [mut a, mut b, mut c, mut d] = sides_of(first, first.slide::<1>(first));
    for corner in rest {
        let [more_a, more_b, more_c, more_d] = sides_of(corner, corner.slide::<1>(corner));
        a &= more_a;
        b &= more_b;
        c &= more_c;
        d &= more_d;
    }
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
