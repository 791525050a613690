//! Root files: the contact times of a scene's colliding queries.

use std::path::Path;
use std::str::FromStr;

use csv::{ReaderBuilder, StringRecord, Trim};

use crate::error::{DataError, Problem};
use crate::excerpt::excerpt;

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
    let io = |error: csv::Error| DataError::io(file, error.into());
    let mut reader = ReaderBuilder::new()
        .trim(Trim::All)
        .flexible(true)
        .from_path(file)
        .map_err(io)?;
    let parse = |record: Result<StringRecord, csv::Error>| {
        let record = record.map_err(io)?;
        let line = record.position().map_or(0, csv::Position::line);
        roots(&record).map_err(|problem| DataError::line(file, line, problem))
    };
    reader.records().map(parse).collect()
}

fn roots(record: &StringRecord) -> Result<Roots, Problem> {
    if record.len() != 5 {
        return Err(Problem::Fields {
            expected: "5 fields",
            found: record.len(),
        });
    }
    let roots = Roots {
        query: field(&record[0], "query", "an index")?,
        count: field(&record[1], "count", "a number of times")?,
        toi: time(&record[2], "toi")?,
        toi_is_exact: flag(&record[3], "toi_is_exact")?,
        times: record[4]
            .split_whitespace()
            .map(|text| time(text, "times"))
            .collect::<Result<_, _>>()?,
    };
    Ok(roots)
}

fn time(text: &str, column: &'static str) -> Result<f64, Problem> {
    let expected = "a time from 0 to 1";
    let time = field(text, column, expected)?;
    if (0.0..=1.0).contains(&time) {
        Ok(time)
    } else {
        Err(other(text, column, expected))
    }
}

fn flag(text: &str, column: &'static str) -> Result<bool, Problem> {
    match text {
        "0" => Ok(false),
        "1" => Ok(true),
        _ => Err(other(text, column, "0 or 1")),
    }
}

fn field<T: FromStr>(text: &str, column: &'static str, expected: &'static str) -> Result<T, Problem> {
    text.parse().map_err(|_| other(text, column, expected))
}

fn other(text: &str, column: &'static str, expected: &'static str) -> Problem {
    Problem::Field {
        column,
        expected,
        found: excerpt(text.as_bytes()),
    }
}
