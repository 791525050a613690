//! Query files: a row for each point of a query at each end of the step, of rational coordinates.

use std::fs::File;
use std::io::Read;
use std::marker::PhantomData;
use std::path::{Path, PathBuf};

use exact_ccd::Kind;

use crate::error::{DataError, Problem};
use crate::lines::Lines;
use crate::query_points;
use crate::rational::Rounding;
use crate::record::{Record, Sample};
use crate::rows::{Row, RowReader, Seventh};

/// Reads queries one after the other, with all data that the file has about them, from files of any size. It
/// ends after the first error.
///
/// A query is its points at t = 0 and then at t = 1, a row for each, in the order of the kind: eight
/// rows of [`VertexFace`](exact_ccd::VertexFace) or [`EdgeEdge`](exact_ccd::EdgeEdge), six of
/// [`VertexEdge`](exact_ccd::VertexEdge), four of [`VertexVertex`](exact_ccd::VertexVertex). A row is
/// the numerators and denominators of x, y and z, six fields; or x, y and z, each a decimal such as
/// `0.1`, which stands for the nearest f64, a hexadecimal float such as `0x1.8p-3`, or a fraction such as
/// `3/16`. In all rows of the file or in none, the ground truth follows, 1 for contact and 0 for none,
/// which is the same in all rows of a query. Fields may have blanks around them. Blank lines are skipped.
pub struct QueryReader<K, R> {
    rows: RowReader<R>,
    done: bool,
    kind: PhantomData<K>,
}

impl<K: Kind> QueryReader<K, File> {
    /// A reader of the queries in a file.
    ///
    /// # Errors
    /// If the file cannot be opened.
    pub fn open(path: &Path, rounding: Rounding) -> Result<Self, DataError> {
        let file = File::open(path).map_err(|source| DataError::io(path, source))?;
        Ok(Self::new(path, file, rounding))
    }
}

impl<K: Kind, R: Read> QueryReader<K, R> {
    /// A reader of the queries in any text, which errors call `name`. It has a buffer of its own.
    pub fn new(name: impl Into<PathBuf>, text: R, rounding: Rounding) -> Self {
        Self {
            rows: RowReader::new(Lines::new(name.into(), text), rounding, K::KIND.point_names()),
            done: false,
            kind: PhantomData,
        }
    }

    /// The reader of a file whose seventh column has this meaning.
    #[must_use]
    pub fn with_seventh(mut self, seventh: Seventh) -> Self {
        self.rows.set_seventh(seventh);
        self
    }

    fn record(&mut self) -> Result<Option<Record<K>>, DataError> {
        // As many as the largest kinds have.
        let mut points = [[0.0; 3]; 8];
        let points = &mut points[..2 * K::KIND.point_names().len()];
        let mut first = None;
        let mut last_line = 0;
        for index in 0..points.len() {
            let Some(Row { point, seventh, line }) = self.rows.next(index)? else {
                return match index {
                    0 => Ok(None),
                    found => {
                        let expected = points.len();
                        Err(self.wrong(last_line, Problem::CutShort { found, expected }))
                    }
                };
            };
            points[index] = point;
            last_line = line;
            if index == 0 {
                first = seventh;
            } else if let (Some(expected), Some(found)) = (first, seventh)
                && expected != found
            {
                return Err(self.wrong(line, Problem::TruthDiffers { expected, found }));
            }
        }
        let query = query_points::query(points).expect("`rational::parse` returns finite numbers");
        let truth = first.map(|seventh| seventh != 0);
        Ok(Some(Record {
            count: first.filter(|_| self.rows.seventh() == Seventh::Count),
            ..Sample { query, truth }.into()
        }))
    }
}

impl<K, R: Read> QueryReader<K, R> {
    fn wrong(&self, line: u64, problem: Problem) -> DataError {
        DataError::line(self.rows.lines().file(), line, problem)
    }

    /// The account of the reading so far.
    #[cfg(test)]
    pub(crate) fn budget(&self) -> &exact_ccd_files::Budget {
        self.rows.lines().budget()
    }
}

impl<K: Kind, R: Read> Iterator for QueryReader<K, R> {
    type Item = Result<Record<K>, DataError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.done {
            return None;
        }
        let record = self.record().transpose();
        self.done = !matches!(record, Some(Ok(_)));
        record
    }
}
