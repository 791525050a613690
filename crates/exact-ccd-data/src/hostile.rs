//! Files that are made to cost much: the work is at most proportional to the size.
//!
//! The readers count it, where they take bytes and where they expand pages. A file four times as large may
//! cost four times as much.

use std::io::Write;

use exact_ccd::{Query, VertexFace};

use crate::columns::{ColumnReader, ColumnWriter};
use crate::queries::QueryReader;
use crate::rational::Rounding;
use crate::record::{Record, Sample};

/// The most steps for each byte of a file that does not expand.
const STEPS_A_BYTE: u64 = 2;

fn assert_linear(name: &str, parts: usize, cost: impl Fn(usize) -> (u64, u64)) {
    let ((small, first), (large, second)) = (cost(parts), cost(4 * parts));
    println!("{name}: {small} bytes {first} steps, {large} bytes {second} steps");
    assert!(2 * large <= 9 * small, "{name}: {small} and {large} bytes");
    assert!(
        0 < first && second <= 4 * first + 4096,
        "{name}: {first}, {second}"
    );
}

/// The cost of reading text, whatever its result: bytes and steps.
fn cost_of_text(text: &str) -> (u64, u64) {
    let mut reader = QueryReader::<VertexFace, _>::new("text", text.as_bytes(), Rounding::ToNearest);
    while let Some(Ok(_)) = reader.next() {}
    let [steps, _] = reader.budget().spent();
    let bytes = text.len() as u64;
    assert!(
        steps <= STEPS_A_BYTE * bytes + 4096,
        "{steps} steps for {bytes} bytes"
    );
    (bytes, steps)
}

#[test]
fn query_files_cost_in_proportion_to_their_size() {
    let digits = "9".repeat(4000);
    let long = format!("{digits},{digits},0,1,0,1\n");
    let blanks = format!("{}\n", " ".repeat(60_000));
    for (name, row) in [
        ("short rows", "0,0,0\n"),
        ("rows of long numbers", &long),
        ("blank lines", "\n"),
        ("lines of blanks", &blanks),
        ("lines of separators", ",,\n"),
        ("text without lines", ","),
    ] {
        assert_linear(name, 64, |count| cost_of_text(&row.repeat(count)));
    }
}

/// The cost of reading a Parquet file, whatever its result: bytes and steps.
fn cost_of_columns(bytes: &[u8]) -> (u64, u64) {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(bytes).unwrap();
    let mut reader = ColumnReader::<VertexFace>::open(file.path()).unwrap();
    while let Some(Ok(_)) = reader.next() {}
    (bytes.len() as u64, reader.spent()[0])
}

/// Queries with these coordinates at t = 0.
fn columns(count: usize, coordinate: impl Fn(usize) -> f64) -> Vec<u8> {
    let mut writer = ColumnWriter::new(Vec::new()).unwrap();
    for number in 0..count {
        let start = [[coordinate(number); 3]; 4];
        let query = Query::<VertexFace>::new(start, [[1.0; 3]; 4]).unwrap();
        writer.write(Record::from(Sample { query, truth: None })).unwrap();
    }
    writer.finish().unwrap()
}

#[test]
fn parquet_files_cost_in_proportion_to_their_size() {
    let distinct = |number: usize| 1.0 / (number as f64 + 1.0);
    assert_linear("distinct queries", 4000, |count| {
        cost_of_columns(&columns(count, distinct))
    });
}

/// Pages that expand, and values that repeat, cost in proportion to the number of queries, which the size
/// of the file limits.
#[test]
fn equal_queries_cost_in_proportion_to_their_number() {
    let steps = |count: usize| {
        let (bytes, steps) = cost_of_columns(&columns(count, |_| 0.0));
        assert!(
            steps <= 200 * bytes + (1 << 20),
            "{steps} steps for {bytes} bytes"
        );
        steps
    };
    let (first, second) = (steps(1000), steps(4000));
    assert!(first >= 1000 && second <= 4 * first + 4096, "{first}, {second}");
}
