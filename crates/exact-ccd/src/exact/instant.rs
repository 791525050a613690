//! Times in [0, 1] at which an integer polynomial vanishes, and the signs of other polynomials there.

use core::cmp::Ordering;

use super::bracket::Bracket;
use super::polynomial::Polynomial;
use super::split::Split;

/// A time in [0, 1].
#[derive(Clone, Debug)]
pub(crate) enum Instant {
    /// A rational number.
    At(Split),
    /// A root of a polynomial.
    Root(Bracket),
}

impl Instant {
    /// The sign of a polynomial at this time: zero if it is also a root of that polynomial, otherwise the
    /// sign of all values in the closed bracket, which is made narrow enough. This instant keeps that
    /// bracket.
    ///
    /// It terminates: at a root that is not one of the polynomial, narrow brackets have a sign.
    pub(super) fn narrow_to_sign(&mut self, polynomial: &Polynomial) -> Ordering {
        if let Some(sign) = self.plain_sign(polynomial) {
            return sign;
        }
        if let Self::Root(root) = self
            && root.is_root_of(polynomial)
        {
            return Ordering::Equal;
        }
        let slope = polynomial.slope();
        loop {
            // An attempt costs about as much as making the bracket narrower.
            let last = self.closeness();
            while self.closeness() <= last.saturating_add(last / 32) && matches!(self, Self::Root(_)) {
                self.narrow(usize::MAX);
            }
            let sign = match self {
                Self::At(t) => return polynomial.sign_at(t),
                Self::Root(root) => polynomial.sign_near(&slope, root.low(), root.high()),
            };
            if let Some(sign) = sign {
                return sign;
            }
        }
    }

    /// The sign of a polynomial at this time, if it is easily proved.
    pub(super) fn plain_sign(&self, polynomial: &Polynomial) -> Option<Ordering> {
        match self {
            _ if polynomial.is_zero() => Some(Ordering::Equal),
            Self::At(t) => Some(polynomial.sign_at(t)),
            Self::Root(root) => polynomial.sign_between(root.low(), root.high()),
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
