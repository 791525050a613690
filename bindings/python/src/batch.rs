//! Many queries in arrays, decided in parallel.

use std::time::{Duration, Instant};

use exact_ccd::batch::{self, Trajectories};
use exact_ccd::{Collision, Options, Separation};
use numpy::{PyReadonlyArray2, PyReadonlyArray3};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::compute::{Watch, compute};
use crate::error::refused;
use crate::kind::ArrayKind;
use crate::pool;

/// The number of queries of a task.
const GRAIN: usize = 4096;

/// The number of queries that a thread decides first, before it checks for the end of the computation.
const FEW: usize = 8;

/// The time from one check to the next. A query takes from some 10⁻⁸ to some 10⁻¹ seconds.
const CHECK_INTERVAL: Duration = Duration::from_millis(20);

/// Queries by their points, or by the indices of vertices and the positions of these at t = 0 and at t = 1.
#[derive(FromPyObject)]
pub(crate) enum Arrays<'py> {
    Points(PyReadonlyArray3<'py, f64>),
    Vertices(
        PyReadonlyArray2<'py, u32>,
        PyReadonlyArray2<'py, f64>,
        PyReadonlyArray2<'py, f64>,
    ),
}

/// The queries of a batch.
enum Queries<'a, K: ArrayKind> {
    Points(&'a [[K::Points; 2]]),
    Vertices(&'a [K::Vertices], Trajectories),
}

/// The reason why there are no answers.
enum Failure {
    Row(usize, String),
    Cancelled,
}

impl<K: ArrayKind> Queries<'_, K> {
    fn count(&self) -> usize {
        match self {
            Self::Points(queries) => queries.len(),
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
        let rows = first..first + answers.len();
        let found = |index: usize, collision: Collision<'_, K>| answers[index] = of(&collision);
        match self {
            Self::Points(queries) => batch::Queries::<K>::new(&queries[rows])
                .collisions(options, found)
                .map_err(|error| Failure::Row(first + error.query, error.source.to_string())),
            Self::Vertices(queries, trajectories) => trajectories
                .collisions::<K>(&queries[rows.clone()], options, found)
                .map_err(|error| {
                    let exist = |row: &usize| trajectories.query::<K>(queries[*row]).is_some();
                    let row = rows.into_iter().find(|row| !exist(row)).unwrap_or(first);
                    Failure::Row(row, error.to_string())
                }),
        }
    }
}

/// An answer for each query: that of its collision, or `none`.
pub(crate) fn answers<K: ArrayKind, T: Clone + Send>(
    py: Python<'_>,
    arrays: &Arrays<'_>,
    min_distance: f64,
    until: f64,
    threads: Option<usize>,
    none: T,
    of: impl Fn(&Collision<'_, K>) -> T + Sync,
) -> PyResult<Vec<T>>
where
    K::Points: Sync,
    K::Vertices: Sync,
{
    pool::check(threads)?;
    let options = Options::within(Separation::new(min_distance).map_err(refused)?).until(until);
    let queries = match arrays {
        Arrays::Points(points) => Queries::Points(K::points(points.as_slice()?)),
        Arrays::Vertices(vertices, x0, x1) => {
            let (x0, x1) = (x0.as_slice()?.as_chunks().0, x1.as_slice()?.as_chunks().0);
            let trajectories = py.detach(|| Trajectories::new(x0, x1)).map_err(refused)?;
            Queries::Vertices(K::vertices(vertices.as_slice()?), trajectories)
        }
    };
    let mut answers = vec![none; queries.count()];
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
