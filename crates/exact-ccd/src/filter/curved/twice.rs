//! Motions at a time, in twice the precision.

use super::counted::Counted;
use super::polynomial::{Function, Polynomial};
use crate::numbers::double_double::DoubleDouble;

/// A number in twice the precision.
pub(super) type Twice = Counted<DoubleDouble>;

/// The point of a Bézier curve at a time, by de Casteljau's scheme.
pub(super) fn on_curve<const N: usize>(control: &[[f64; N]], [s, t]: [Twice; 2]) -> [Twice; N] {
    core::array::from_fn(|i| {
        let row = control.iter().map(|point| Counted::exactly(point[i]));
        let mut row: Polynomial<Twice> = row.collect();
        while row.len() > 1 {
            for k in 1..row.len() {
                row[k - 1] = s * row[k - 1] + t * row[k];
            }
            row.pop();
        }
        row[0]
    })
}

impl Function for Twice {
    fn negated(&self) -> Self {
        -*self
    }

    fn doubled(&self) -> Self {
        *self * 2.0
    }

    fn sum(&self, other: &Self) -> Self {
        *self + *other
    }

    fn difference(&self, other: &Self) -> Self {
        *self - *other
    }

    fn product(&self, other: &Self) -> Self {
        *self * *other
    }

    fn count(&self) -> usize {
        1
    }

    /// A value has no degree.
    fn elevate(&mut self, _: usize) {}
}
