//! The published data sets of continuous collision queries: query files, scenes, and symbolic ground truth.
//!
//! [`DataFolder`] lists what there is, [`QueryReader`] streams the queries of a file, and [`Scene`] rebuilds the
//! queries of a simulation's time step from its meshes.

mod data_folder;
mod error;
mod json;
mod kind;
mod queries;
mod rational;
mod roots;
mod scene;

pub use data_folder::DataFolder;
pub use error::{DataError, Problem};
pub use json::{read_pairs, read_verdicts};
pub use kind::DataKind;
pub use queries::{QueryReader, Sample};
pub use rational::{CoordinateError, Rounding};
pub use roots::{Roots, read_roots};
pub use scene::Scene;
