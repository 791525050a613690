//! Sturm's theorem in Tarski's form: the one primitive of exact decisions.
//!
//! For polynomials p and q, let S₀ = p, S₁ = p′ q, Sᵢ₊₁ = −(Sᵢ₋₁ mod Sᵢ) up to a positive factor,
//! and let V(t) be the number of sign changes in S₀(t), S₁(t), …, zeros left out. If p vanishes
//! neither at a nor at b, then V(a) − V(b) is the sum of the signs of q over the distinct roots of
//! p in (a, b). With q = 1 it counts them, and over a bracket of one root it is the sign of q
//! there. (Basu, Pollack, Roy: Algorithms in Real Algebraic Geometry, theorem 2.73.)

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::dyadic::Dyadic;
use super::polynomial::Polynomial;

/// The sequence S₀, S₁, … of p and q.
pub(crate) struct SturmChain(Vec<Polynomial>);

impl SturmChain {
    pub(crate) fn new(p: &Polynomial, q: &Polynomial) -> Self {
        let mut chain = vec![p.clone()];
        let mut next = &p.derivative() * q;
        while !next.is_zero() {
            let rest = chain[chain.len() - 1].remainder(&next);
            chain.push(next);
            next = -rest;
        }
        Self(chain)
    }

    /// The sum of the signs of q over the distinct roots of p in (low, high), where p(low) and
    /// p(high) are not zero.
    pub(crate) fn sum_of_signs(&self, low: &Dyadic, high: &Dyadic) -> isize {
        self.variations(low) - self.variations(high)
    }

    fn variations(&self, t: &Dyadic) -> isize {
        let mut last = Ordering::Equal;
        let mut changes = 0;
        for sign in self
            .0
            .iter()
            .map(|polynomial| polynomial.sign_at(t))
            .filter(|sign| sign.is_ne())
        {
            changes += isize::from(last == sign.reverse());
            last = sign;
        }
        changes
    }
}
