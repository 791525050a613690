//! Options of a step that is certified to be free of contact.

use std::fmt;

use super::error::LineSearchError;
use super::precision::Precision;
use crate::pairs::MinDistance;
use crate::steps::Step;

/// Options of [`Detector::free_step`](crate::Detector::free_step), and of the other free steps.
#[derive(Clone)]
#[non_exhaustive]
pub struct FreeStepOptions<'a> {
    /// The fraction of the time of impact that is kept: above 0 and at most 1. The default is 0.9.
    /// With 1, the step ends as near to the contact as rounding permits.
    pub keep: f64,
    /// The distance at which primitives touch. The default is 0, which is contact.
    pub min_distance: MinDistance,
    /// The format of the positions at the end. The default is double precision.
    pub precision: Precision,
    /// Called with the number of pairs examined since the last call, from any thread. Pairs that the first
    /// filters hold back do not count; these depend on the processor.
    pub progress: Option<&'a (dyn Fn(usize) + Sync)>,
    /// Called between batches of pairs, from any thread; true cancels the search.
    pub cancel: Option<&'a (dyn Fn() -> bool + Sync)>,
}

impl Default for FreeStepOptions<'_> {
    fn default() -> Self {
        Self {
            keep: 0.9,
            min_distance: MinDistance::default(),
            precision: Precision::default(),
            progress: None,
            cancel: None,
        }
    }
}

impl<'a> FreeStepOptions<'a> {
    /// The same options with another fraction of the time of impact to keep.
    #[must_use]
    pub fn with_keep(self, keep: f64) -> Self {
        Self { keep, ..self }
    }

    /// The same options with another distance at which primitives touch.
    #[must_use]
    pub fn with_min_distance(self, min_distance: impl Into<MinDistance>) -> Self {
        let min_distance = min_distance.into();
        Self { min_distance, ..self }
    }

    /// The same options with another format of the positions at the end.
    #[must_use]
    pub fn with_precision(self, precision: Precision) -> Self {
        Self { precision, ..self }
    }

    /// The same options with a callback for progress.
    #[must_use]
    pub fn with_progress(self, progress: &'a (dyn Fn(usize) + Sync)) -> Self {
        let progress = Some(progress);
        Self { progress, ..self }
    }

    /// The same options with a callback that may cancel the search.
    #[must_use]
    pub fn with_cancel(self, cancel: &'a (dyn Fn() -> bool + Sync)) -> Self {
        let cancel = Some(cancel);
        Self { cancel, ..self }
    }
}

impl FreeStepOptions<'_> {
    /// The fraction to keep, if it is in range and the start of the step is in the precision of the end.
    pub(super) fn checked(&self, step: &Step<'_>) -> Result<f64, LineSearchError> {
        let [x0, _] = step.positions();
        if let Some(vertex) = self.precision.first_other(x0) {
            return Err(LineSearchError::Precision { vertex });
        }
        let keep = self.keep;
        if keep > 0.0 && keep <= 1.0 {
            Ok(keep)
        } else {
            Err(LineSearchError::Keep(keep))
        }
    }
}

impl fmt::Debug for FreeStepOptions<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FreeStepOptions")
            .field("keep", &self.keep)
            .field("min_distance", &self.min_distance)
            .field("precision", &self.precision)
            .field("has_progress", &self.progress.is_some())
            .field("has_cancel", &self.cancel.is_some())
            .finish()
    }
}
