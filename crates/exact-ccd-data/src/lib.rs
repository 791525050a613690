//! Files of continuous collision queries, in the formats of the published data sets.
//!
//! | files | types |
//! |---|---|
//! | query files: CSV, a row for each point at t = 0 and at t = 1 | [`QueryReader`], [`QueryWriter`], [`write_query`] |
//! | Parquet files, a row a query, with all fields of a [`Record`]: the feature `parquet` | `ColumnReader`, `ColumnWriter` |
//! | either of both, by the name of the file | [`open()`] |
//! | curved motion: a JSON object on each line | [`CurvedReader`] |
//! | scenes: two meshes of a recorded time step, the queried pairs, and verdicts | [`RecordedStep`] |
//! | root files: the contact times of the queries of a scene | [`read_roots`] |
//! | queries with the times within a distance | [`SeparationFile`] |
//! | the folder of the published data sets | [`DataFolder`] |
//!
//! Readers of queries are iterators that need little memory, whatever the size of the file, and end after the
//! first error: a line has at most 65,536 bytes, a number of exact arithmetic at most 4,096 digits, and the
//! queries of a Parquet file take at most 200 times its size and a mebibyte, and so do its pages. Errors
//! name the file and the line, query or pair. The panic hook of the process is never changed.
//!
//! ```
//! use exact_ccd::{CONTACT, VertexFace};
//! use exact_ccd_data::{QueryReader, Rounding};
//!
//! let point = "1,4,1,4,-1,1\n";
//! let text = point.repeat(8);
//! for record in QueryReader::<VertexFace, _>::new("points.csv", text.as_bytes(), Rounding::Refuse) {
//!     assert!(record?.sample.query.collides(CONTACT));
//! }
//! # Ok::<(), exact_ccd_data::DataError>(())
//! ```

#[cfg(feature = "parquet")]
mod columns;
mod coordinate;
mod curved;
mod data_folder;
mod error;
mod fields;
#[cfg(test)]
#[cfg(feature = "parquet")]
mod hostile;
mod json;
mod kind;
mod lines;
mod list;
mod open;
mod queries;
mod query_points;
mod rational;
mod record;
mod recorded_step;
mod roots;
mod rows;
mod separation;
mod write;

#[cfg(feature = "parquet")]
pub use columns::{ColumnProblem, ColumnReader, ColumnWriter, RecordProblem, TableColumn, write_table};
pub use curved::{CurvedProblem, CurvedReader, CurvedRecord};
pub use data_folder::DataFolder;
pub use error::{DataError, Problem};
pub use kind::DataKind;
pub use list::list;
pub use open::{Records, is_parquet, open};
pub use queries::QueryReader;
pub use rational::{CoordinateError, Rounding};
pub use record::{Record, Sample};
pub use recorded_step::RecordedStep;
pub use roots::{Roots, read_roots};
pub use rows::Seventh;
pub use separation::{SeparationFile, TimesWithin};
pub use write::{QueryWriter, write_query};
