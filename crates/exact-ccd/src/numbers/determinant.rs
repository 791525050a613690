//! The determinant of three differences of points, and its error.

use super::number::Lanes;
use super::roundoff::{UNIT, margin};
use super::vector::{cross, cross_magnitude, dot};

/// a · (b × c).
#[inline(always)]
pub(crate) fn determinant<T: Lanes>(a: [T; 3], b: [T; 3], c: [T; 3]) -> T {
    dot(a, cross(b, c))
}

/// The error of the determinant of differences.
///
/// The differences are rounded once, and the operations on them make it n = 8 roundings. The underflow in a
/// product is at most 2⁻¹⁰⁷⁵, which only a component of a can enlarge; differences do not underflow.
#[inline(always)]
pub(crate) fn error_of_determinant<T: Lanes>(a: [T; 3], b: [T; 3], c: [T; 3]) -> T {
    const TINY: f64 = f64::from_bits((1023 - 1000) << 52);
    let enlarged = a[0].abs() + a[1].abs() + a[2].abs() + 1.0;
    permanent(a, b, c) * (margin(8) * UNIT) + enlarged * TINY
}

/// The determinant of magnitudes, with sums in place of differences.
#[inline(always)]
fn permanent<T: Lanes>(a: [T; 3], b: [T; 3], c: [T; 3]) -> T {
    let magnitudes = |[x, y, z]: [T; 3]| [x.abs(), y.abs(), z.abs()];
    dot(magnitudes(a), cross_magnitude(magnitudes(b), magnitudes(c)))
}
