//! Queries in columns: a Parquet file, a row for each query.
//!
//! The coordinates are one column of lists, not a column each, so that neighbouring queries share the
//! entries of one dictionary: half the bytes on most data sets. Compression is gzip: every reader
//! of Parquet supports it, it needs no C library, and its checksum detects damaged data.

mod counted_file;
mod footer;
mod format;
mod group;
mod guard;
mod header;
mod leaf;
mod problem;
mod read;
mod row;
mod table;
mod thrift;
mod write;

pub use problem::{ColumnProblem, RecordProblem};
pub use read::ColumnReader;
pub use table::{TableColumn, write_table};
pub use write::ColumnWriter;

use exact_ccd::Kind;

/// The columns, as [`ColumnWriter`] writes them. [`ColumnReader`] finds them by their names and
/// physical types.
const SCHEMA: &str = "message queries {
    required binary kind (STRING);
    required group points (LIST) {
        repeated group list {
            required double element;
        }
    }
    optional boolean truth;
    optional int64 count;
    optional double toi;
    optional binary scene (STRING);
    optional int64 id_a;
    optional int64 id_b;
}";

/// The number of coordinates of a query: x, y, z of its points at t = 0, then at t = 1.
const fn coordinates<K: Kind>() -> usize {
    3 * 2 * K::KIND.point_names().len()
}
