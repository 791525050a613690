//! The inflection point of a cubic, and polynomials on either side of it.

use std::cmp::Ordering;
use std::cmp::Ordering::{Equal, Greater, Less};

use super::number::{Signed, signs};

/// The root of the second derivative of a cubic.
pub(super) struct Inflection<N> {
    /// Positive multiples of t and 1 − t.
    division: [N; 2],
    /// The signs of the second derivative before and behind.
    pub(super) bends: [Ordering; 2],
}

impl<N: Signed> Inflection<N> {
    /// The root of a linear polynomial with these values at 0 and 1. `None` if its place is unknown,
    /// `Some(None)` if there is no root in [0, 1].
    ///
    /// If the sign of one value is open, the root may lie outside of [0, 1]. One of the parts then contains
    /// all of it.
    pub(super) fn new([a, b]: [N; 2]) -> Option<Option<Self>> {
        let bends = match signs([&a, &b])? {
            [Equal, after] => [after.reverse(), after],
            [before, Equal] => [before, before.reverse()],
            bends => bends,
        };
        let division = match (a.clone() - b.clone()).sign()? {
            Greater => [a, -b],
            Less => [-a, b],
            Equal => return Some(None),
        };
        Some((bends[0] != Equal).then_some(Self { division, bends }))
    }

    /// A polynomial in Bernstein form over both parts, up to a positive factor, by de Casteljau's algorithm.
    pub(super) fn split<const M: usize>(&self, mut row: [N; M]) -> [[N; M]; 2] {
        let [t, s] = &self.division;
        let sum = t.clone() + s.clone();
        let [mut before, mut after] = [row.clone(), row.clone()];
        for last in (1..M).rev() {
            for k in 0..last {
                row[k] = row[k].clone() * s.clone() + row[k + 1].clone() * t.clone();
            }
            // All coefficients get the factor `sum` in each round, also those that are final.
            for k in 0..M - last {
                before[k] = before[k].clone() * sum.clone();
                after[M - 1 - k] = after[M - 1 - k].clone() * sum.clone();
            }
            before[M - last] = row[0].clone();
            after[last - 1] = row[last - 1].clone();
        }
        [before, after]
    }
}
