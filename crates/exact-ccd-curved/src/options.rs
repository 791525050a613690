//! Options of a search.

use exact_ccd::{Separation, TimeOutOfStep};

use crate::error::SearchError;

/// The end of a search: its tolerances and its limit.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SearchOptions {
    /// A part of the step. The search ends when the gap between the time until which the distance
    /// is certainly above d and the time by which it is certainly at most d + ε is at most this.
    /// Less than 2⁻⁵⁰ counts as 2⁻⁵⁰. The default is 0.
    pub time_tolerance: f64,
    /// ε, in the unit of the coordinates. The default is 0: contact itself has to be proved. That
    /// is not possible where the primitives only touch, and for contact (d = 0) of a vertex with an
    /// edge or a vertex.
    pub distance_tolerance: Separation,
    /// The largest number of chords for two primitives. The default is 1000.
    pub chord_limit: usize,
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self {
            time_tolerance: 0.0,
            distance_tolerance: Separation::default(),
            chord_limit: 1000,
        }
    }
}

impl SearchOptions {
    /// The same options with another tolerance of times.
    #[must_use]
    pub fn with_time_tolerance(self, time_tolerance: f64) -> Self {
        Self {
            time_tolerance,
            ..self
        }
    }

    /// The same options with another tolerance of distances.
    #[must_use]
    pub fn with_distance_tolerance(self, distance_tolerance: Separation) -> Self {
        Self {
            distance_tolerance,
            ..self
        }
    }

    /// The same options with another limit of the number of chords.
    #[must_use]
    pub fn with_chord_limit(self, chord_limit: usize) -> Self {
        Self { chord_limit, ..self }
    }

    /// Checks the tolerance of times, the last time that counts, and the environment of the thread.
    pub(crate) fn check(&self, until: f64) -> Result<(), SearchError> {
        TimeOutOfStep::check(until)?;
        if self.time_tolerance.is_nan() || self.time_tolerance < 0.0 {
            return Err(SearchError::Tolerance(self.time_tolerance));
        }
        SearchError::check_environment()
    }
}
