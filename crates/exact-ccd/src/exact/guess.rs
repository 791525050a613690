//! Guesses of the position of roots, each a cell of a grid over a bracket. A guess may be wrong: the
//! signs at the ends of the cell prove or refute it.
//!
//! Right guesses multiply the number of bits of precision, where bisection adds one bit: the grid of
//! 2ᵇ cells becomes finer after each guess that is right, and coarser after each that is wrong.
//! (Abbott, Quadratic interval refinement for real roots, 2014; Sagraloff, When Newton meets
//! Descartes, 2012.)

use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::DivEuclid;

use super::dyadic::Dyadic;
use super::polynomial::Polynomial;

/// The cell around the zero of the linear interpolant of a polynomial with different signs at the ends
/// of a bracket, and its sign at the lower end.
pub(super) fn secant(
    polynomial: &Polynomial,
    low: &Dyadic,
    high: &Dyadic,
    bits: usize,
) -> ([Dyadic; 2], Ordering) {
    let ([a, b], exponent) = Dyadic::align(low, high);
    let [start, end] = [a, b].map(|t| polynomial.scaled_value(&t, exponent));
    let sign = start.cmp(&IBig::ZERO);
    let length = &start - end;
    (cell(low, high, quotient(start, length, bits), bits), sign)
}

/// The cells to which a step of Newton's method for a root of this multiplicity leads from the ends of
/// a bracket.
pub(super) fn newton(
    polynomial: &Polynomial,
    multiplicity: usize,
    low: &Dyadic,
    high: &Dyadic,
    bits: usize,
) -> impl Iterator<Item = [Dyadic; 2]> {
    let derivative = polynomial.derivative();
    let ([a, b], exponent) = Dyadic::align(low, high);
    let width = &b - &a;
    [(a, IBig::ZERO), (b, IBig::ONE << bits)]
        .into_iter()
        .filter_map(move |(end, position)| {
            let value = polynomial.scaled_value(&end, exponent) * IBig::from(multiplicity);
            let slope = derivative.scaled_value(&end, exponent) * &width;
            let step = (!slope.is_zero()).then(|| quotient(value, slope, bits))?;
            let position = position - step;
            let is_inside = position >= IBig::ZERO && position <= IBig::ONE << bits;
            is_inside.then(|| cell(low, high, position, bits))
        })
}

/// 2ᵇ a / b, rounded.
fn quotient(a: IBig, b: IBig, bits: usize) -> IBig {
    ((a << (bits + 1)).div_euclid(b) + IBig::ONE) >> 1
}

/// The two cells of the grid of 2ᵇ next to its point of this index, without those outside the bracket.
fn cell(low: &Dyadic, high: &Dyadic, index: IBig, bits: usize) -> [Dyadic; 2] {
    let last = IBig::ONE << bits;
    let left = (&index - IBig::ONE).max(IBig::ZERO);
    let right = (index + IBig::ONE).min(last);
    [left, right].map(|index| Dyadic::on_grid(low, high, &index, bits))
}
