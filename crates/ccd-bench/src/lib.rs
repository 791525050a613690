//! The published data sets of continuous collision queries: query files, scenes, and symbolic ground truth.
//!
//! [`DataFolder`] lists what there is, [`QueryReader`] streams the queries of a file, [`write_query`] writes them, and
//! [`Scene`] rebuilds the queries of a simulation's time step from its meshes.

mod data_folder;
mod error;
mod excerpt;
mod json;
mod kind;
mod location;
mod queries;
mod rational;
mod roots;
mod scene;
mod write;

pub use data_folder::DataFolder;
pub use error::{DataError, Problem};
pub use kind::DataKind;
pub use queries::{QueryReader, Sample};
pub use rational::{CoordinateError, Rounding};
pub use roots::{Roots, read_roots};
pub use scene::Scene;
pub use write::write_query;
