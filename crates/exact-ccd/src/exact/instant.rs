//! Times in [0, 1] at which an integer polynomial vanishes, and the signs of other polynomials there.

use alloc::sync::Arc;
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
    /// The only root of a square-free polynomial between two dyadic rationals, which are not roots
    /// themselves.
    Root {
        of: Arc<Polynomial>,
        low: Dyadic,
        high: Dyadic,
    },
}

impl Instant {
    /// The sign of a polynomial at this time: Tarski's query over the only root of `of` in the
    /// bracket, unless Descartes' rule proves one sign in the whole bracket.
    pub(crate) fn sign(&self, polynomial: &Polynomial) -> Ordering {
        match self {
            Self::Dyadic(t) => polynomial.sign_at(t),
            Self::Root { of, low, high } => polynomial
                .sign_between(low, high)
                .unwrap_or_else(|| SturmChain::new(of, polynomial).sum_of_signs(low, high).cmp(&0)),
        }
    }

    /// The same time in a narrower bracket.
    fn narrowed(self) -> Self {
        let Self::Root { of, low, high } = self else {
            return self;
        };
        let middle = Dyadic::between(&low, &high);
        // A simple root: the polynomial has one sign below it in the bracket and the other above.
        match of.sign_at(&middle) {
            Ordering::Equal => Self::Dyadic(middle),
            sign if sign == of.sign_at(&low) => Self::Root {
                of,
                low: middle,
                high,
            },
            _ => Self::Root {
                of,
                low,
                high: middle,
            },
        }
    }

    /// The same time in a bracket narrowed by this number of bisections.
    pub(crate) fn narrowed_by(self, steps: usize) -> Self {
        (0..steps).fold(self, |instant, _| instant.narrowed())
    }

    /// Returns true if this time is earlier than another one. It does not terminate for equal times.
    fn is_before(&self, other: &Self) -> bool {
        let (mut this, mut other) = (self.clone(), other.clone());
        loop {
            if this.bounds().1 <= other.bounds().0 {
                return true;
            }
            if other.bounds().1 <= this.bounds().0 {
                return false;
            }
            (this, other) = (this.narrowed(), other.narrowed());
        }
    }

    /// The comparison of this time with t.
    pub(crate) fn compare(&self, t: &Dyadic) -> Ordering {
        match self {
            Self::Dyadic(time) => time.cmp(t),
            Self::Root { low, .. } if t <= low => Ordering::Greater,
            Self::Root { high, .. } if t >= high => Ordering::Less,
            Self::Root { of, low, .. } => match of.sign_at(t) {
                Ordering::Equal => Ordering::Equal,
                sign if sign == of.sign_at(low) => Ordering::Greater,
                _ => Ordering::Less,
            },
        }
    }

    /// A lower and an upper bound of this time.
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

    /// The time as an f64 or between two adjacent ones, by bisection over bit patterns, which are
    /// ordered like the numbers.
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

/// The distinct roots in [0, 1] of polynomials that are not zero, in increasing order.
pub(crate) fn roots(polynomials: Vec<Polynomial>) -> Vec<Instant> {
    let mut all: Vec<Instant> = Vec::new();
    for polynomial in coprime(polynomials) {
        let mut roots = Vec::new();
        for end in [Dyadic::ZERO, Dyadic::ONE] {
            if polynomial.sign_at(&end).is_eq() {
                roots.push(Instant::Dyadic(end));
            }
        }
        let inner = polynomial.without_root(&Dyadic::ZERO).without_root(&Dyadic::ONE);
        isolate(inner, Dyadic::ZERO, Dyadic::ONE, &mut roots);
        for root in roots {
            all.insert(all.partition_point(|other| other.is_before(&root)), root);
        }
    }
    all
}

/// Square-free polynomials without common roots, whose roots are those of the given ones; zero ones
/// are left out. On these, the bisections below terminate.
fn coprime(polynomials: Vec<Polynomial>) -> Vec<Polynomial> {
    let mut factors: Vec<Polynomial> = Vec::new();
    for polynomial in polynomials.into_iter().filter(|p| !p.is_zero()) {
        let divide = |rest: Polynomial, factor: &Polynomial| rest.quotient(&rest.clone().gcd(factor.clone()));
        factors.push(factors.iter().fold(polynomial.square_free(), divide));
    }
    factors
}

/// Appends the roots of a square-free polynomial between two numbers that are not roots. The depth
/// of recursion is at most the number of roots.
fn isolate(polynomial: Polynomial, mut low: Dyadic, mut high: Dyadic, roots: &mut Vec<Instant>) {
    let chain = SturmChain::new(&polynomial, &Polynomial::one());
    loop {
        let count = chain.sum_of_signs(&low, &high);
        if count == 0 {
            return;
        }
        if count == 1 {
            // In a narrow bracket, Descartes' rule proves most signs.
            let root = Instant::Root {
                of: Arc::new(polynomial),
                low,
                high,
            };
            roots.push(root.narrowed_by(16));
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
