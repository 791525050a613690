//! Times in [0, 1] at which an integer polynomial vanishes, and the signs of other polynomials there.

use core::cmp::Ordering;

use dashu_int::IBig;

use super::approximation::Approximation;
use super::bracket::Bracket;
use super::polynomial::Polynomial;
use super::split::Split;

/// A time in [0, 1].
#[derive(Clone, Debug)]
pub(crate) enum Instant {
    /// A rational number.
    At(Split),
    /// A root of a polynomial, in a bracket of a [closeness](Split::closeness) above 0.
    Root(Bracket),
}

impl Instant {
    /// The sign of a polynomial at this time: zero if it is also a root of that polynomial, otherwise the
    /// sign of all values in the closed bracket, which is made narrow enough. This instant keeps that
    /// bracket.
    ///
    /// It terminates: at a root that is not one of the polynomial, narrow brackets have a sign.
    pub(super) fn narrow_to_sign(&mut self, polynomial: &Polynomial) -> Ordering {
        self.narrow_to_value(polynomial).middle.cmp(&IBig::ZERO)
    }

    /// All values of a polynomial in the closed bracket, with their sign, as above.
    pub(super) fn narrow_to_value(&mut self, polynomial: &Polynomial) -> Approximation {
        let values = self.values(polynomial);
        if values.sign().is_some() {
            return values;
        }
        if let Self::Root(root) = self
            && root.is_root_of(polynomial)
        {
            return Approximation::exactly(IBig::ZERO);
        }
        let slope = polynomial.slope();
        loop {
            // An attempt costs about as much as making the bracket narrower.
            let last = self.closeness();
            while self.closeness() <= last.saturating_add(last / 32) && matches!(self, Self::Root(_)) {
                self.narrow(usize::MAX);
            }
            let values = match self {
                Self::At(t) => polynomial.value_at(t, 0),
                Self::Root(root) => polynomial.values_near(&slope, root.low(), root.high()),
            };
            if values.sign().is_some() {
                return values;
            }
        }
    }

    /// The sign of a polynomial at this time, if it is easily proved.
    pub(super) fn plain_sign(&self, polynomial: &Polynomial) -> Option<Ordering> {
        self.values(polynomial).sign()
    }

    /// All values of a polynomial in the closed bracket, as precise as is easy.
    fn values(&self, polynomial: &Polynomial) -> Approximation {
        match self {
            _ if polynomial.is_zero() => Approximation::exactly(IBig::ZERO),
            Self::At(t) => polynomial.value_at(t, 0),
            Self::Root(root) => polynomial.values_between(root.low(), root.high()),
        }
    }

    /// The sign of a polynomial at the start of the bracket, if it is the bracket's own polynomial.
    pub(super) fn sign_before(&self, polynomial: &Polynomial) -> Option<Ordering> {
        match self {
            Self::Root(root) if root.polynomial() == polynomial => root.sign_before(),
            _ => None,
        }
    }

    /// Makes the bracket narrower, by a factor of about 2ᵏ at most.
    pub(super) fn narrow(&mut self, most: usize) {
        if let Self::Root(root) = self
            && let Err(t) = root.narrow(most)
        {
            *self = Self::At(t);
        }
    }

    /// The [closeness](Split::closeness) of the bounds.
    pub(super) fn closeness(&self) -> usize {
        match self {
            Self::At(_) => usize::MAX,
            Self::Root(root) => root.closeness(),
        }
    }

    /// Makes the bracket narrower, unless its bounds have this [closeness](Split::closeness).
    pub(crate) fn narrow_to(&mut self, closeness: usize) {
        while self.closeness() < closeness {
            self.narrow(closeness - self.closeness() + 1);
        }
    }

    /// The comparison of this time with t.
    pub(crate) fn compare(&self, t: &Split) -> Ordering {
        match self {
            Self::At(time) => time.cmp(t),
            Self::Root(root) => root.compare(t),
        }
    }

    /// A lower and an upper bound of this time.
    pub(crate) fn bounds(&self) -> (&Split, &Split) {
        match self {
            Self::At(t) => (t, t),
            Self::Root(root) => (root.low(), root.high()),
        }
    }
}
