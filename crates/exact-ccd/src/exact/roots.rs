//! The roots of polynomials in an interval.
//!
//! Between two neighbouring roots of its derivative, a polynomial is monotone: it has one root there if
//! it has different signs at the two, and otherwise none. So roots are found from the roots of the
//! derivative, these from those of the second one, and so on. Repeated roots (grazing) are made simple
//! before. All of them are simple roots of some derivative, to which secants lead in few steps, however
//! near to each other they are.

use alloc::sync::Arc;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::approximation::Approximation;
use super::bracket::{Bracket, End};
use super::instant::Instant;
use super::polynomial::Polynomial;
use super::split::Split;

/// The distinct roots in [0, 1] of polynomials that are not zero, in increasing order.
pub(crate) fn roots(polynomials: Vec<Polynomial>) -> Vec<Instant> {
    let mut all = Vec::new();
    for polynomial in polynomials {
        for root in roots_between(&polynomial, [&Split::START, &Split::END]) {
            root.insert_into(&mut all);
        }
    }
    all
}

/// The distinct roots in [low, high], low < high, of a polynomial that is not zero, in increasing order.
pub(crate) fn roots_between(polynomial: &Polynomial, ends: [&Split; 2]) -> Vec<Instant> {
    let is_root = |end: &Split| end.is_end() && polynomial.sign_at(end).is_eq();
    let [first, last] = ends.map(|end| is_root(end).then(|| Instant::At(end.clone())));
    let inner = inner_roots(&polynomial.reduced(), ends);
    first.into_iter().chain(inner).chain(last).collect()
}

/// The roots of a polynomial that is not zero at t = 0 and t = 1.
///
/// The degree of the derivative is less: the recursion ends.
fn inner_roots(polynomial: &Polynomial, ends: [&Split; 2]) -> Vec<Instant> {
    let has_root_at_end = ends.iter().any(|end| polynomial.sign_at(end).is_eq());
    match at_most(polynomial, ends) {
        0 if !has_root_at_end => Vec::new(),
        1 if !has_root_at_end => [simple(polynomial, ends.map(|end| End::of(polynomial, end)))].into(),
        _ => between_extrema(&polynomial.square_free(), ends),
    }
}

/// A bound of the number of roots in (low, high], counted with multiplicity, which has the parity of that
/// number: the variations of sign in the sequence of all derivatives at `low` less those at `high`, by the
/// theorem of Budan and Fourier (Basu, Pollack, Roy, Algorithms in Real Algebraic Geometry, theorem 2.36).
fn at_most(polynomial: &Polynomial, ends: [&Split; 2]) -> usize {
    let mut derivative = polynomial.clone();
    let mut last = [Ordering::Equal; 2];
    let mut variations = [0; 2];
    while !derivative.is_zero() {
        for (end, t) in ends.into_iter().enumerate() {
            let sign = derivative.sign_at(t);
            if sign.is_ne() {
                variations[end] += usize::from(sign == last[end].reverse());
                last[end] = sign;
            }
        }
        derivative = derivative.slope();
    }
    variations[0].saturating_sub(variations[1])
}

/// The roots of a polynomial, all of them simple, given those of its derivative.
fn between_extrema(polynomial: &Polynomial, ends: [&Split; 2]) -> Vec<Instant> {
    let mut times: Vec<Instant> = roots_between(&polynomial.slope(), ends);
    times.retain(|time| time.compare(ends[0]).is_gt() && time.compare(ends[1]).is_lt());
    times.insert(0, Instant::At(ends[0].clone()));
    times.push(Instant::At(ends[1].clone()));
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
