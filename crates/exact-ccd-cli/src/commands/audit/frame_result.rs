//! The result of a frame, and of the step that leads to it.

use serde::{Deserialize, Serialize};

use crate::assembly::Turn;
use crate::contacts::ContactRecord;

/// Everything that the report has of a frame and of the step that leads to it. It is a line of a file of
/// results: a report from results read again is the same, because every `f64` reads as it was written.
#[derive(Serialize, Deserialize)]
pub(super) struct FrameResult {
    /// The number of the frame.
    pub(super) frame: usize,
    /// The violations, the earliest first, with the ids of the files.
    pub(super) violations: Vec<ContactRecord>,
    /// A note about the first of them, for a report in which it is the first of all.
    pub(super) note_of_violation: Option<String>,
    /// The bodies that turn in the step.
    pub(super) turns: Vec<Turn>,
    /// The notes about the frame.
    pub(super) notes: Vec<String>,
}
