//! A bracket around a root of a polynomial, which can be made narrower.

use alloc::sync::Arc;
use core::cmp::Ordering;

use super::guess;
use super::polynomial::Polynomial;
use super::split::Split;

/// The only root of a polynomial between two times, a simple one. It has different signs at these, neither
/// of them zero. The times are 0, 1, or ratios a 2ᵏ : 1.
#[derive(Clone, Debug)]
pub(crate) struct Bracket {
    pub(super) of: Arc<Polynomial>,
    pub(super) low: Split,
    pub(super) high: Split,
    /// The precision of the next guess.
    bits: usize,
}

impl Bracket {
    pub(super) fn new(of: Arc<Polynomial>, low: Split, high: Split) -> Self {
        Self {
            of,
            low,
            high,
            bits: 4,
        }
    }

    /// A narrower bracket: a cell of a grid if the guess is right, otherwise at most about one half of
    /// this one. The root itself, if it is at an end of them.
    pub(super) fn narrowed(mut self) -> Result<Self, Split> {
        if self.closeness() == 0 {
            self.cut(&Split::between(&self.low, &self.high))?;
            return Ok(self);
        }
        let [start, end] = [&self.low, &self.high].map(|t| self.of.value_at(t, self.bits));
        let guess = guess::secant([&start, &end], &self.low, &self.high, self.bits);
        for t in &guess {
            self.cut(t)?;
        }
        let is_right = self.low == guess[0] && self.high == guess[1];
        if is_right {
            self.bits *= 2;
        } else {
            self.cut(&Split::between(&self.low, &self.high))?;
            self.bits = (self.bits / 2).max(2);
        }
        Ok(self)
    }

    /// Moves one end to a number, unless it is outside the bracket, or returns it if it is the root.
    fn cut(&mut self, t: &Split) -> Result<(), Split> {
        match self.compare(t) {
            Ordering::Less => self.high = t.min(&self.high).clone(),
            Ordering::Greater => self.low = t.max(&self.low).clone(),
            Ordering::Equal => return Err(t.clone()),
        }
        Ok(())
    }

    /// The comparison of the root with t.
    pub(super) fn compare(&self, t: &Split) -> Ordering {
        if *t <= self.low {
            return Ordering::Greater;
        }
        if *t >= self.high {
            return Ordering::Less;
        }
        match self.of.sign_at(t) {
            Ordering::Equal => Ordering::Equal,
            sign if sign == self.of.sign_at(&self.low) => Ordering::Greater,
            _ => Ordering::Less,
        }
    }

    /// Returns true if another polynomial vanishes at this root.
    ///
    /// The common roots are those of the greatest common divisor. In the bracket, it has at most this
    /// root, which is simple, so that it changes its sign there.
    pub(super) fn is_root_of(&self, polynomial: &Polynomial) -> bool {
        let common = (*self.of).clone().gcd(polynomial.clone());
        common.sign_at(&self.low) != common.sign_at(&self.high)
    }

    /// The [closeness](Split::closeness) of the ends.
    pub(super) fn closeness(&self) -> usize {
        Split::closeness(&self.low, &self.high)
    }
}
