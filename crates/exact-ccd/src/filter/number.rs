//! What the filters compute with: f64 to find an answer, [`DoubleDouble`](super::double_double::DoubleDouble) to find
//! its last bit.

use core::ops::{Add, Mul, Sub};

use crate::kind::{Difference, Kind};
use crate::query::{Point, Query};

/// A number that stands for a real number to within roundings.
pub(crate) trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    fn difference(a: f64, b: f64) -> Self;

    /// The f64 next to it.
    fn value(self) -> f64;
}

impl Number for f64 {
    #[inline]
    fn difference(a: f64, b: f64) -> Self {
        a - b
    }

    #[inline]
    fn value(self) -> f64 {
        self
    }
}

/// The difference of two points at t = 0 and at t = 1.
#[inline]
pub(crate) fn subtract<K: Kind, T: Number>(query: &Query<K>, (i, j): Difference) -> [[T; 3]; 2] {
    let [start, end] = query.points();
    let minus = |a: Point, b: Point| {
        [
            T::difference(a[0], b[0]),
            T::difference(a[1], b[1]),
            T::difference(a[2], b[2]),
        ]
    };
    [minus(start[i], start[j]), minus(end[i], end[j])]
}

/// The larger magnitude of a coordinate at the two times.
#[inline]
pub(crate) fn reach<T: Number, const N: usize>([a, b]: &[[T; N]; 2]) -> [f64; N] {
    core::array::from_fn(|axis| {
        let (a, b) = (a[axis].value().abs(), b[axis].value().abs());
        if a > b { a } else { b }
    })
}
