//! The answers to queries in arrays.

use exact_ccd::{Collision, Kind, with_kind};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::batch::{Arrays, Settings, answers};
use crate::impact::{COLUMNS, columns_of_query};
use crate::kind::kind_of;
use crate::mesh::{List, Table, rows};

/// Contact or none.
#[pyfunction]
pub(crate) fn collides<'py>(
    py: Python<'py>,
    queries: Arrays<'py>,
    settings: Settings,
) -> PyResult<List<'py, bool>> {
    let answers =
        with_kind!(kind_of(queries.0)?, K => answers::<K, _>(py, &queries, &settings, false, |_| true))?;
    Ok(PyArray1::from_vec(py, answers))
}

/// The first time of contact, rounded down, or NaN.
#[pyfunction]
pub(crate) fn time_of_impact<'py>(
    py: Python<'py>,
    queries: Arrays<'py>,
    settings: Settings,
) -> PyResult<List<'py, f64>> {
    let answers =
        with_kind!(kind_of(queries.0)?, K => answers::<K, _>(py, &queries, &settings, f64::NAN, time))?;
    Ok(PyArray1::from_vec(py, answers))
}

fn time<K: Kind>(collision: &Collision<'_, K>) -> f64 {
    collision.time_of_impact()
}

/// The first time of contact, rounded down, or NaN, and the number of contact times: −1 for infinitely many;
/// with a distance, the number of intervals.
#[pyfunction]
pub(crate) fn time_and_count<'py>(
    py: Python<'py>,
    queries: Arrays<'py>,
    settings: Settings,
) -> PyResult<(List<'py, f64>, List<'py, i64>)> {
    let answers = with_kind!(kind_of(queries.0)?, K => {
        let of = |collision: &Collision<'_, K>| (time(collision), count(collision));
        answers::<K, _>(py, &queries, &settings, (f64::NAN, 0), of)
    })?;
    let (times, counts) = answers.into_iter().unzip();
    Ok((PyArray1::from_vec(py, times), PyArray1::from_vec(py, counts)))
}

fn count<K: Kind>(collision: &Collision<'_, K>) -> i64 {
    let intervals = collision.intervals();
    let count = if collision.separation().is_zero() {
        intervals.count()
    } else {
        Some(intervals.len())
    };
    // At most some dozens.
    count.map_or(-1, |count| count as i64)
}

/// The index of the first interval of contact of each query, and the ends of the intervals, rounded down.
#[pyfunction]
pub(crate) fn intervals<'py>(
    py: Python<'py>,
    queries: Arrays<'py>,
    settings: Settings,
) -> PyResult<(List<'py, i64>, Table<'py, f64>)> {
    let answers =
        with_kind!(kind_of(queries.0)?, K => answers::<K, _>(py, &queries, &settings, Vec::new(), ends))?;
    let offsets = offsets(py, answers.iter().map(Vec::len));
    Ok((offsets, rows(py, answers.into_iter().flatten())?))
}

fn ends<K: Kind>(collision: &Collision<'_, K>) -> Vec<[f64; 2]> {
    let intervals = collision.intervals().into_iter();
    intervals
        .map(|interval| [interval.start.lower(), interval.end.lower()])
        .collect()
}

/// The places at which parts of these lengths begin, and the end of the last one.
pub(crate) fn offsets(py: Python<'_>, lengths: impl Iterator<Item = usize>) -> List<'_, i64> {
    let mut end = 0;
    let ends = lengths.map(|length| {
        end += length as i64;
        end
    });
    PyArray1::from_iter(py, std::iter::once(0).chain(ends))
}

/// The columns of the impacts.
#[pyfunction]
pub(crate) fn impact<'py>(
    py: Python<'py>,
    queries: Arrays<'py>,
    settings: Settings,
) -> PyResult<Table<'py, f64>> {
    let none = [f64::NAN; COLUMNS];
    let answers = with_kind!(kind_of(queries.0)?, K => {
        let of = |collision: &Collision<'_, K>| columns_of_query(collision.query(), &collision.impact());
        answers::<K, _>(py, &queries, &settings, none, of)
    })?;
    rows(py, answers)
}
