//! Query files: the forms of rows, and errors.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::io;

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_data::{QueryReader, Rounding, Sample};

fn read(text: &str) -> Result<Vec<Sample<EdgeEdge>>, String> {
    read_rounding(text, Rounding::Refuse)
}

fn read_rounding(text: &str, rounding: Rounding) -> Result<Vec<Sample<EdgeEdge>>, String> {
    QueryReader::<EdgeEdge, _>::new("some.csv", text.as_bytes(), rounding)
        .map(|record| record.map(|record| record.sample))
        .collect::<Result<_, _>>()
        .map_err(|error| error.to_string())
}

fn message(text: &str) -> String {
    read(text).unwrap_err()
}

/// Row i holds the point (i, i / 2, −1).
fn query(ending: &str) -> String {
    (0..8).map(|i| format!("{i},1,{i},2,-1,1{ending}")).collect()
}

#[test]
fn rows_are_points_at_the_start_and_then_at_the_end() {
    let samples = read(&query("\n")).unwrap();
    let point = |i: u8| [f64::from(i), f64::from(i) / 2.0, -1.0];
    assert_eq!(samples.len(), 1);
    assert_eq!(
        samples[0].query.points(),
        &[[0, 1, 2, 3].map(point), [4, 5, 6, 7].map(point)]
    );
    assert_eq!(samples[0].truth, None);
}

#[test]
fn the_truth_is_read_from_the_seventh_column() {
    let samples = read(&(query(",1\n") + &query(",0\n"))).unwrap();
    assert_eq!(
        samples.iter().map(|sample| sample.truth).collect::<Vec<_>>(),
        [Some(true), Some(false)]
    );
}

#[test]
fn line_breaks_blanks_and_blank_lines_do_not_matter() {
    let expected = read(&query(",1\n")).unwrap();
    for ending in [",1\r\n", " , 1 \n", ",1\n\n", ",1\r\n\r\n", "\t,1\n \t \n"] {
        assert_eq!(read(&query(ending)).unwrap(), expected, "{ending:?}");
        assert_eq!(read(query(ending).trim_end()).unwrap(), expected, "{ending:?}");
        assert_eq!(
            read(&("\n\r\n".to_owned() + &query(ending))).unwrap(),
            expected,
            "{ending:?}"
        );
    }
    assert_eq!(read(""), Ok(vec![]));
    assert_eq!(read(" \n\r\n\n"), Ok(vec![]));
}

#[test]
fn errors_name_file_line_and_coordinate() {
    assert_eq!(
        message(&query(",1\n").replace("5,1,5,2", "5,1,5,3")),
        "some.csv, line 6: y of a1 at t = 1: 5/3 is not exactly an f64"
    );
    assert_eq!(
        message(&("\n\r\n".to_owned() + &query("\r\n\r\n").replace("7,1,7,2", "7,0,7,2"))),
        "some.csv, line 17: x of b1 at t = 1: the denominator of 7/0 is zero"
    );
    let mut faces = QueryReader::<VertexFace, _>::new("-", "1,1,1,1,one,1".as_bytes(), Rounding::Refuse);
    assert_eq!(
        faces.next().unwrap().unwrap_err().to_string(),
        "-, line 1: z of p at t = 0: expected an integer, found \"one\""
    );
    assert!(faces.next().is_none());
}

#[test]
fn a_query_cut_short_is_an_error() {
    let text = query("\n") + &query("\n");
    let short: String = text.lines().take(13).map(|line| line.to_owned() + "\n").collect();
    let expected = "some.csv, line 13: the file ends after 5 of the 8 rows of a query";
    assert_eq!(message(&short), expected);
    assert_eq!(message(short.trim_end()), expected);
    assert_eq!(message(&(short + "\n\n")), expected);
}

#[test]
fn every_row_has_the_same_fields_and_a_query_one_truth() {
    assert_eq!(
        message("1,2,3,4,5\n"),
        "some.csv, line 1: expected 3 or 6 fields, or one more for the ground truth, found 5"
    );
    assert_eq!(
        message(&(query("\n") + &query(",1\n"))),
        "some.csv, line 9: expected 6 fields, as in the first row, found 7"
    );
    assert_eq!(
        message(&query(",1\n").replace("3,1,3,2,-1,1,1", "3,1,3,2,-1,1,0")),
        "some.csv, line 4: the ground truth is 0, expected 1 as in the first row of the query"
    );
    assert_eq!(
        message(&query(",2\n")),
        "some.csv, line 1: expected 0 or 1 as the ground truth, found \"2\""
    );
}

#[test]
fn coordinates_are_fractions_decimals_or_hexadecimal_floats() {
    let fractions = read(&query(",1\n")).unwrap();
    let rows = query(",1\n");
    let one_field_each = |number: fn(f64) -> String| {
        let row = |line: &str| {
            let fields: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
            let [x, y, z] = [0, 2, 4].map(|at| number(fields[at] / fields[at + 1]));
            format!("{x}, {y},{z},1\n")
        };
        rows.lines().map(row).collect::<String>()
    };
    for number in [
        |x: f64| x.to_string(),
        |x: f64| format!("{x:e}"),
        |x: f64| format!("{}/2", 2.0 * x),
        |x: f64| {
            format!(
                "{}0x{:x}p-1",
                if x < 0.0 { "-" } else { "" },
                (2.0 * x.abs()) as u64
            )
        },
    ] {
        assert_eq!(read(&one_field_each(number)).unwrap(), fractions);
    }
    assert_eq!(
        message("0.5,1,zero\n"),
        "some.csv, line 1: z of a0 at t = 0: expected a decimal, a hexadecimal float or a fraction, found \"zero\""
    );
    assert_eq!(
        message("0,0,0,1\n0,0,0\n"),
        "some.csv, line 2: expected 4 fields, as in the first row, found 3"
    );
}

/// Exact arithmetic with a number of n digits takes time proportional to n².
#[test]
fn numbers_of_many_digits_are_an_error() {
    let row = |digits: usize| format!("{},1,0,1,0,1\n", "9".repeat(digits));
    assert!(message(&row(4096)).ends_with("is out of the range of f64"));
    assert_eq!(
        message(&row(4097)),
        format!(
            "some.csv, line 1: x of a0 at t = 0: {}… has more than 4096 digits; reduce the fraction",
            "9".repeat(40)
        )
    );
    let hexadecimal = format!("0x{}p0,0,0\n", "1".repeat(4097));
    assert!(message(&hexadecimal).contains("has more than 4096 digits"));
}

/// A reader keeps one line at a time.
#[test]
fn very_long_lines_are_an_error() {
    let blanks = |count: usize| query("\n") + &" ".repeat(count) + "\n" + &query("\n");
    assert_eq!(read(&blanks(65_535)).map(|samples| samples.len()), Ok(2));
    assert_eq!(
        message(&blanks(65_536)),
        "some.csv, line 9: more than 65536 bytes, expected a row of a few numbers"
    );
    let mut endless = QueryReader::<VertexFace, _>::new("-", io::repeat(b','), Rounding::Refuse);
    assert!(endless.next().unwrap().is_err());
}

#[test]
fn rounding_is_only_by_request() {
    let text = query("\n").replace("5,1,5,2", "5,3,5,2");
    let points = *read_rounding(&text, Rounding::ToNearest).unwrap()[0]
        .query
        .points();
    assert_eq!(points[1][1][0], 5.0 / 3.0);
}

#[test]
fn bytes_that_are_no_text_are_an_error() {
    let bytes: &[u8] = b"\x00\xff,1,1,1,1,1\n";
    let mut reader = QueryReader::<EdgeEdge, _>::new("x", bytes, Rounding::Refuse);
    let error = reader.next().unwrap().unwrap_err().to_string();
    assert_eq!(
        error,
        "x, line 1: x of a0 at t = 0: expected an integer, found \"\\0\u{fffd}\""
    );
}
