//! The published data sets of continuous collision queries: query files, scenes, and symbolic ground truth.
//!
//! [`DataFolder`] lists what there is, [`QueryReader`] streams the queries of a file, [`write_query`] writes them, and
//! [`Scene`] rebuilds the queries of a simulation's time step from its meshes. [`ColumnReader`] and [`ColumnWriter`] do
//! the same for Parquet files, which hold a [`Record`] for each query.

mod columns;
pub mod comparison;
mod data_folder;
mod error;
mod excerpt;
mod json;
mod kind;
mod location;
mod queries;
mod rational;
mod record;
mod roots;
mod scene;
mod write;

pub use columns::{ColumnReader, ColumnWriter};
pub use data_folder::DataFolder;
pub use error::{ColumnProblem, DataError, Problem, RecordProblem};
pub use kind::DataKind;
pub use queries::{QueryReader, Sample, Seventh};
pub use rational::{CoordinateError, Rounding};
pub use record::Record;
pub use roots::{Roots, read_roots};
pub use scene::Scene;
pub use write::{QueryWriter, write_query};
