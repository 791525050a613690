//! The numbers to compute with, and vectors of them.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use dashu_int::IBig;

use crate::interval::Interval;

/// The numbers of the predicates: f64 with an error bound, intervals, expansions, or integers.
pub(super) trait Number: Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// The sign, if it is certain; of exact numbers it always is.
    fn certain_sign(&self) -> Option<Ordering>;
}

impl Number for Interval {
    fn certain_sign(&self) -> Option<Ordering> {
        self.sign()
    }
}

impl Number for IBig {
    fn certain_sign(&self) -> Option<Ordering> {
        Some(self.cmp(&Self::ZERO))
    }
}

/// A vector.
pub(super) type Vector<N> = [N; 3];

/// The component of a × b along an axis.
#[inline]
pub(super) fn turn<N: Number>(axis: usize, a: &Vector<N>, b: &Vector<N>) -> N {
    let product = |i: usize, j: usize| a[(axis + i) % 3].clone() * b[(axis + j) % 3].clone();
    product(1, 2) - product(2, 1)
}

/// a · b.
#[inline]
pub(super) fn dot<N: Number>(a: &Vector<N>, b: &Vector<N>) -> N {
    let product = |axis: usize| a[axis].clone() * b[axis].clone();
    product(0) + product(1) + product(2)
}

/// a · (b × c).
#[inline]
pub(super) fn volume<N: Number>(a: &Vector<N>, b: &Vector<N>, c: &Vector<N>) -> N {
    dot(a, &[0, 1, 2].map(|axis| turn(axis, b, c)))
}
