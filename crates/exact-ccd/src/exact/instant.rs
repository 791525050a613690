//! Times in [0, 1] at which an integer polynomial vanishes, and the signs of other polynomials there.

use alloc::rc::Rc;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::dyadic::Dyadic;
use super::polynomial::Polynomial;
use super::sturm::SturmChain;
use crate::time::ContactTime;

/// A time in [0, 1].
#[derive(Clone, Debug)]
pub(crate) enum Instant {
    /// A dyadic rational.
    Dyadic(Dyadic),
    /// The only root of a square-free polynomial between two dyadic rationals, which are not roots themselves.
    Root {
        of: Rc<Polynomial>,
        low: Dyadic,
        high: Dyadic,
    },
}

impl Instant {
    pub(crate) const START: Self = Self::Dyadic(Dyadic::ZERO);
    pub(crate) const END: Self = Self::Dyadic(Dyadic::ONE);

    /// The sign of a polynomial at this time: Tarski's query over the only root of `of` in the bracket.
    pub(crate) fn sign(&self, polynomial: &Polynomial) -> Ordering {
        match self {
            Self::Dyadic(t) => polynomial.sign_at(t),
            Self::Root { of, low, high } => SturmChain::new(of, polynomial).sum_of_signs(low, high).cmp(&0),
        }
    }

    /// How this time compares with t.
    pub(crate) fn compare(&self, t: &Dyadic) -> Ordering {
        match self {
            Self::Dyadic(time) => time.cmp(t),
            Self::Root { low, .. } if t <= low => Ordering::Greater,
            Self::Root { high, .. } if t >= high => Ordering::Less,
            // A simple root: the polynomial has one sign below it in the bracket and the other above.
            Self::Root { of, low, .. } => match of.sign_at(t) {
                Ordering::Equal => Ordering::Equal,
                sign if sign == of.sign_at(low) => Ordering::Greater,
                _ => Ordering::Less,
            },
        }
    }

    /// The bounds of this time.
    pub(crate) fn bounds(&self) -> (&Dyadic, &Dyadic) {
        match self {
            Self::Dyadic(t) => (t, t),
            Self::Root { low, high, .. } => (low, high),
        }
    }

    /// A number strictly between this time and a later one.
    pub(crate) fn before(&self, later: &Self) -> Dyadic {
        let (mut low, mut high) = (self.bounds().0.clone(), later.bounds().1.clone());
        loop {
            let middle = Dyadic::between(&low, &high);
            if self.compare(&middle).is_ge() {
                low = middle;
            } else if later.compare(&middle).is_le() {
                high = middle;
            } else {
                return middle;
            }
        }
    }

    /// The time between two adjacent f64, by bisection over the bit patterns, which are ordered like the numbers.
    pub(crate) fn round(&self) -> ContactTime {
        let (mut low, mut high) = (0.0f64.to_bits(), 1.0f64.to_bits() + 1);
        let compare = |bits| self.compare(&Dyadic::from_unit(f64::from_bits(bits)));
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if compare(middle).is_ge() {
                low = middle;
            } else {
                high = middle;
            }
        }
        let floor = f64::from_bits(low);
        if compare(low).is_eq() {
            ContactTime::exactly(floor)
        } else {
            ContactTime::just_above(floor)
        }
    }
}

/// The distinct roots of a polynomial, which is not zero, in [0, 1], in increasing order.
pub(crate) fn roots(polynomial: &Polynomial) -> Vec<Instant> {
    let square_free = polynomial.quotient(&polynomial.clone().gcd(polynomial.derivative()));
    let inner = square_free
        .clone()
        .without_root(&Dyadic::ZERO)
        .without_root(&Dyadic::ONE);
    let mut roots = Vec::new();
    if square_free.sign_at(&Dyadic::ZERO).is_eq() {
        roots.push(Instant::START);
    }
    isolate(inner, Dyadic::ZERO, Dyadic::ONE, &mut roots);
    if square_free.sign_at(&Dyadic::ONE).is_eq() {
        roots.push(Instant::END);
    }
    roots
}

/// Appends the roots of a square-free polynomial between two numbers that are no roots. Recursion is only as deep as
/// there are roots.
fn isolate(polynomial: Polynomial, mut low: Dyadic, mut high: Dyadic, roots: &mut Vec<Instant>) {
    let chain = SturmChain::new(&polynomial, &Polynomial::one());
    loop {
        let count = chain.sum_of_signs(&low, &high);
        if count == 0 {
            return;
        }
        if count == 1 {
            roots.push(Instant::Root {
                of: Rc::new(polynomial),
                low,
                high,
            });
            return;
        }
        let middle = Dyadic::between(&low, &high);
        if polynomial.sign_at(&middle).is_eq() {
            let others = polynomial.without_root(&middle);
            isolate(others.clone(), low, middle.clone(), roots);
            roots.push(Instant::Dyadic(middle.clone()));
            return isolate(others, middle, high, roots);
        }
        match chain.sum_of_signs(&low, &middle) {
            0 => low = middle,
            left if left == count => high = middle,
            _ => {
                isolate(polynomial.clone(), low, middle.clone(), roots);
                low = middle;
            }
        }
    }
}
