//! Positions as the caller has them.

use std::array::from_fn;
use std::borrow::Cow;

use exact_ccd::{Kind, Point};
use numpy::ndarray::{ArrayView2, ArrayView3, Axis};
use numpy::{PyArray3, PyReadonlyArray2, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::error::refused;

/// Rows of points, of shape (rows, points, 3), with any strides. Every float32 is a float64.
pub(crate) enum Positions<'py> {
    Double(PyReadonlyArray3<'py, f64>),
    Single(PyReadonlyArray3<'py, f32>),
}

impl<'a, 'py> FromPyObject<'a, 'py> for Positions<'py> {
    type Error = PyErr;

    fn extract(array: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        // An error of `extract` for the first type would cost more than most queries.
        if array.cast::<PyArray3<f32>>().is_ok() {
            return array.extract().map(Self::Single);
        }
        array.extract().map(Self::Double)
    }
}

impl Positions<'_> {
    /// The rows at t = 0 and at t = 1, without the interpreter; as many of both.
    pub(crate) fn ends<'a>(x0: &'a Self, x1: &'a Self) -> PyResult<[Rows<'a>; 2]> {
        let (start, end) = (x0.shape(), x1.shape());
        if start != end {
            return Err(refused(format_args!(
                "x1 has the shape {end:?}, expected that of x0: {start:?}"
            )));
        }
        Ok([x0.rows(), x1.rows()])
    }

    fn shape(&self) -> &[usize] {
        match self {
            Self::Double(array) => array.shape(),
            Self::Single(array) => array.shape(),
        }
    }

    pub(crate) fn rows(&self) -> Rows<'_> {
        match self {
            Self::Double(array) => Rows::Double(array.as_array()),
            Self::Single(array) => Rows::Single(array.as_array()),
        }
    }
}

/// The same without the interpreter.
#[derive(Clone, Copy)]
pub(crate) enum Rows<'a> {
    Double(ArrayView3<'a, f64>),
    Single(ArrayView3<'a, f32>),
}

impl<'a> Rows<'a> {
    /// The number of rows.
    pub(crate) fn count(&self) -> usize {
        match self {
            Self::Double(rows) => rows.len_of(Axis(0)),
            Self::Single(rows) => rows.len_of(Axis(0)),
        }
    }

    /// The points of a row: in place, if they are contiguous float64.
    pub(crate) fn row(self, row: usize) -> Cow<'a, [Point]> {
        match self {
            Self::Double(rows) => {
                let row = rows.index_axis_move(Axis(0), row);
                match row.to_slice() {
                    Some(slice) => Cow::Borrowed(slice.as_chunks().0),
                    None => Cow::Owned(converted(&row)),
                }
            }
            Self::Single(rows) => Cow::Owned(converted(&rows.index_axis_move(Axis(0), row))),
        }
    }

    /// The points of a query in a row, which has as many.
    #[inline]
    pub(crate) fn query<K: Kind>(&self, row: usize) -> K::Points {
        match self {
            Self::Double(rows) => query::<K, _>(&rows.index_axis(Axis(0), row)),
            Self::Single(rows) => query::<K, _>(&rows.index_axis(Axis(0), row)),
        }
    }
}

fn converted<T: Copy + Into<f64>>(row: &ArrayView2<'_, T>) -> Vec<Point> {
    (0..row.nrows())
        .map(|i| from_fn(|axis| row[[i, axis]].into()))
        .collect()
}

#[inline]
fn query<K: Kind, T: Copy + Into<f64>>(row: &ArrayView2<'_, T>) -> K::Points {
    let mut points = K::Points::default();
    let places = points.as_mut();
    let contiguous = row.to_slice().map(|row| row.as_chunks::<3>().0);
    match contiguous.and_then(|given| given.get(..places.len())) {
        Some(given) => {
            for (place, point) in places.iter_mut().zip(given) {
                *place = point.map(Into::into);
            }
        }
        None => {
            for (i, place) in places.iter_mut().enumerate() {
                *place = from_fn(|axis| row[[i, axis]].into());
            }
        }
    }
    points
}

/// The points of an array of shape (V, 3).
pub(crate) fn points<'a>(positions: &'a PyReadonlyArray2<'_, f64>) -> PyResult<&'a [Point]> {
    Ok(positions.as_slice()?.as_chunks().0)
}
