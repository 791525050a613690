//! The rows of a query file: the coordinates of a point, and perhaps one more field.

use std::io::{self, Read};
use std::path::PathBuf;

use csv::{ByteRecord, ReaderBuilder, Terminator, Trim};
use exact_ccd::Point;

use crate::coordinate;
use crate::error::{DataError, Problem};
use crate::excerpt::excerpt;
use crate::long_lines::ShortLines;
use crate::rational::{self, Rounding};

/// The numbers of fields in a row: three coordinates, or three numerators and denominators, and perhaps the
/// ground truth.
const ANY_FIELDS: &str = "3 or 6 fields, or one more for the ground truth";

/// The meaning of the column after the coordinates, the seventh one if they are fractions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Seventh {
    /// The ground truth: 1 for contact and 0 for none.
    #[default]
    Contact,
    /// The number of contact times: 0 or more, or −1 for infinitely many.
    Count,
}

/// Reads the rows of a file one after the other.
pub(crate) struct RowReader<R> {
    file: PathBuf,
    csv: csv::Reader<io::Chain<ShortLines<R>, &'static [u8]>>,
    record: ByteRecord,
    rounding: Rounding,
    seventh: Seventh,
    /// The points of a query, as [`QueryKind`](crate::QueryKind) names them.
    points: &'static [(&'static str, usize)],
    /// The number of fields in the first row.
    fields: Option<usize>,
}

/// A row of a query file.
pub(crate) struct Row {
    pub(crate) point: Point,
    /// The value in the column after the coordinates.
    pub(crate) seventh: Option<i64>,
    /// The line, from 1.
    pub(crate) line: u64,
}

impl<R: Read> RowReader<R> {
    pub(crate) fn new(
        file: PathBuf,
        text: R,
        rounding: Rounding,
        points: &'static [(&'static str, usize)],
    ) -> Self {
        let csv = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .quoting(false)
            .trim(Trim::All)
            // Trimming removes carriage returns.
            .terminator(Terminator::Any(b'\n'))
            // With this, every record ends in a line break, and its line is the one before the
            // reader's position.
            .from_reader(ShortLines::new(text).chain(b"\n".as_slice()));
        Self {
            file,
            csv,
            record: ByteRecord::new(),
            rounding,
            seventh: Seventh::Contact,
            points,
            fields: None,
        }
    }

    pub(crate) fn set_seventh(&mut self, seventh: Seventh) {
        self.seventh = seventh;
    }

    pub(crate) fn seventh(&self) -> Seventh {
        self.seventh
    }

    /// The next row, which is row `index` of its query. `None` at the end of the file.
    pub(crate) fn next(&mut self, index: usize) -> Result<Option<Row>, DataError> {
        loop {
            let read = self.csv.read_byte_record(&mut self.record);
            if !read.map_err(|error| DataError::io(&self.file, error.into()))? {
                return Ok(None);
            }
            if self.record.iter().any(|field| !field.is_empty()) || self.record.len() > 1 {
                break;
            }
        }
        let line = self.csv.position().line() - 1;
        self.parse(index)
            .map(|(point, seventh)| Some(Row { point, seventh, line }))
            .map_err(|problem| self.error(line, problem))
    }

    pub(crate) fn error(&self, line: u64, problem: Problem) -> DataError {
        DataError::line(&self.file, line, problem)
    }

    fn parse(&mut self, index: usize) -> Result<(Point, Option<i64>), Problem> {
        let found = self.record.len();
        if !matches!(found, 3 | 4 | 6 | 7) || self.fields.is_some_and(|fields| fields != found) {
            let expected = self.fields.map_or(ANY_FIELDS.to_owned(), |fields| {
                format!("{fields} fields, as in the first row")
            });
            return Err(Problem::Fields { expected, found });
        }
        self.fields = Some(found);
        let are_fractions = found >= 6;
        let mut point = [0.0; 3];
        for (axis, coordinate) in point.iter_mut().enumerate() {
            let parsed = if are_fractions {
                let [numerator, denominator] = [0, 1].map(|part| &self.record[2 * axis + part]);
                rational::parse(numerator, denominator, self.rounding)
            } else {
                coordinate::parse(&self.record[axis], self.rounding)
            };
            *coordinate = parsed.map_err(|source| Problem::Coordinate {
                axis: ['x', 'y', 'z'][axis],
                point: self.points[index % self.points.len()].0,
                time: index / self.points.len(),
                source,
            })?;
        }
        let seventh = self.record.get(if are_fractions { 6 } else { 3 });
        let seventh = seventh.map(|field| self.parse_seventh(field));
        Ok((point, seventh.transpose()?))
    }

    fn parse_seventh(&self, field: &[u8]) -> Result<i64, Problem> {
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
}
