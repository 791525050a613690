//! The answers to queries in arrays.

use exact_ccd::Collision;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

use crate::batch::{Arrays, answers};
use crate::impact::{COLUMNS, columns};
use crate::kind::{ArrayKind, for_kind};

/// Contact or none.
#[pyfunction]
pub(crate) fn collides<'py>(
    py: Python<'py>,
    kind: &str,
    arrays: Arrays<'py>,
    min_distance: f64,
    threads: Option<usize>,
) -> PyResult<Bound<'py, PyArray1<bool>>> {
    let answers =
        for_kind!(kind, K => answers::<K, _>(py, &arrays, min_distance, 1.0, threads, false, |_| true))?;
    Ok(PyArray1::from_vec(py, answers))
}

/// The first time of contact, rounded down, or NaN.
#[pyfunction]
#[expect(
    clippy::redundant_closure_for_method_calls,
    reason = "the method is not general enough over lifetimes"
)]
pub(crate) fn time_of_impact<'py>(
    py: Python<'py>,
    kind: &str,
    arrays: Arrays<'py>,
    min_distance: f64,
    threads: Option<usize>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let answers = for_kind!(kind, K => {
        answers::<K, _>(py, &arrays, min_distance, 1.0, threads, f64::NAN, |c| c.time_of_impact())
    })?;
    Ok(PyArray1::from_vec(py, answers))
}

/// As [`time_of_impact`], and NaN too if the first contact is after `until`: the contact itself is compared,
/// not the f64 below it. On the thread of the caller.
#[pyfunction]
#[expect(
    clippy::redundant_closure_for_method_calls,
    reason = "the method is not general enough over lifetimes"
)]
pub(crate) fn time_until<'py>(
    py: Python<'py>,
    kind: &str,
    arrays: Arrays<'py>,
    min_distance: f64,
    until: f64,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let answers = for_kind!(kind, K => {
        answers::<K, _>(py, &arrays, min_distance, until, Some(1), f64::NAN, |c| c.time_of_impact())
    })?;
    Ok(PyArray1::from_vec(py, answers))
}

/// The number of contact times, −1 for infinitely many; with a distance, the number of intervals.
#[pyfunction]
pub(crate) fn contact_count<'py>(
    py: Python<'py>,
    kind: &str,
    arrays: Arrays<'py>,
    min_distance: f64,
    threads: Option<usize>,
) -> PyResult<Bound<'py, PyArray1<i64>>> {
    let answers = for_kind!(kind, K => answers::<K, _>(py, &arrays, min_distance, 1.0, threads, 0, count))?;
    Ok(PyArray1::from_vec(py, answers))
}

fn count<K: ArrayKind>(collision: &Collision<'_, K>) -> i64 {
    let intervals = collision.intervals();
    let count = if collision.separation().is_zero() {
        intervals.count()
    } else {
        Some(intervals.len())
    };
    // At most some dozens.
    count.map_or(-1, |count| count as i64)
}

/// The first time of contact, rounded down, or NaN, and the number of contact times.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "a tuple for Python")]
pub(crate) fn time_and_count<'py>(
    py: Python<'py>,
    kind: &str,
    arrays: Arrays<'py>,
    min_distance: f64,
    threads: Option<usize>,
) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i64>>)> {
    let answers = for_kind!(kind, K => {
        let of = |collision: &Collision<'_, K>| (collision.time_of_impact(), count(collision));
        answers::<K, _>(py, &arrays, min_distance, 1.0, threads, (f64::NAN, 0), of)
    })?;
    let (times, counts) = answers.into_iter().unzip();
    Ok((PyArray1::from_vec(py, times), PyArray1::from_vec(py, counts)))
}

/// The intervals of contact of all queries, each end rounded down, and the index of the first of each
/// query.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "a tuple for Python")]
pub(crate) fn contact_times<'py>(
    py: Python<'py>,
    kind: &str,
    arrays: Arrays<'py>,
    min_distance: f64,
    threads: Option<usize>,
) -> PyResult<(Bound<'py, PyArray1<i64>>, Bound<'py, PyArray2<f64>>)> {
    let answers = for_kind!(kind, K => {
        answers::<K, _>(py, &arrays, min_distance, 1.0, threads, Vec::new(), intervals)
    })?;
    let mut offsets = Vec::with_capacity(answers.len() + 1);
    offsets.push(0);
    for intervals in &answers {
        offsets.push(offsets[offsets.len() - 1] + intervals.len() as i64);
    }
    let ends: Vec<f64> = answers.into_iter().flatten().flatten().collect();
    let shape = [ends.len() / 2, 2];
    Ok((
        PyArray1::from_vec(py, offsets),
        PyArray1::from_vec(py, ends).reshape(shape)?,
    ))
}

fn intervals<K: ArrayKind>(collision: &Collision<'_, K>) -> Vec<[f64; 2]> {
    let intervals = collision.intervals().into_iter();
    intervals
        .map(|interval| [interval.start.lower(), interval.end.lower()])
        .collect()
}

/// The columns of the impacts.
#[pyfunction]
pub(crate) fn impacts<'py>(
    py: Python<'py>,
    kind: &str,
    arrays: Arrays<'py>,
    min_distance: f64,
    threads: Option<usize>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let none = [f64::NAN; COLUMNS];
    let answers = for_kind!(kind, K => {
        let of = |collision: &Collision<'_, K>| columns::<K>(collision.query(), &collision.impact());
        answers::<K, _>(py, &arrays, min_distance, 1.0, threads, none, of)
    })?;
    let shape = [answers.len(), COLUMNS];
    PyArray1::from_vec(py, answers.into_flattened()).reshape(shape)
}
