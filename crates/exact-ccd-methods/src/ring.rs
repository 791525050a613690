//! The operations that all numbers have.

use std::ops::{Add, Mul, Sub};

/// Numbers with sums, differences and products.
pub(crate) trait Ring: Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {}

impl<N: Clone + Add<Output = N> + Sub<Output = N> + Mul<Output = N>> Ring for N {}
