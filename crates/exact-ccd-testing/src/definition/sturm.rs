//! The number of roots of a polynomial in an interval (Sturm 1829).

use std::cmp::Ordering::{self, Equal};

use super::polynomial::Polynomial;
use super::time::Time;

/// A polynomial that is not zero, as p with the same roots, all of them simple, and Sturm's chain: p, p′, and
/// then each time the remainder of the last two with the opposite sign.
#[derive(Debug)]
pub(crate) struct Sturm(Vec<Polynomial>);

impl Sturm {
    pub(crate) fn new(polynomial: &Polynomial) -> Self {
        let mut chain = vec![polynomial.primitive(), polynomial.derivative().primitive()];
        while let [.., a, b] = chain.as_slice()
            && !b.is_zero()
        {
            chain.push(a.divided_by(b).1.negated().primitive());
        }
        chain.pop();
        // The last one is a greatest common divisor of p and p′: the product of the multiple roots.
        match chain.last() {
            Some(multiple) if !multiple.is_constant() => Self::new(&polynomial.divided_by(multiple).0),
            _ => Self(chain),
        }
    }

    /// A polynomial with the same roots, all simple.
    pub(crate) fn simple(&self) -> &Polynomial {
        &self.0[0]
    }

    pub(crate) fn is_root(&self, t: &Time) -> bool {
        self.simple().sign_at(t) == Equal
    }

    /// The number of roots in (low, high]: the difference of the numbers of changes of sign in the chain.
    pub(crate) fn count(&self, low: &Time, high: &Time) -> usize {
        let [more, less] = [low, high].map(|t| self.changes_of_sign(t));
        assert!(more >= less, "Sturm's chain loses changes of sign");
        more - less
    }

    /// The number of roots in [low, high].
    pub(crate) fn count_closed(&self, low: &Time, high: &Time) -> usize {
        self.count(low, high) + usize::from(self.is_root(low))
    }

    /// The number of roots strictly between two times.
    pub(crate) fn count_between(&self, low: &Time, high: &Time) -> usize {
        self.count(low, high) - usize::from(self.is_root(high))
    }

    fn changes_of_sign(&self, t: &Time) -> usize {
        let signs = self.0.iter().map(|p| p.sign_at(t));
        let signs: Vec<Ordering> = signs.filter(|sign| *sign != Equal).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }
}
