//! The numbers to compute with.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use dashu_int::IBig;

use crate::interval::Interval;

/// The numbers of the predicates: f64 with an error bound, intervals, expansions, or integers.
pub(super) trait Signed: Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// The sign, if it is certain; of exact numbers it always is.
    fn certain_sign(&self) -> Option<Ordering>;
}

impl Signed for Interval {
    fn certain_sign(&self) -> Option<Ordering> {
        self.sign()
    }
}

impl Signed for IBig {
    fn certain_sign(&self) -> Option<Ordering> {
        Some(self.cmp(&Self::ZERO))
    }
}
