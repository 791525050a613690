//! The rows of a query file: the coordinates of a point, and perhaps one more field.

use std::io::Read;

use exact_ccd::Point;
use exact_ccd_files::excerpt;

use crate::coordinate;
use crate::error::{DataError, Problem};
use crate::lines::Lines;
use crate::rational::{self, Rounding};
use crate::record::is_count;

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
    lines: Lines<R>,
    rounding: Rounding,
    seventh: Seventh,
    /// The points of a query, with these [names](exact_ccd::AnyKind::point_names).
    points: &'static [&'static str],
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
    pub(crate) fn new(lines: Lines<R>, rounding: Rounding, points: &'static [&'static str]) -> Self {
        Self {
            lines,
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

    pub(crate) fn lines(&self) -> &Lines<R> {
        &self.lines
    }

    /// The next row, which is row `index` of its query. `None` at the end of the file.
    pub(crate) fn next(&mut self, index: usize) -> Result<Option<Row>, DataError> {
        if !self.lines.next()? {
            return Ok(None);
        }
        let line = self.lines.number();
        let parsed = self.parse(index).map_err(|problem| self.lines.error(problem));
        let (fields, point, seventh) = parsed?;
        self.fields = Some(fields);
        Ok(Some(Row { point, seventh, line }))
    }

    /// The number of fields, the point, and the value after its coordinates.
    fn parse(&self, index: usize) -> Result<(usize, Point, Option<i64>), Problem> {
        let mut fields = [&[][..]; 7];
        let mut found = 0;
        for field in self.lines.fields() {
            if let Some(place) = fields.get_mut(found) {
                *place = field;
            }
            found += 1;
        }
        if !matches!(found, 3 | 4 | 6 | 7) || self.fields.is_some_and(|fields| fields != found) {
            let expected = self.fields.map_or(ANY_FIELDS.to_owned(), |fields| {
                format!("{fields} fields, as in the first row")
            });
            return Err(Problem::Fields { expected, found });
        }
        let are_fractions = found >= 6;
        let mut point = [0.0; 3];
        for (axis, coordinate) in point.iter_mut().enumerate() {
            let parsed = if are_fractions {
                rational::parse(fields[2 * axis], fields[2 * axis + 1], self.rounding)
            } else {
                coordinate::parse(fields[axis], self.rounding)
            };
            *coordinate = parsed.map_err(|source| Problem::Coordinate {
                axis: ['x', 'y', 'z'][axis],
                point: self.points[index % self.points.len()],
                time: index / self.points.len(),
                source,
            })?;
        }
        let seventh = fields[..found].get(if are_fractions { 6 } else { 3 });
        let seventh = seventh.map(|field| self.parse_seventh(field)).transpose()?;
        Ok((found, point, seventh))
    }

    fn parse_seventh(&self, field: &[u8]) -> Result<i64, Problem> {
        match (self.seventh, field) {
            (Seventh::Contact, b"0") => Ok(0),
            (Seventh::Contact, b"1") => Ok(1),
            (Seventh::Contact, other) => Err(Problem::Truth(excerpt(other))),
            (Seventh::Count, field) => str::from_utf8(field)
                .ok()
                .and_then(|text| text.parse().ok())
                .filter(|&count| is_count(count))
                .ok_or_else(|| Problem::Count(excerpt(field))),
        }
    }
}
