//! An answer with its cost.

/// The answer to a query, and the time that it took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Timed {
    /// True if the primitives touch, according to the method.
    pub(super) collides: bool,
    /// The time of impact, from a method that has times.
    pub(super) time: Option<f64>,
    pub(super) nanoseconds: f64,
}
