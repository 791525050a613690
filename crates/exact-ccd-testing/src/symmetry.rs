//! Changes of a query that do not change the times at which its primitives touch, bit for bit.

use exact_ccd::Separation;

use crate::kinds::{Renamed, query};
use crate::laws::assert_same_times;
use crate::primitives::Points;

/// A permutation of the points and of the axes, with mirrored and stretched axes.
#[derive(Clone, Copy, Debug)]
pub struct Symmetry {
    /// The index of an order of the points that describes the same primitives.
    pub renaming: usize,
    /// For each axis, the axis that replaces it.
    pub axes: [usize; 3],
    /// True for each mirrored axis.
    pub mirrored: [bool; 3],
    /// The exponents of the powers of two by which the axes are stretched, unless that would round. A
    /// distance above 0 has one unit for all axes, which is stretched by the first one.
    pub exponents: [i32; 3],
}

impl Symmetry {
    fn apply<K: Renamed>(&self, points: &Points, d: Separation) -> (Points, Separation) {
        let on_axis = |axis: usize| points.as_flattened().iter().map(move |point| point[axis]);
        let powers = if d.is_zero() {
            [0, 1, 2].map(|axis| power(self.exponents[axis], on_axis(axis)))
        } else {
            [power(self.exponents[0], (0..3).flat_map(on_axis).chain([d.get()])); 3]
        };
        let factor = |axis: usize| {
            if self.mirrored[axis] {
                -powers[axis]
            } else {
                powers[axis]
            }
        };
        let order = K::RENAMINGS[self.renaming % K::RENAMINGS.len()];
        let image =
            points.map(|now| order.map(|point| self.axes.map(|axis| now[point][axis] * factor(axis))));
        (image, Separation::new(d.get() * powers[0]).unwrap())
    }
}

/// The power of two with an exponent, or 1 if a product of it and one of the numbers would be rounded.
fn power(exponent: i32, mut numbers: impl Iterator<Item = f64>) -> f64 {
    let power = 2f64.powi(exponent);
    let all_exact = numbers.all(|x| (x * power).is_finite() && x * power / power == x);
    if all_exact { power } else { 1.0 }
}

/// Checks that a symmetry does not change the times.
pub fn assert_symmetric<K: Renamed>(points: &Points, d: Separation, symmetry: &Symmetry) {
    let (image, image_d) = symmetry.apply::<K>(points, d);
    assert_same_times((&query::<K>(points), d), (&query::<K>(&image), image_d));
}
