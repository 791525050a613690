//! Many queries in arrays, decided in parallel.

use std::time::{Duration, Instant};

use exact_ccd::batch::{self, Trajectories, VertexOutOfRange};
use exact_ccd::{Collision, Kind, Options, Separation};
use numpy::PyReadonlyArray2;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::compute::{Watch, compute};
use crate::error::{refused, room};
use crate::positions::{Positions, Rows};

/// The number of queries of a task.
const GRAIN: usize = 4096;

/// The number of queries whose points are gathered at a time: 48 KiB at most.
const BLOCK: usize = 256;

/// The number of queries that a thread decides first, before it checks for the end of the computation.
const FEW: usize = 8;

/// The time from one check to the next. A query takes from some 10⁻⁸ to some 10⁻¹ seconds.
const CHECK_INTERVAL: Duration = Duration::from_millis(20);

/// Queries of one kind, given by its number and the positions at t = 0 and at t = 1: of the points of each
/// query, or of vertices, and then the vertices of each query.
#[derive(FromPyObject)]
pub(crate) struct Arrays<'py>(
    pub(crate) u8,
    Positions<'py>,
    Positions<'py>,
    Option<PyReadonlyArray2<'py, u32>>,
);

/// The distance at which primitives touch, the last time that counts, and the number of threads.
#[derive(FromPyObject)]
pub(crate) struct Settings(f64, f64, Option<usize>);

/// The queries of a batch.
enum Queries<'a, K: Kind> {
    Points([Rows<'a>; 2]),
    Vertices(&'a [K::Vertices], Trajectories),
}

/// The reason why there are no answers.
enum Failure {
    Row(usize, String),
    Cancelled,
}

impl<K: Kind> Queries<'_, K> {
    fn count(&self) -> usize {
        match self {
            Self::Points([start, _]) => start.count(),
            Self::Vertices(queries, _) => queries.len(),
        }
    }

    /// The answers of some queries from `first` on, in place of the default.
    fn answer<T>(
        &self,
        options: Options,
        first: usize,
        answers: &mut [T],
        of: impl Fn(&Collision<'_, K>) -> T,
    ) -> Result<(), Failure> {
        match self {
            Self::Points([start, end]) => {
                let mut points = Vec::with_capacity(BLOCK.min(answers.len()));
                for (block, answers) in answers.chunks_mut(BLOCK).enumerate() {
                    let first = first + BLOCK * block;
                    let rows = first..first + answers.len();
                    points.clear();
                    points.extend(rows.map(|row| [start, end].map(|rows| rows.query::<K>(row))));
                    batch::Queries::<K>::new(&points)
                        .collisions(options, |index, collision| answers[index] = of(&collision))
                        .map_err(|error| Failure::Row(first + error.query, error.source.to_string()))?;
                }
                Ok(())
            }
            Self::Vertices(queries, trajectories) => {
                let rows = first..first + answers.len();
                trajectories
                    .collisions::<K>(&queries[rows.clone()], options, |index, collision| {
                        answers[index] = of(&collision);
                    })
                    .map_err(|error| {
                        let exist = |row: &usize| trajectories.query::<K>(queries[*row]).is_some();
                        let row = rows.into_iter().find(|row| !exist(row)).unwrap_or(first);
                        let VertexOutOfRange {
                            vertex, vertex_count, ..
                        } = error;
                        Failure::Row(row, format!("vertex {vertex}, expected one below {vertex_count}"))
                    })
            }
        }
    }
}

/// An answer for each query: that of its collision, or `none`.
pub(crate) fn answers<K: Kind, T: Clone + Send>(
    py: Python<'_>,
    Arrays(_, x0, x1, vertices): &Arrays<'_>,
    &Settings(separation, until, threads): &Settings,
    none: T,
    of: impl Fn(&Collision<'_, K>) -> T + Sync,
) -> PyResult<Vec<T>> {
    let separation = Separation::new(separation);
    let separation = separation.map_err(|error| refused(format_args!("separation: {error}")))?;
    let options = Options::within(separation).until(until);
    let ends = Positions::ends(x0, x1)?;
    let queries = match vertices {
        None => Queries::Points(ends),
        Some(vertices) => {
            let trajectories = py.detach(|| {
                let [x0, x1] = ends.map(|rows| rows.row(0));
                Trajectories::new(&x0, &x1)
            });
            Queries::Vertices(K::queries(vertices.as_slice()?), trajectories.map_err(refused)?)
        }
    };
    let mut answers = room(queries.count())?;
    answers.resize(queries.count(), none);
    let watch = Watch::default();
    let answer = |(chunk, mut answers): (usize, &mut [T])| {
        let (mut first, mut count) = (GRAIN * chunk, FEW);
        while !answers.is_empty() {
            if watch.is_cancelled() {
                return Err(Failure::Cancelled);
            }
            let clock = Instant::now();
            let (next, rest) = answers.split_at_mut(count.min(answers.len()));
            queries.answer(options, first, next, &of)?;
            (first, answers) = (first + next.len(), rest);
            count = if clock.elapsed() < CHECK_INTERVAL {
                2 * count
            } else {
                1 + count / 8
            };
        }
        Ok(())
    };
    let failure = if answers.len() <= FEW {
        py.detach(|| answer((0, &mut answers)).err())
    } else {
        let chunks = answers.par_chunks_mut(GRAIN).enumerate();
        let work = || chunks.map(answer).find_map_first(Result::err);
        compute(py, threads, None, &watch, work)?
    };
    match failure {
        None => Ok(answers),
        Some(Failure::Row(row, message)) => Err(refused(format_args!("row {row}: {message}"))),
        Some(Failure::Cancelled) => Err(PyKeyboardInterrupt::new_err(())),
    }
}
