//! Errors of a search.

use exact_ccd::{NonFinite, TimeOutOfStep, environment};

/// The reason why a search has no answer.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SearchError {
    /// A trajectory has a position that is not finite.
    #[error("in the chord for the times from {start} to {end}, {source}")]
    Position {
        /// The start of the chord.
        start: f64,
        /// The end of the chord.
        end: f64,
        /// The coordinate, and the index of the point in its query.
        source: NonFinite,
    },
    /// A trajectory has a bound that is NaN or negative.
    #[error(
        "point {point} has an error or a deviation that is negative or NaN, for the times from {start} to {end}"
    )]
    Bound {
        /// The index of the point in its query.
        point: usize,
        /// The start of the chord.
        start: f64,
        /// The end of the chord.
        end: f64,
    },
    /// The tolerance of times is negative or NaN.
    #[error("the tolerance of times is {0}, expected a number of at least 0")]
    Tolerance(f64),
    /// The last time that counts is not in [0, 1].
    #[error(transparent)]
    Time(#[from] TimeOutOfStep),
    /// The thread, or one of the threads of a step, has another floating-point
    /// [environment](exact_ccd::environment) than the default one, so that no bound of an error holds.
    #[error(
        "a thread rounds in another direction than to nearest, or flushes subnormal numbers to zero (FTZ, DAZ): \
         restore the default floating-point environment"
    )]
    Environment,
}

impl SearchError {
    /// Checks the environment of the thread that computes.
    pub(crate) fn check_environment() -> Result<(), Self> {
        environment::is_default().then_some(()).ok_or(Self::Environment)
    }
}
