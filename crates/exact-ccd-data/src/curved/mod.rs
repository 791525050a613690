//! Files of queries of curved motion: a JSON object on each line.

mod problem;
mod read;
mod value;

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use exact_ccd::motion::{Bezier, BodyPair, CurvedQuery, InvalidMotion};
use exact_ccd::{AnyKind, Kind, Point};

use crate::error::DataError;
use crate::lines::Lines;
pub use problem::CurvedProblem;

/// A query of curved motion, with the ground truth that the file has about it.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvedRecord {
    kind: AnyKind,
    paths: Paths,
    /// The number of contact times, −1 for infinitely many.
    pub count: Option<i64>,
    /// The earliest contact time, rounded down to f64.
    pub toi: Option<f64>,
}

/// The paths of the points of a query, as many as the kind has.
#[derive(Clone, Debug, PartialEq)]
enum Paths {
    /// The control points of each point.
    Curves(Vec<Vec<Point>>),
    Bodies {
        points: Vec<Point>,
        pair: BodyPair,
    },
}

impl CurvedRecord {
    /// The kind of the query.
    #[must_use]
    pub fn kind(&self) -> AnyKind {
        self.kind
    }

    /// The query, if it is of this kind.
    #[must_use]
    pub fn query<K: Kind>(&self) -> Option<CurvedQuery<K>> {
        if self.kind != K::KIND {
            return None;
        }
        match &self.paths {
            Paths::Curves(curves) => bezier::<K>(curves).ok().map(CurvedQuery::from),
            Paths::Bodies { points, pair } => pair.query(set::<K>(points.iter().copied())?).ok(),
        }
    }
}

/// The points of a query at one time, if they are as many as the kind has.
fn set<K: Kind>(mut points: impl Iterator<Item = Point>) -> Option<K::Points> {
    let mut set = K::Points::default();
    for place in set.as_mut() {
        *place = points.next()?;
    }
    points.next().is_none().then_some(set)
}

/// The motion of the points of a query, given as many curves of one degree.
fn bezier<K: Kind>(curves: &[Vec<Point>]) -> Result<Bezier<K>, InvalidMotion> {
    let count = curves.first().map_or(0, Vec::len);
    let at = |k: usize| set::<K>(curves.iter().filter_map(|curve| curve.get(k).copied()));
    Bezier::new(&(0..count).filter_map(at).collect::<Vec<_>>())
}

/// Reads queries of curved motion one after the other, from files of any size. It ends after the first error.
///
/// Each line is a JSON object with `kind`, the short name of the kind, and with
///
/// - `points`, a list of the control points of each point, for [Bézier curves](Bezier); or
/// - `points`, one place of each point in the coordinates of its body, and `first` and `second`, the motions
///   of both bodies, for [rigid bodies](exact_ccd::motion::Chain). The motions apply from the last to the
///   first; an empty list is a body at rest. A motion has the quaternions `q0` and `q1`, the scalar first,
///   and the places `o0` and `o1` of the origin at t = 0 and t = 1.
///
/// The points are in the order of the kind. A number stands for the nearest f64. The ground truth may follow:
/// `count`, the number of contact times, −1 for infinitely many; and `toi`, the earliest, rounded down to
/// f64, or null. Blank lines are skipped.
pub struct CurvedReader<R> {
    lines: Lines<R>,
    done: bool,
}

impl CurvedReader<File> {
    /// A reader of the queries in a file.
    ///
    /// # Errors
    /// If the file cannot be opened.
    pub fn open(path: &Path) -> Result<Self, DataError> {
        let file = File::open(path).map_err(|source| DataError::io(path, source))?;
        Ok(Self::new(path, file))
    }
}

impl<R: Read> CurvedReader<R> {
    /// A reader of the queries in any text, which errors call `name`. It has a buffer of its own.
    pub fn new(name: impl Into<PathBuf>, text: R) -> Self {
        Self {
            lines: Lines::new(name.into(), text),
            done: false,
        }
    }

    fn record(&mut self) -> Result<Option<CurvedRecord>, DataError> {
        if !self.lines.next()? {
            return Ok(None);
        }
        let record = read::record(self.lines.text());
        record.map(Some).map_err(|problem| DataError::Curved {
            file: self.lines.file().to_owned(),
            line: self.lines.number(),
            problem,
        })
    }
}

impl<R: Read> Iterator for CurvedReader<R> {
    type Item = Result<CurvedRecord, DataError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.done {
            return None;
        }
        let record = self.record().transpose();
        self.done = !matches!(record, Some(Ok(_)));
        record
    }
}
