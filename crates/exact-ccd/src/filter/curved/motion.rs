//! The motion of a body in the coordinates of another one, in matrices.

use alloc::vec::Vec;

use super::polynomial::Polynomial;
use crate::numbers::number::Ring;

/// M, c and w: as polynomials, one coefficient of each, or their values at a time. The place of v in a body's
/// coordinates is (M v + c) / w.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion<T = f64> {
    pub(super) turn: [[T; 3]; 3],
    pub(super) shift: [T; 3],
    pub(super) weight: T,
}

/// One coefficient of each polynomial after the other.
pub(super) fn motions<T: Copy>(motion: &Motion<Polynomial<T>>) -> Vec<Motion<T>> {
    let at = |polynomial: &Polynomial<T>, k: usize| polynomial[k];
    let degrees = 0..motion.weight.len();
    degrees
        .map(|k| Motion {
            turn: motion.turn.each_ref().map(|row| row.each_ref().map(|p| at(p, k))),
            shift: motion.shift.each_ref().map(|p| at(p, k)),
            weight: motion.weight[k],
        })
        .collect()
}

/// The roundings that [`difference`] adds to M's: a product and four sums.
pub(super) const OF_TURN: u32 = 5;

/// The roundings that [`difference`] adds to c's and w's: two sums, or a product and a sum.
pub(super) const OF_OTHERS: u32 = 2;

/// M v + c − w x: a point of the first body minus one of the second one, times w.
#[inline(always)]
pub(super) fn difference<T: Ring>(motion: &Motion<T>, v: [T; 3], x: [T; 3]) -> [T; 3] {
    let component = |axis: usize| {
        let [a, b, c] = motion.turn[axis];
        a * v[0] + b * v[1] + c * v[2] + motion.shift[axis] - motion.weight * x[axis]
    };
    [component(0), component(1), component(2)]
}
