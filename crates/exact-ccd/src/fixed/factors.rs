//! Linear functions that divide the coplanarity cubic.

use core::array::from_fn;

use arrayvec::ArrayVec;

use super::fraction::Fraction;
use super::length::Length;
use crate::tables::{Difference, Points};

/// A difference of two points at t = 0 and at t = 1.
pub(super) type Ends<L> = [[L; 3]; 2];

#[inline(always)]
pub(super) fn difference<L: Length>(points: &Points<L>, (i, j): Difference) -> Ends<L> {
    points
        .each_ref()
        .map(|end| from_fn(|axis| end[i][axis] - end[j][axis]))
}

/// The linear functions with a zero inside the step that divide an axis or a row of the matrix whose
/// determinant is the cubic, and what is left without them.
///
/// The rows are the differences of three pairs of points that connect all four: other ones change at most the
/// sign of the determinant. If all numbers of an axis or of a row are multiples of a linear function f, the
/// determinant is, at all times, f / f(0) times the determinant with their values at t = 0. The zeros of
/// the functions have many digits, and are often double or triple roots, or next to other ones.
///
/// Three differences that form a cycle have no third factor: if f u + g v = h w for linear functions f, g, h
/// and vectors u, v, w, then f, g and h have the same zero, or u and v are multiples of w and the determinant
/// is zero.
pub(super) struct Factors<L> {
    /// The points, at rest along each axis that has a factor. All points have the same coordinate there once.
    /// Contact is invariant under the scaling of an axis, by another number at each time, too. So at all
    /// other times, the primitives touch exactly if they do with these points.
    pub(super) at_rest: Points<L>,
    /// The rows without their factors. Two points whose difference has a factor coincide at one time.
    pub(super) rows: [Ends<L>; 3],
    /// The zeros of the factors, if the cubic is not zero at all times: it has at most three.
    pub(super) zeros: ArrayVec<Fraction, 3>,
}

impl<L: Length> Factors<L> {
    pub(super) fn new(points: &Points<L>) -> Self {
        const PAIRS: [Difference; 6] = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
        let mut at_rest = *points;
        let mut zeros = ArrayVec::new();
        for axis in 0..3 {
            let since_first = |i: usize| points.map(|end| end[i][axis] - end[0][axis]);
            if let Some(zero) = common_zero([1, 2, 3].map(since_first)) {
                let [start, end] = &mut at_rest;
                for (end, start) in end.iter_mut().zip(start) {
                    end[axis] = start[axis];
                }
                // With more than three factors, the determinant is zero.
                let _ = zeros.try_push(zero);
            }
        }
        let mut rows = ArrayVec::<_, 3>::new();
        let mut tree = Tree::default();
        for pair in PAIRS {
            let [start, end] = difference(&at_rest, pair);
            if let Some(zero) = common_zero(from_fn(|axis| [start[axis], end[axis]]))
                && tree.connect(pair)
            {
                rows.push([start; 2]);
                let _ = zeros.try_push(zero);
            }
        }
        for pair in PAIRS {
            if tree.connect(pair) {
                rows.push(difference(&at_rest, pair));
            }
        }
        let rows = rows.into_inner().unwrap_or([[[L::default(); 3]; 2]; 3]);
        Self { at_rest, rows, zeros }
    }
}

/// The time inside the step at which numbers vanish that are multiples of one linear function, if it is not
/// too long; `None` if all are zero.
fn common_zero<L: Length>(numbers: [[L; 2]; 3]) -> Option<Fraction> {
    let [start, end] = *numbers.iter().find(|ends| **ends != [L::default(); 2])?;
    let zero = Fraction::zero_of(start.into(), end.into())?;
    let is_multiple = |[a, b]: &[L; 2]| a.times(end) == b.times(start);
    numbers.iter().all(is_multiple).then_some(zero)
}

/// Pairs of points without a cycle. For each point, the least one that it is connected with.
struct Tree([usize; 4]);

impl Default for Tree {
    fn default() -> Self {
        Self([0, 1, 2, 3])
    }
}

impl Tree {
    /// Adds a pair; returns false if its points are connected already.
    fn connect(&mut self, (i, j): Difference) -> bool {
        let [low, high] = [self.0[i].min(self.0[j]), self.0[i].max(self.0[j])];
        for least in &mut self.0 {
            if *least == high {
                *least = low;
            }
        }
        low != high
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;

    /// The determinant of three rows at the time at which b of a + b parts have elapsed, times (a + b)³.
    fn determinant(rows: &[Ends<i64>; 3], [a, b]: [i128; 2]) -> i128 {
        let [u, v, w] = rows.map(|[start, end]| {
            from_fn::<i128, 3, _>(|axis| a * i128::from(start[axis]) + b * i128::from(end[axis]))
        });
        let minor = |i: usize, j: usize| v[i] * w[j] - v[j] * w[i];
        u[0] * minor(1, 2) + u[1] * minor(2, 0) + u[2] * minor(0, 1)
    }

    /// Mirrored points of few coordinates. Many coordinates are multiples of the same linear functions.
    fn mirrored(random: &mut fastrand::Rng) -> Points<i64> {
        let functions = [(); 4].map(|()| [random.i64(1..5), -random.i64(1..5)]);
        let coordinates = [(); 12].map(|()| {
            let multiple = random.i64(-1..=1);
            functions[random.usize(..4)].map(|end| multiple * end)
        });
        [0, 1].map(|time: usize| from_fn(|point| from_fn(|axis| coordinates[3 * point + axis][time])))
    }

    #[test]
    fn the_cubic_is_the_product_of_its_factors_and_the_rest() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut counts = [0; 4];
        for _ in 0..20_000 {
            let points = mirrored(&mut random);
            let factors = Factors::new(&points);
            let span = [1, 2, 3].map(|i| difference(&points, (i, 0)));
            let is_zero = |rows: &[Ends<i64>; 3]| (1..5).all(|b| determinant(rows, [3, b]) == 0);
            assert_eq!(is_zero(&span), is_zero(&factors.rows), "{points:?}");
            if is_zero(&span) {
                continue;
            }
            counts[factors.zeros.len()] += 1;
            let mut signs = Vec::new();
            for [a, b] in [[1, 0], [3, 1], [2, 5], [1, 7], [0, 1]] {
                let (mut cubic, mut product) =
                    (determinant(&span, [a, b]), determinant(&factors.rows, [a, b]));
                for zero in &factors.zeros {
                    // f = e (1 − t) − l t, and f(0) = e.
                    let [l, e] = zero.weights().map(i128::from);
                    cubic *= e * (a + b);
                    product *= e * a - l * b;
                }
                assert_eq!(cubic.abs(), product.abs(), "{points:?}");
                signs.push(cubic.signum() * product.signum());
            }
            signs.retain(|&sign| sign != 0);
            assert!(signs.windows(2).all(|pair| pair[0] == pair[1]), "{points:?}");
        }
        assert!(counts.iter().all(|&count| count > 100), "{counts:?}");
    }

    #[test]
    fn pairs_connect_points_without_a_cycle() {
        let mut tree = Tree::default();
        let pairs = [(0, 3), (1, 2), (0, 3), (2, 3), (0, 1), (1, 3), (0, 2)];
        assert_eq!(
            pairs.map(|pair| tree.connect(pair)),
            [true, true, false, true, false, false, false]
        );
    }
}
