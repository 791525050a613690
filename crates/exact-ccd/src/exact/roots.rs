//! The roots of polynomials in the step.
//!
//! Between two neighbouring roots of its derivative, a polynomial is monotone: it has one root there if
//! it has different signs at the two, and otherwise none. So the roots of the derivative are found first,
//! from the roots of the second derivative, and so on. Repeated roots (grazing) are made simple before. All
//! roots are then simple roots of a polynomial or a derivative, to which secants lead in few steps, however
//! near to each other they are.

use alloc::sync::Arc;
use alloc::vec::Vec;
use core::cmp::Ordering;

use dashu_int::IBig;

use super::approximation::Approximation;
use super::bracket::{Bracket, End};
use super::instant::Instant;
use super::polynomial::Polynomial;
use super::split::Split;

/// The distinct roots in [0, 1] of polynomials that are not zero, in increasing order.
pub(crate) fn roots(polynomials: Vec<Polynomial>) -> Vec<Instant> {
    let mut all = Vec::new();
    for polynomial in polynomials {
        for root in roots_of(&polynomial) {
            root.insert_into(&mut all);
        }
    }
    all
}

/// The distinct roots in [0, 1] of a polynomial that is not zero, in increasing order.
pub(crate) fn roots_of(polynomial: &Polynomial) -> Vec<Instant> {
    let is_root = |end: &Split| polynomial.sign_at(end).is_eq();
    let [first, last] = [Split::START, Split::END].map(|end| is_root(&end).then(|| Instant::At(end)));
    let inner = inner_roots(&polynomial.reduced());
    first.into_iter().chain(inner).chain(last).collect()
}

/// The roots of a polynomial that is not zero at t = 0 and t = 1.
///
/// The degree of the derivative is less: the recursion ends.
fn inner_roots(polynomial: &Polynomial) -> Vec<Instant> {
    match changes_of_sign(polynomial) {
        0 => Vec::new(),
        1 => {
            let ends = [Split::START, Split::END].map(|end| End::of(polynomial, &end));
            [simple(polynomial, ends)].into()
        }
        _ => between_extrema(&polynomial.square_free()),
    }
}

/// The number of changes in the sequence of the signs of coefficients that are not zero: a bound of the
/// number of roots inside the step, counted with multiplicity, which has the parity of that number
/// (Descartes' rule).
fn changes_of_sign(polynomial: &Polynomial) -> usize {
    let signs = polynomial.coefficients().iter().map(|c| c.cmp(&IBig::ZERO));
    let nonzero: Vec<Ordering> = signs.filter(|sign| sign.is_ne()).collect();
    nonzero.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// The roots of a polynomial, all of them simple, by the roots of its derivative.
fn between_extrema(polynomial: &Polynomial) -> Vec<Instant> {
    let mut times = inner_roots(&polynomial.slope().reduced());
    times.insert(0, Instant::At(Split::START));
    times.push(Instant::At(Split::END));
    let mut roots = Vec::new();
    let mut last: Option<(Approximation, Instant)> = None;
    for mut time in times {
        // All values in the closed bracket of the time, with one sign.
        let value = time.narrow_to_value(polynomial);
        if value.middle.is_zero() {
            roots.push(time.clone());
        } else if let Some((before, earlier)) = last
            && !before.middle.is_zero()
            && before.sign() != value.sign()
        {
            let ends = [(earlier.bounds().1, before), (time.bounds().0, value.clone())];
            roots.push(simple(
                polynomial,
                ends.map(|(time, value)| End::new(time, value)),
            ));
        }
        last = Some((value, time));
    }
    roots
}

/// The only root of a polynomial in an interval, a simple one.
fn simple(polynomial: &Polynomial, ends: [End; 2]) -> Instant {
    let mut root = Instant::Root(Bracket::new(Arc::new(polynomial.clone()), ends));
    // In a narrow bracket, most signs are easily proved.
    root.narrow_to(16);
    root
}

#[cfg(test)]
mod tests;
