//! Points.

/// A point in space.
pub type Point = [f64; 3];
