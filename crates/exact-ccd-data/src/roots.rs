//! Root files: the contact times of a scene's colliding queries.

use std::path::Path;

use crate::error::{DataError, Problem};
use crate::fields::{field, flag, read_rows, time};

/// The contact times of one query, computed symbolically. All are rounded down to f64.
#[derive(Clone, Debug, PartialEq)]
pub struct Roots {
    /// The index of the query in its file, from 0.
    pub query: usize,
    /// The number of contact times, 1 if contact lasts for an interval.
    pub count: usize,
    /// The earliest time.
    pub toi: f64,
    /// True if the earliest time is exactly an f64.
    pub toi_is_exact: bool,
    /// All times in increasing order; of an interval only the first.
    pub times: Vec<f64>,
}

/// All rows of a `roots/*.csv` file.
///
/// # Errors
/// If the file cannot be read or a row is not as expected.
pub fn read_roots(file: &Path) -> Result<Vec<Roots>, DataError> {
    read_rows(file, roots)
}

fn roots([query, count, toi, toi_is_exact, times]: [&str; 5]) -> Result<Roots, Problem> {
    Ok(Roots {
        query: field(query, "query", "an index")?,
        count: field(count, "count", "a number of times")?,
        toi: time(toi, "toi")?,
        toi_is_exact: flag(toi_is_exact, "toi_is_exact")?,
        times: times
            .split_whitespace()
            .map(|text| time(text, "times"))
            .collect::<Result<_, _>>()?,
    })
}
