//! Points.

/// A point in space.
pub type Point = [f64; 3];

/// x₀ … x₃ at t = 0 and at t = 1, with coordinates of any type.
pub(crate) type Points<T> = [[[T; 3]; 4]; 2];
