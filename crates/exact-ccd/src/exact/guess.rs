//! Guesses of the position of roots, each a cell of a grid over a bracket. A guess may be wrong: the
//! signs at the ends of the cell prove or refute it.
//!
//! Right guesses multiply the number of bits of precision, where bisection adds one bit: the grid of
//! 2ᵇ cells becomes finer after each guess that is right, and coarser after each that is wrong.
//! (Abbott, Quadratic interval refinement for real roots, 2014; Sagraloff, When Newton meets
//! Descartes, 2012.)

use core::cmp::Ordering;

use dashu_int::IBig;

use super::ball::Ball;
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
    let [start, end] = [low, high].map(|t| polynomial.value_at(t, bits));
    // They have different signs: their difference is known as well as they are.
    let length = start.minus(&end, bits + 64);
    let sign = start.sign().unwrap_or(Ordering::Equal);
    let position = start.shifted(bits as isize).quotient(&length).unwrap_or_default();
    (cell(low, high, position, bits), sign)
}

/// The first and the last cell of a bracket, in which roots lie that are near an end of it at several
/// scales.
pub(super) fn boundary(low: &Dyadic, high: &Dyadic, bits: usize) -> [[Dyadic; 2]; 2] {
    [
        [low.clone(), Dyadic::towards(low, high, bits)],
        [Dyadic::towards(high, low, bits), high.clone()],
    ]
}

/// The cells to which a step of Newton's method for a root of this multiplicity leads from the ends of
/// a bracket.
pub(super) fn newton<'a>(
    polynomial: &'a Polynomial,
    multiplicity: usize,
    low: &'a Dyadic,
    high: &'a Dyadic,
    bits: usize,
) -> impl Iterator<Item = [Dyadic; 2]> + 'a {
    let derivative = polynomial.derivative();
    let precision = bits + 64;
    let width = Ball::of_dyadic(&Dyadic::difference(high, low), precision);
    let factor = Ball::of(&multiplicity.into(), precision);
    [(low, IBig::ZERO), (high, IBig::ONE << bits)]
        .into_iter()
        .filter_map(move |(end, position)| {
            let value = polynomial.value_at(end, bits).times(&factor, precision);
            let slope = derivative.value_at(end, bits).times(&width, precision);
            let position = position - value.shifted(bits as isize).quotient(&slope)?;
            let is_inside = position >= IBig::ZERO && position <= IBig::ONE << bits;
            is_inside.then(|| cell(low, high, position, bits))
        })
}

/// The two cells of the grid of 2ᵇ next to its point of this index, without those outside the bracket.
fn cell(low: &Dyadic, high: &Dyadic, index: IBig, bits: usize) -> [Dyadic; 2] {
    let last = IBig::ONE << bits;
    let left = (&index - IBig::ONE).max(IBig::ZERO);
    let right = (index + IBig::ONE).min(last);
    [left, right].map(|index| Dyadic::on_grid(low, high, &index, bits))
}
