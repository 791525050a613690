//! A bracket around a root of a polynomial, which can be made narrower.

use alloc::sync::Arc;
use core::cmp::Ordering;

use super::approximation::Approximation;
use super::guess;
use super::polynomial::Polynomial;
use super::split::Split;

/// The only root of a polynomial between two times, a simple one.
#[derive(Clone, Debug)]
pub(crate) struct Bracket {
    of: Arc<Polynomial>,
    low: End,
    high: End,
    /// The precision of the next guess.
    bits: usize,
}

/// An end of a bracket: 0, 1, or a ratio a 2ᵏ : 1.
#[derive(Clone, Debug)]
struct End {
    time: Split,
    /// The polynomial there, with different signs at both ends, neither of them zero.
    value: Approximation,
}

impl Bracket {
    /// The bracket of a polynomial that changes its sign once between two times.
    pub(super) fn new(of: Arc<Polynomial>, low: Split, high: Split) -> Self {
        let bits = 4;
        let [low, high] = [low, high].map(|time| End {
            value: of.value_at(&time, bits),
            time,
        });
        Self { of, low, high, bits }
    }

    /// A polynomial of which it is the only root in the bracket, a simple one.
    pub(super) fn polynomial(&self) -> &Polynomial {
        &self.of
    }

    pub(super) fn low(&self) -> &Split {
        &self.low.time
    }

    pub(super) fn high(&self) -> &Split {
        &self.high.time
    }

    /// The [closeness](Split::closeness) of the ends.
    pub(super) fn closeness(&self) -> usize {
        Split::closeness(self.low(), self.high())
    }

    /// Makes the bracket narrower: a cell of a grid if the guess is right, otherwise at most about one half
    /// of it. The root itself is returned if it is at an end of them.
    pub(super) fn narrow(&mut self) -> Result<(), Split> {
        if self.closeness() == 0 {
            return self.cut(Split::between(self.low(), self.high()));
        }
        let values = [&self.low.value, &self.high.value];
        let guess = guess::secant(values, self.low(), self.high(), self.bits);
        for t in &guess {
            self.cut(t.clone())?;
        }
        if *self.low() == guess[0] && *self.high() == guess[1] {
            self.bits *= 2;
        } else {
            self.cut(Split::between(self.low(), self.high()))?;
            self.bits = (self.bits / 2).max(2);
        }
        Ok(())
    }

    /// Moves one end to a time, unless that is outside the bracket, or returns it if it is the root.
    fn cut(&mut self, time: Split) -> Result<(), Split> {
        if time <= *self.low() || time >= *self.high() {
            return Ok(());
        }
        let value = self.of.value_at(&time, 2 * self.bits);
        let end = if value.sign() == Some(Ordering::Equal) {
            return Err(time);
        } else if value.sign() == self.low.value.sign() {
            &mut self.low
        } else {
            &mut self.high
        };
        *end = End { time, value };
        Ok(())
    }

    /// The comparison of the root with t.
    pub(super) fn compare(&self, t: &Split) -> Ordering {
        if t <= self.low() {
            return Ordering::Greater;
        }
        if t >= self.high() {
            return Ordering::Less;
        }
        match self.of.sign_at(t) {
            Ordering::Equal => Ordering::Equal,
            sign if Some(sign) == self.low.value.sign() => Ordering::Greater,
            _ => Ordering::Less,
        }
    }

    /// Returns true if another polynomial vanishes at this root.
    ///
    /// The common roots are those of the greatest common divisor. In the bracket, it has at most this
    /// root, which is simple, so that it changes its sign there. It then takes the place of the
    /// polynomial, because its coefficients are shorter.
    pub(super) fn is_root_of(&mut self, polynomial: &Polynomial) -> bool {
        let common = self.of.gcd_between(polynomial, self.low(), self.high());
        let changes = |p: &Polynomial| p.sign_at(self.low()) != p.sign_at(self.high());
        let Some(common) = common.filter(changes) else {
            return false;
        };
        *self = Self::new(Arc::new(common), self.low().clone(), self.high().clone());
        true
    }
}
