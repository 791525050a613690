//! Iterations of Newton's method, for displays of progress.

/// An iteration of Newton's method in a time step that is not complete.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Iteration {
    /// The number of the time step, from 1.
    pub step: u64,
    /// The part of the time step, from 1, and the number of equal parts: 1, unless the time step is repeated
    /// in parts.
    pub part: [usize; 2],
    /// The number of the iteration in the part, from 1, over all friction lags.
    pub iteration: usize,
    /// The largest component of the Newton direction by time, in m/s.
    pub residual: f64,
    /// The residual at which Newton's method stops if the predicted decrease of energy is small too, in m/s.
    pub tolerance: f64,
    /// The pairs of features within the contact distance before the iteration.
    pub contacts: usize,
}

/// A function that is called in each iteration.
pub(crate) type Watch = dyn Fn(&Iteration) + Send + Sync;
