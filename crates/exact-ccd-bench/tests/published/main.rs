//! Tests on the published data sets, whose symbolic ground truth is independent of this project.
//!
//! These tests are ignored if the data folder is missing.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod batches;
mod candidates;
mod columns;
mod frames;
mod ground_truth;
mod meshes;
mod nonlinear;
mod parity;
mod separation;
mod steps;

use std::path::Path;

use exact_ccd_data::{DataFolder, RecordedStep};

fn data() -> DataFolder {
    DataFolder::find(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))).unwrap()
}

fn scenes() -> Vec<RecordedStep> {
    data().scenes().unwrap()
}
