//! Query files: eight rows a query, a point of rational coordinates in each.

use std::fs::File;
use std::io::{self, Read};
use std::marker::PhantomData;
use std::path::{Path, PathBuf};

use csv::{ByteRecord, ReaderBuilder, Terminator, Trim};
use exact_ccd::{Point, Query};

use crate::error::{DataError, Problem};
use crate::excerpt::excerpt;
use crate::kind::DataKind;
use crate::rational::{self, Rounding};
use crate::record::Record;

/// A query from a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample<K> {
    /// The query.
    pub query: Query<K>,
    /// Whether its primitives collide, if the file says so.
    pub truth: Option<bool>,
}

/// What the seventh column of a query file says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Seventh {
    /// Whether the primitives collide: 0 or 1.
    #[default]
    Contact,
    /// How many contact times there are: 0 or more, or −1 for infinitely many.
    Count,
}

/// Reads queries one after the other, from files of any size. It ends after the first error.
///
/// A query is eight rows, its four points at t = 0 and then at t = 1 in the order of
/// [`VertexFace`](exact_ccd::VertexFace) or [`EdgeEdge`](exact_ccd::EdgeEdge); a row is the numerators and
/// denominators of x, y and z, in all rows of the file or in none followed by the ground truth, 1 for contact and
/// 0 for none, which is the same in the eight rows. Fields may have blanks around them; blank lines are skipped.
pub struct QueryReader<K, R> {
    file: PathBuf,
    csv: csv::Reader<io::Chain<R, &'static [u8]>>,
    record: ByteRecord,
    rounding: Rounding,
    seventh: Seventh,
    /// The number of fields in the first row.
    fields: Option<usize>,
    done: bool,
    kind: PhantomData<K>,
}

/// A point, the ground truth, and the line that they stand in.
struct Row {
    point: Point,
    /// What is in the seventh column.
    truth: Option<i64>,
    line: u64,
}

impl<K: DataKind> QueryReader<K, File> {
    /// A reader of the queries in a file.
    ///
    /// # Errors
    /// If the file cannot be opened.
    pub fn open(path: &Path, rounding: Rounding) -> Result<Self, DataError> {
        let file = File::open(path).map_err(|source| DataError::io(path, source))?;
        Ok(Self::new(path, file, rounding))
    }
}

impl<K: DataKind, R: Read> QueryReader<K, R> {
    /// A reader of the queries in any text; errors call it `name`. It does its own buffering.
    pub fn new(name: impl Into<PathBuf>, text: R, rounding: Rounding) -> Self {
        let csv = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .quoting(false)
            .trim(Trim::All)
            // Trimming takes care of carriage returns.
            .terminator(Terminator::Any(b'\n'))
            // With this, every record ends in a line break, and its line is the one before the reader's position.
            .from_reader(text.chain(b"\n".as_slice()));
        Self {
            file: name.into(),
            csv,
            record: ByteRecord::new(),
            rounding,
            seventh: Seventh::Contact,
            fields: None,
            done: false,
            kind: PhantomData,
        }
    }

    /// The reader of a file whose seventh column says this.
    #[must_use]
    pub fn with_seventh(mut self, seventh: Seventh) -> Self {
        self.seventh = seventh;
        self
    }

    /// The queries with all that the file says of them.
    pub fn records(mut self) -> impl Iterator<Item = Result<Record<K>, DataError>> {
        std::iter::from_fn(move || self.next_record())
    }

    fn next_record(&mut self) -> Option<Result<Record<K>, DataError>> {
        if self.done {
            return None;
        }
        let record = self.record().transpose();
        self.done = !matches!(record, Some(Ok(_)));
        record
    }

    fn record(&mut self) -> Result<Option<Record<K>>, DataError> {
        let mut points = [[[0.0; 3]; 4]; 2];
        let mut first_truth = None;
        let mut last_line = 0;
        for index in 0..8 {
            let Some(Row { point, truth, line }) = self.row(index)? else {
                return match index {
                    0 => Ok(None),
                    rows => Err(DataError::line(&self.file, last_line, Problem::CutShort(rows))),
                };
            };
            points[index / 4][index % 4] = point;
            last_line = line;
            if index == 0 {
                first_truth = truth;
            } else if let (Some(expected), Some(found)) = (first_truth, truth)
                && expected != found
            {
                return Err(DataError::line(
                    &self.file,
                    line,
                    Problem::TruthDiffers { expected, found },
                ));
            }
        }
        let query = Query::new(points[0], points[1]).expect("coordinates were checked to be finite");
        let sample = Sample {
            query,
            truth: first_truth.map(|truth| truth != 0),
        };
        Ok(Some(Record {
            count: first_truth.filter(|_| self.seventh == Seventh::Count),
            ..sample.into()
        }))
    }

    /// The next row, which is row `index` of its query.
    fn row(&mut self, index: usize) -> Result<Option<Row>, DataError> {
        loop {
            if !self
                .csv
                .read_byte_record(&mut self.record)
                .map_err(|error| self.io(error))?
            {
                return Ok(None);
            }
            if self.record.iter().any(|field| !field.is_empty()) || self.record.len() > 1 {
                break;
            }
        }
        let line = self.csv.position().line() - 1;
        self.parse(index)
            .map(|(point, truth)| Some(Row { point, truth, line }))
            .map_err(|problem| DataError::line(&self.file, line, problem))
    }

    fn parse(&mut self, index: usize) -> Result<(Point, Option<i64>), Problem> {
        let found = self.record.len();
        let expected = match self.fields {
            Some(6) => "6 fields, as in the first row",
            Some(_) => "7 fields, as in the first row",
            None => "6 or 7 fields",
        };
        if !matches!(found, 6 | 7) || self.fields.is_some_and(|fields| fields != found) {
            return Err(Problem::Fields { expected, found });
        }
        self.fields = Some(found);
        let mut point = [0.0; 3];
        for (axis, coordinate) in point.iter_mut().enumerate() {
            let [numerator, denominator] = [0, 1].map(|part| &self.record[2 * axis + part]);
            *coordinate = rational::parse(numerator, denominator, self.rounding).map_err(|source| {
                Problem::Coordinate {
                    axis: ['x', 'y', 'z'][axis],
                    point: K::POINTS[index % 4],
                    time: index / 4,
                    source,
                }
            })?;
        }
        let truth = self.record.get(6).map(|field| self.truth(field)).transpose()?;
        Ok((point, truth))
    }

    fn truth(&self, field: &[u8]) -> Result<i64, Problem> {
        match (self.seventh, field) {
            (Seventh::Contact, b"0") => Ok(0),
            (Seventh::Contact, b"1") => Ok(1),
            (Seventh::Contact, other) => Err(Problem::Truth(excerpt(other))),
            (Seventh::Count, field) => str::from_utf8(field)
                .ok()
                .and_then(|text| text.parse().ok())
                .filter(|&count| count >= -1)
                .ok_or_else(|| Problem::Count(excerpt(field))),
        }
    }

    fn io(&self, error: csv::Error) -> DataError {
        DataError::io(&self.file, error.into())
    }
}

impl<K: DataKind, R: Read> Iterator for QueryReader<K, R> {
    type Item = Result<Sample<K>, DataError>;

    fn next(&mut self) -> Option<Self::Item> {
        self.next_record()
            .map(|record| record.map(|record| record.sample))
    }
}

#[cfg(test)]
mod tests {
    use exact_ccd::{EdgeEdge, VertexFace};

    use super::*;

    fn read(text: &str) -> Result<Vec<Sample<EdgeEdge>>, String> {
        read_rounding(text, Rounding::Refuse)
    }

    fn read_rounding(text: &str, rounding: Rounding) -> Result<Vec<Sample<EdgeEdge>>, String> {
        QueryReader::new("some.csv", text.as_bytes(), rounding)
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
            message("1,2,3\n"),
            "some.csv, line 1: expected 6 or 7 fields, found 3"
        );
        assert_eq!(
            message(&(query("\n") + &query(",1\n"))),
            "some.csv, line 9: expected 6 fields, as in the first row, found 7"
        );
        assert_eq!(
            message(&query(",1\n").replace("3,1,3,2,-1,1,1", "3,1,3,2,-1,1,0")),
            "some.csv, line 4: the ground truth is 0, but 1 in the rows of the same query before"
        );
        assert_eq!(
            message(&query(",2\n")),
            "some.csv, line 1: expected 0 or 1 as the ground truth, found \"2\""
        );
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
}
