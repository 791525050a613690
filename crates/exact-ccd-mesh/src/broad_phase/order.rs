//! An order of points in which neighbours are near each other.

use exact_ccd::Point;
use rayon::prelude::*;

use super::aabb::Aabb;

/// The number of bits of a key for each axis.
const BITS: u32 = 12;

/// Up to this number, points with the same key are not ordered further.
const SMALL: usize = 8;

/// The indices of some points along a curve that fills their box: D. Hilbert, *Über die stetige
/// Abbildung einer Linie auf ein Flächenstück*, 1891.
///
/// If many points fall into one cell of the curve, these are ordered along another curve. So
/// points that are far away from all others cost a few more rounds, each with cells 2¹² times as
/// small.
pub(crate) fn order(points: &[Point], ids: Vec<u32>) -> Vec<u32> {
    let mut keyed: Vec<(u64, u32)> = ids.into_iter().map(|id| (0, id)).collect();
    sort(points, &mut keyed);
    keyed.into_iter().map(|(_, id)| id).collect()
}

/// The length of the path through the points in an order, in the maximum norm.
pub(crate) fn extent(points: &[Point], order: &[u32]) -> f64 {
    let part = |pair: &[u32]| {
        let [a, b] = [pair[0], pair[1]].map(|id| points[id as usize]);
        (0..3).fold(0.0, |most: f64, axis| most.max((a[axis] - b[axis]).abs()))
    };
    order.windows(2).map(part).sum()
}

fn sort(points: &[Point], keyed: &mut [(u64, u32)]) {
    let Aabb { lower, upper } = keyed.iter().map(|&(_, id)| points[id as usize]).collect::<Aabb>();
    // Halved, because a difference may overflow.
    let extent = (0..3).fold(0.0, |most: f64, k| most.max(0.5 * upper[k] - 0.5 * lower[k]));
    if extent.is_nan() || extent <= 0.0 {
        return;
    }
    let scale = f64::from(1u32 << (BITS - 1)) / extent;
    let largest = (1 << BITS) - 1;
    keyed.par_iter_mut().for_each(|(key, id)| {
        let point = points[*id as usize];
        // The conversion saturates, and NaN, of an extent that underflows, becomes 0.
        let cell = |k: usize| (((0.5 * point[k] - 0.5 * lower[k]) * scale * 2.0) as u32).min(largest);
        let [x, y, z] = along_hilbert([cell(0), cell(1), cell(2)]);
        *key = spread(x) << 2 | spread(y) << 1 | spread(z);
    });
    keyed.par_sort_unstable();
    let count = keyed.len();
    for run in keyed.chunk_by_mut(|(a, _), (b, _)| a == b) {
        // Threads that round subnormal numbers differently may put all points into one cell.
        if run.len() > SMALL && run.len() < count {
            sort(points, run);
        }
    }
}

/// The bits of a cell's place along Hilbert's curve, distributed over the axes: J. Skilling,
/// *Programming the Hilbert curve*, 2004.
fn along_hilbert(mut cell: [u32; 3]) -> [u32; 3] {
    for level in (1..BITS).rev() {
        let below = (1 << level) - 1;
        for axis in 0..3 {
            // If the bit is set, the lower bits of the first axis are flipped; if not, they are
            // swapped with those of this axis.
            let is_set = (cell[axis] >> level & 1).wrapping_neg();
            cell[0] ^= below & is_set;
            let swap = (cell[0] ^ cell[axis]) & below & !is_set;
            cell[0] ^= swap;
            cell[axis] ^= swap;
        }
    }
    // Gray code.
    cell[1] ^= cell[0];
    cell[2] ^= cell[1];
    let mut flip = 0;
    for level in 1..BITS {
        flip ^= ((1 << level) - 1) & (cell[2] >> level & 1).wrapping_neg();
    }
    cell.map(|bits| bits ^ flip)
}

/// The bits, at most 21 of them, with two zeros between any two.
fn spread(bits: u32) -> u64 {
    let bits = u64::from(bits);
    let bits = (bits | bits << 32) & 0x001f_0000_0000_ffff;
    let bits = (bits | bits << 16) & 0x001f_0000_ff00_00ff;
    let bits = (bits | bits << 8) & 0x100f_00f0_0f00_f00f;
    let bits = (bits | bits << 4) & 0x10c3_0c30_c30c_30c3;
    (bits | bits << 2) & 0x1249_2492_4924_9249
}
