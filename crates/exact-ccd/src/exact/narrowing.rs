//! A time whose bracket becomes narrower as signs need it, so that no sign repeats the work for another one.

use core::cell::RefCell;
use core::cmp::Ordering;

use super::dyadic::Dyadic;
use super::instant::Instant;
use super::polynomial::Polynomial;

pub(super) struct Narrowing(RefCell<Instant>);

impl Narrowing {
    pub(super) fn new(instant: &Instant) -> Self {
        Self(RefCell::new(instant.clone()))
    }

    /// The sign of a polynomial at this time.
    pub(super) fn sign(&self, polynomial: &Polynomial) -> Ordering {
        self.0.borrow_mut().narrow_to_sign(polynomial)
    }

    /// A number next to this time, and nearer after each [`narrow_by`](Self::narrow_by).
    pub(super) fn lower_bound(&self) -> Dyadic {
        self.0.borrow().bounds().0.clone()
    }

    /// Makes the bracket narrower by a factor of at least 2ᵏ.
    pub(super) fn narrow_by(&self, bits: usize) {
        self.0.replace_with(|instant| instant.clone().narrowed_by(bits));
    }
}
