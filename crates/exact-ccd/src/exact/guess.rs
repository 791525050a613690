//! Guesses of the position of a root, each a cell of a grid over a bracket. A guess may be wrong: the
//! signs at the ends of the cell prove or refute it.
//!
//! Right guesses multiply the number of bits of precision, where bisection adds one bit: the grid of
//! 2ᵇ cells becomes finer after each guess that is right, and coarser after each that is wrong.
//! (Abbott, Quadratic interval refinement for real roots, 2014.)

use dashu_int::IBig;
use dashu_int::ops::DivEuclid;

use super::approximation::Approximation;
use super::split::Split;

/// The two cells next to the zero of the linear interpolant of two values with different signs at the
/// ends of a bracket.
pub(super) fn secant(values: [&Approximation; 2], low: &Split, high: &Split, bits: usize) -> [Split; 2] {
    let digits = bits + 8;
    let unit = values[0].top().max(values[1].top()) - digits as isize;
    let [start, end] = values.map(|value| value.in_units(unit));
    let length = &start - end;
    let twice = if length == IBig::ZERO {
        IBig::ONE << bits
    } else {
        (start << (bits + 1)).div_euclid(length)
    };
    cell(low, high, (twice + IBig::ONE) >> 1, bits)
}

/// The two cells next to the point of this index of the grid of 2ᵇ cells, cut off at the ends of the bracket.
fn cell(low: &Split, high: &Split, index: IBig, bits: usize) -> [Split; 2] {
    let last = IBig::ONE << bits;
    let left = (&index - IBig::ONE).max(IBig::ZERO);
    let right = (index + IBig::ONE).min(last);
    [left, right].map(|index| Split::on_grid(low, high, &index, bits))
}

/// The time at a distance of 2⁻ᵏ of the bracket from one end.
pub(super) fn near_end(low: &Split, high: &Split, from_low: bool, halvings: usize) -> Split {
    let index = if from_low {
        IBig::ONE
    } else {
        (IBig::ONE << halvings) - IBig::ONE
    };
    Split::on_grid(low, high, &index, halvings)
}
