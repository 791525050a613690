//! The fields of the rows of CSV files with a header.

use std::fs::File;
use std::path::Path;
use std::str::FromStr;

use exact_ccd_files::excerpt;

use crate::error::{DataError, Problem};
use crate::lines::Lines;

/// All rows of a file after its header, which `parse` converts. Each must have five fields.
pub(crate) fn read_rows<T>(
    file: &Path,
    parse: impl Fn([&str; 5]) -> Result<T, Problem>,
) -> Result<Vec<T>, DataError> {
    let text = File::open(file).map_err(|source| DataError::io(file, source))?;
    let mut lines = Lines::new(file.to_owned(), text);
    let mut rows = Vec::new();
    lines.next()?;
    while lines.next()? {
        let fields: Vec<_> = lines.fields().map(String::from_utf8_lossy).collect();
        let fields: Vec<&str> = fields.iter().map(AsRef::as_ref).collect();
        let row = <[&str; 5]>::try_from(&fields[..]).map_err(|_| Problem::Fields {
            expected: "5 fields".to_owned(),
            found: fields.len(),
        });
        rows.push(row.and_then(&parse).map_err(|problem| lines.error(problem))?);
    }
    Ok(rows)
}

pub(crate) fn time(text: &str, column: &'static str) -> Result<f64, Problem> {
    let expected = "a time from 0 to 1";
    let time = field(text, column, expected)?;
    if (0.0..=1.0).contains(&time) {
        Ok(time)
    } else {
        Err(other(text, column, expected))
    }
}

pub(crate) fn flag(text: &str, column: &'static str) -> Result<bool, Problem> {
    match text {
        "0" => Ok(false),
        "1" => Ok(true),
        _ => Err(other(text, column, "0 or 1")),
    }
}

pub(crate) fn field<T: FromStr>(
    text: &str,
    column: &'static str,
    expected: &'static str,
) -> Result<T, Problem> {
    text.parse().map_err(|_| other(text, column, expected))
}

/// The error of a field that is not as expected.
pub(crate) fn other(text: &str, column: &'static str, expected: &'static str) -> Problem {
    Problem::Field {
        column,
        expected,
        found: excerpt(text.as_bytes()),
    }
}
