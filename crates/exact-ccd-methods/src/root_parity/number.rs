//! The numbers to compute with, and vectors of them.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use dashu_ratio::Relaxed;

use crate::interval::Interval;

/// The numbers of the predicates: intervals, expansions, or rational numbers.
pub(super) trait Number: Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// A finite number.
    fn exactly(x: f64) -> Self;

    /// The sign, if it is certain; of exact numbers it always is.
    fn certain_sign(&self) -> Option<Ordering>;
}

impl Number for Interval {
    fn exactly(x: f64) -> Self {
        Self::exactly(x)
    }

    fn certain_sign(&self) -> Option<Ordering> {
        self.sign()
    }
}

/// All denominators are powers of two, so that a search for other common factors is useless.
impl Number for Relaxed {
    fn exactly(x: f64) -> Self {
        Self::try_from(x).unwrap_or(Self::ZERO)
    }

    fn certain_sign(&self) -> Option<Ordering> {
        Some(self.cmp(&Self::ZERO))
    }
}

/// A vector.
pub(super) type Vector<N> = [N; 3];

/// The component of a × b along an axis.
pub(super) fn turn<N: Number>(axis: usize, a: &Vector<N>, b: &Vector<N>) -> N {
    let product = |i: usize, j: usize| a[(axis + i) % 3].clone() * b[(axis + j) % 3].clone();
    product(1, 2) - product(2, 1)
}

/// a · b.
pub(super) fn dot<N: Number>(a: &Vector<N>, b: &Vector<N>) -> N {
    let product = |axis: usize| a[axis].clone() * b[axis].clone();
    product(0) + product(1) + product(2)
}

/// a · (b × c).
pub(super) fn volume<N: Number>(a: &Vector<N>, b: &Vector<N>, c: &Vector<N>) -> N {
    dot(a, &[0, 1, 2].map(|axis| turn(axis, b, c)))
}
