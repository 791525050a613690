//! A time whose bracket becomes narrower as signs require it. The bracket stays narrow for the signs
//! that follow.

use core::cell::RefCell;
use core::cmp::Ordering;

use super::instant::Instant;
use super::polynomial::Polynomial;
use super::split::Split;

/// A time with a bracket that each sign may make narrower.
pub(crate) struct Narrowing(RefCell<Instant>);

impl Narrowing {
    pub(crate) fn new(instant: Instant) -> Self {
        Self(RefCell::new(instant))
    }

    /// The sign of a polynomial at this time.
    pub(crate) fn sign(&self, polynomial: &Polynomial) -> Ordering {
        self.0.borrow_mut().narrow_to_sign(polynomial)
    }

    /// The sign of a polynomial at this time, if it is easily proved.
    pub(crate) fn plain_sign(&self, polynomial: &Polynomial) -> Option<Ordering> {
        self.0.borrow().plain_sign(polynomial)
    }

    /// The time with its bracket.
    pub(crate) fn into_instant(self) -> Instant {
        self.0.into_inner()
    }

    /// A number not above this time, at most as far from it as the bracket is wide.
    pub(super) fn lower_bound(&self) -> Split {
        self.0.borrow().bounds().0.clone()
    }

    /// Makes the bracket narrower, unless its bounds have this [closeness](Split::closeness).
    pub(crate) fn narrow_to(&self, closeness: usize) {
        self.0.borrow_mut().narrow_to(closeness);
    }

    /// Makes the bracket narrower by a factor of about 2ᵏ.
    pub(crate) fn narrow_by(&self, bits: usize) {
        let mut instant = self.0.borrow_mut();
        let closeness = instant.closeness().saturating_add(bits);
        instant.narrow_to(closeness);
    }
}
