//! Times in [0, 1] at which an integer polynomial vanishes, and the signs of other polynomials there.

use alloc::sync::Arc;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::dyadic::Dyadic;
use super::guess;
use super::polynomial::Polynomial;
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
        /// The precision of the next guess.
        bits: usize,
    },
}

impl Instant {
    /// The sign of a polynomial at this time.
    pub(crate) fn sign(&self, polynomial: &Polynomial) -> Ordering {
        self.clone().narrow_to_sign(polynomial)
    }

    /// The sign of a polynomial at this time: zero if the polynomial and `of` have a common root in
    /// the bracket, otherwise its sign in the whole of a bracket that is narrow enough. This instant
    /// keeps that bracket.
    pub(super) fn narrow_to_sign(&mut self, polynomial: &Polynomial) -> Ordering {
        if let Some(sign) = self.plain_sign(polynomial) {
            return sign;
        }
        if self.is_root_of(polynomial) {
            return Ordering::Equal;
        }
        loop {
            *self = self.clone().narrowed();
            if let Some(sign) = self.plain_sign(polynomial) {
                return sign;
            }
        }
    }

    /// The sign of a polynomial at this time, if Descartes' rule proves one sign in the whole bracket.
    fn plain_sign(&self, polynomial: &Polynomial) -> Option<Ordering> {
        match self {
            Self::Dyadic(t) => Some(polynomial.sign_at(t)),
            Self::Root { low, high, .. } => polynomial.sign_between(low, high),
        }
    }

    /// Returns true if a polynomial vanishes at this time.
    ///
    /// The common roots are those of the greatest common divisor. In the bracket, it has at most the
    /// root of `of`, which is simple, so that it changes its sign there.
    fn is_root_of(&self, polynomial: &Polynomial) -> bool {
        match self {
            Self::Dyadic(t) => polynomial.sign_at(t).is_eq(),
            Self::Root { of, low, high, .. } => {
                let common = (**of).clone().gcd(polynomial.clone());
                common.sign_at(low) != common.sign_at(high)
            }
        }
    }

    /// The same time in a narrower bracket: a cell of a grid if the guess is right, otherwise at most
    /// about one half of this one.
    fn narrowed(self) -> Self {
        let Self::Root {
            of,
            mut low,
            mut high,
            bits,
        } = self
        else {
            return self;
        };
        let (guess, start) = guess::secant(&of, &low, &high, bits);
        // A simple root: the polynomial has one sign below it in the bracket and the other above.
        let cut = |low: &mut Dyadic, high: &mut Dyadic, t: &Dyadic| {
            let sign = of.sign_at(t);
            *(if sign == start { low } else { high }) = t.clone();
            sign.is_eq()
        };
        for t in &guess {
            if *t > low && *t < high && cut(&mut low, &mut high, t) {
                return Self::Dyadic(high);
            }
        }
        let is_right = low == guess[0] && high == guess[1];
        if !is_right {
            let middle = Dyadic::between(&low, &high);
            if cut(&mut low, &mut high, &middle) {
                return Self::Dyadic(middle);
            }
        }
        Self::Root {
            of,
            low,
            high,
            bits: if is_right { 2 * bits } else { (bits / 2).max(2) },
        }
    }

    /// The width of the bracket.
    fn width(&self) -> Dyadic {
        let (low, high) = self.bounds();
        Dyadic::difference(high, low)
    }

    /// The same time in a bracket that is narrower by a factor of at least 2ᵏ.
    pub(crate) fn narrowed_by(self, bits: usize) -> Self {
        let enough = self.width().halved(bits);
        let mut instant = self;
        while instant.width() > enough {
            instant = instant.narrowed();
        }
        instant
    }

    /// This time and another one in disjoint closed brackets. It does not terminate for equal times.
    fn apart(&self, other: &Self) -> (Self, Self) {
        let (mut this, mut other) = (self.clone(), other.clone());
        while this.bounds().1 >= other.bounds().0 && other.bounds().1 >= this.bounds().0 {
            if this.width() > other.width() {
                this = this.narrowed();
            } else {
                other = other.narrowed();
            }
        }
        (this, other)
    }

    /// Returns true if this time is earlier than another one. It does not terminate for equal times.
    fn is_before(&self, other: &Self) -> bool {
        let (this, other) = self.apart(other);
        this.bounds().1 < other.bounds().0
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
        let (this, later) = self.apart(later);
        Dyadic::between(this.bounds().1, later.bounds().0)
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
    roots_between(polynomials, &Dyadic::ZERO, &Dyadic::ONE)
}

/// The distinct roots in [low, high] of polynomials that are not zero, in increasing order.
pub(crate) fn roots_between(polynomials: Vec<Polynomial>, low: &Dyadic, high: &Dyadic) -> Vec<Instant> {
    let mut all: Vec<Instant> = Vec::new();
    for polynomial in coprime(polynomials) {
        let mut roots = Vec::new();
        for end in [low, high] {
            if polynomial.sign_at(end).is_eq() {
                roots.push(Instant::Dyadic(end.clone()));
            }
        }
        let inner = polynomial.without_root(low).without_root(high);
        isolate(inner, low.clone(), high.clone(), &mut roots);
        for root in roots {
            all.insert(all.partition_point(|other| other.is_before(&root)), root);
        }
    }
    all
}

/// Square-free polynomials without common roots, whose roots are those of the given ones; zero ones
/// are left out. On these, the iterations above and below terminate.
fn coprime(polynomials: Vec<Polynomial>) -> Vec<Polynomial> {
    let mut factors: Vec<Polynomial> = Vec::new();
    for polynomial in polynomials.into_iter().filter(|p| !p.is_zero()) {
        let divide = |rest: Polynomial, factor: &Polynomial| rest.quotient(&rest.clone().gcd(factor.clone()));
        factors.push(factors.iter().fold(polynomial.square_free(), divide));
    }
    factors
}

/// Appends the roots of a square-free polynomial between two numbers that are not roots, by
/// Descartes' rule. The depth of recursion is at most the number of roots.
fn isolate(polynomial: Polynomial, mut low: Dyadic, mut high: Dyadic, roots: &mut Vec<Instant>) {
    let mut bits = 0;
    loop {
        let changes = polynomial.sign_changes(&low, &high).0;
        if changes == 0 {
            return;
        }
        if changes == 1 {
            let root = Instant::Root {
                of: Arc::new(polynomial),
                low,
                high,
                bits: 4,
            };
            // In a narrow bracket, Descartes' rule proves most signs.
            roots.push(root.narrowed_by(16));
            return;
        }
        // The sign changes of disjoint intervals add up to at most those of an interval that contains
        // them: if a cell has all of them, none are left outside it.
        let holds_all = |[left, right]: &[Dyadic; 2]| {
            polynomial.sign_changes(left, right).0 == changes
                && polynomial.sign_at(left).is_ne()
                && polynomial.sign_at(right).is_ne()
        };
        if bits >= 4 {
            let cell = guess::newton(&polynomial, changes, &low, &high, bits).find(holds_all);
            if let Some(cell) = cell {
                [low, high] = cell;
                bits *= 2;
                continue;
            }
            bits /= 2;
        }
        bits += 1;
        let middle = Dyadic::between(&low, &high);
        if polynomial.sign_at(&middle).is_eq() {
            let others = polynomial.without_root(&middle);
            isolate(others.clone(), low, middle.clone(), roots);
            roots.push(Instant::Dyadic(middle.clone()));
            return isolate(others, middle, high, roots);
        }
        match polynomial.sign_changes(&low, &middle).0 {
            0 => low = middle,
            left if left == changes => high = middle,
            _ => {
                isolate(polynomial.clone(), low, middle.clone(), roots);
                (low, bits) = (middle, 0);
            }
        }
    }
}
