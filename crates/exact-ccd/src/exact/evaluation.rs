//! Values and signs of polynomials, at a precision that rises until they are known.

use alloc::vec::Vec;
use core::cmp::Ordering;

use dashu_int::ops::BitTest;

use super::ball::{Ball, LEAST_PRECISION, with_precision};
use super::dyadic::Dyadic;
use super::polynomial::Polynomial;

impl Polynomial {
    /// The sign of the value at t.
    pub(crate) fn sign_at(&self, t: &Dyadic) -> Ordering {
        with_precision(digits(&[t]), |precision| self.at(t, precision).sign())
    }

    /// The value at t, in a ball whose radius is at most 2⁻ᵏ of its middle.
    pub(super) fn value_at(&self, t: &Dyadic, bits: usize) -> Ball {
        with_precision(digits(&[t]) + bits, |precision| {
            let value = self.at(t, precision);
            value.is_known_to(bits).then_some(value)
        })
    }

    /// The sign in the whole interval (low, high), if Horner's scheme or Descartes' rule proves it at the
    /// precision of the interval's ends.
    ///
    /// At a number at which the polynomial does not vanish, every bracket that is narrow enough has a
    /// sign. Horner's scheme proves it there. Descartes' rule takes several times as long, and proves
    /// more in wide brackets.
    pub(crate) fn sign_between(&self, low: &Dyadic, high: &Dyadic) -> Option<Ordering> {
        let precision = digits(&[low, high]);
        let values = self.value(&Ball::between(low, high, precision), precision);
        values.sign().or_else(|| {
            let is_wide = precision < 4 * LEAST_PRECISION;
            let (changes, sign) = is_wide.then(|| self.changes(low, high, precision))??;
            (changes == 0).then_some(sign)
        })
    }

    /// The number of sign changes in the coefficients of (1 + s)ᵈ q((high + low s) / (1 + s)), and
    /// the first sign that is not zero.
    ///
    /// By Descartes' rule, the number of roots of q in (low, high), counted with multiplicity, is
    /// the number of sign changes or less than that by an even number.
    pub(crate) fn sign_changes(&self, low: &Dyadic, high: &Dyadic) -> (usize, Ordering) {
        with_precision(digits(&[low, high]), |precision| {
            self.changes(low, high, precision)
        })
    }

    /// The sign changes and the first sign, if this precision suffices for them.
    fn changes(&self, low: &Dyadic, high: &Dyadic, precision: usize) -> Option<(usize, Ordering)> {
        let coefficients = self.descartes(low, high, precision);
        let signs = coefficients.iter().map(Ball::sign).collect::<Option<Vec<_>>>()?;
        let (mut first, mut last, mut changes) = (Ordering::Equal, Ordering::Equal, 0);
        for sign in signs.into_iter().filter(|sign| sign.is_ne()) {
            if first.is_eq() {
                first = sign;
            }
            changes += usize::from(last == sign.reverse());
            last = sign;
        }
        Some((changes, first))
    }

    fn at(&self, t: &Dyadic, precision: usize) -> Ball {
        self.value(&Ball::of_dyadic(t, precision), precision)
    }

    /// A ball of the values in a ball, by Horner's scheme.
    fn value(&self, t: &Ball, precision: usize) -> Ball {
        self.balls(precision)
            .iter()
            .rev()
            .fold(Ball::ZERO, |sum, coefficient| {
                sum.times(t, precision).plus(coefficient, precision)
            })
    }

    /// The coefficients of (1 + s)ᵈ q((high + low s) / (1 + s)), from the constant one up: those of
    /// q(low + (high − low) s), backwards, at s + 1.
    fn descartes(&self, low: &Dyadic, high: &Dyadic, precision: usize) -> Vec<Ball> {
        let width = Ball::of_dyadic(&Dyadic::difference(high, low), precision);
        let mut coefficients = self.balls(precision);
        shift(&mut coefficients, &Ball::of_dyadic(low, precision), precision);
        let mut factor = width.clone();
        for coefficient in coefficients.iter_mut().skip(1) {
            *coefficient = coefficient.times(&factor, precision);
            factor = factor.times(&width, precision);
        }
        coefficients.reverse();
        shift(
            &mut coefficients,
            &Ball::of_dyadic(&Dyadic::ONE, precision),
            precision,
        );
        coefficients
    }

    fn balls(&self, precision: usize) -> Vec<Ball> {
        let rounded = |coefficient| Ball::of(coefficient, precision);
        self.coefficients().iter().map(rounded).collect()
    }
}

/// The precision at which to begin: that of the numbers. A number with many digits is one near a root, at
/// which as many digits of the terms cancel.
fn digits(numbers: &[&Dyadic]) -> usize {
    let lengths = numbers.iter().map(|x| x.numerator.bit_len());
    LEAST_PRECISION + lengths.max().unwrap_or_default()
}

/// The coefficients of q(s + x) from those of q, by Horner's scheme for q and its derivatives.
fn shift(coefficients: &mut [Ball], x: &Ball, precision: usize) {
    for lowest in 0..coefficients.len() {
        for i in (lowest + 1..coefficients.len()).rev() {
            let product = coefficients[i].times(x, precision);
            coefficients[i - 1] = coefficients[i - 1].plus(&product, precision);
        }
    }
}

#[cfg(test)]
mod tests;
