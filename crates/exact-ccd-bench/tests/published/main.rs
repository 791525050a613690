//! The published data sets, with symbolic ground truth from outside of this project.
//!
//! Without the data folder these tests are ignored.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod batches;
mod candidates;
mod columns;
mod frames;
mod ground_truth;
mod meshes;
mod parity;
mod separation;
mod steps;

#[path = "../../../exact-ccd/tests/parity/expected/mod.rs"]
mod expected;

use std::path::Path;

use exact_ccd_data::{DataFolder, Scene};

fn data() -> DataFolder {
    DataFolder::find(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))).unwrap()
}

fn scenes() -> Vec<Scene> {
    data().scenes().unwrap()
}
