//! A bracket around a root of a polynomial, which can be made narrower.

use alloc::boxed::Box;
use alloc::sync::Arc;
use core::cmp::Ordering;

use super::approximation::Approximation;
use super::expansion::Expansion;
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
    /// The polynomial between the ends, if these are close to each other.
    near: Option<Box<Expansion>>,
}

/// The precision of the first guess.
const FIRST_BITS: usize = 4;

/// The number of bits by which values are more precise than the next guess needs them to be.
const MARGIN: isize = 20;

/// The closeness of ends between which the polynomial is expanded.
const CLOSE: usize = 128;

/// An end of a bracket: 0, 1, or a ratio a 2ᵏ : 1.
#[derive(Clone, Debug)]
pub(super) struct End {
    time: Split,
    /// The polynomial there, with different signs at both ends, neither of them zero.
    value: Approximation,
}

impl End {
    pub(super) fn new(time: &Split, value: Approximation) -> Self {
        Self {
            time: time.clone(),
            value,
        }
    }

    /// An end with a value that suffices for the first guess.
    pub(super) fn of(polynomial: &Polynomial, time: &Split) -> Self {
        Self::new(time, polynomial.value_at(time, FIRST_BITS))
    }
}

impl Bracket {
    /// The bracket of a polynomial that changes its sign once between two times.
    pub(super) fn new(of: Arc<Polynomial>, [low, high]: [End; 2]) -> Self {
        Self {
            of,
            low,
            high,
            bits: FIRST_BITS,
            near: None,
        }
    }

    /// A polynomial whose only root in the bracket is this one, which is simple.
    pub(super) fn polynomial(&self) -> &Polynomial {
        &self.of
    }

    /// The sign of the polynomial before the root.
    pub(super) fn sign_before(&self) -> Option<Ordering> {
        self.low.value.sign()
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

    /// Makes the bracket narrower: a cell of a grid if the guess is right, by a factor of about 2ᵏ at most,
    /// otherwise at most about one half of it. The root itself is returned if it is found.
    pub(super) fn narrow(&mut self, most: usize) -> Result<(), Split> {
        let closeness = self.closeness();
        if closeness == 0 {
            return self.cut(Split::between(self.low(), self.high()), isize::MAX);
        }
        let bits = self.bits.min(most);
        self.expand(bits, closeness);
        let tops = [&self.low, &self.high].map(|end| end.value.top());
        if tops[0].abs_diff(tops[1]) > 8 {
            return self.narrow_to_end(tops);
        }
        let values = [&self.low.value, &self.high.value];
        // In a cell, values are less by a factor of about 2⁻ᵇ. The next guess is for 2 b bits of them.
        let unit = tops[0].max(tops[1]) - 3 * bits as isize - MARGIN;
        if self.cut_to(guess::secant(values, self.low(), self.high(), bits), unit)? {
            self.bits = 2 * bits;
        } else {
            self.bits = (bits / 2).max(2);
            self.cut(Split::between(self.low(), self.high()), unit)?;
        }
        Ok(())
    }

    /// Makes an expansion that suffices for a guess of b bits, if the ends are close. It has at least half as
    /// many bits as the ends have in common, and suffices for several guesses, because the bits of the ends
    /// make up most of its cost.
    fn expand(&mut self, bits: usize, closeness: usize) {
        let tops = [&self.low, &self.high].map(|end| end.value.top());
        let top = tops[0].max(tops[1]);
        let bits = bits.max(tops[0].abs_diff(tops[1])) as isize + MARGIN;
        let suffices = |near: &Expansion| near.unit <= top - bits;
        if closeness < CLOSE || self.near.as_deref().is_some_and(suffices) {
            return;
        }
        let bits = bits.max(closeness as isize / 2) + MARGIN;
        let near = self.of.expansion(self.low(), self.high(), top - bits);
        for end in [&mut self.low, &mut self.high] {
            let value = near.value_at(&end.time);
            if value.sign().is_some() {
                end.value = value;
            }
        }
        self.near = Some(Box::new(near));
    }

    /// Makes the bracket narrower where the value at one end is less by a factor of about 2⁻ʳ.
    ///
    /// The root is near that end: at a distance of about 2⁻ʳ of the width if the polynomial is nearly
    /// linear, and of 2⁻ʳᐟ² if it has an extremum at the end. If it is farther away, because the extremum is
    /// flat, the exponent is halved until the distance is large enough.
    fn narrow_to_end(&mut self, tops: [isize; 2]) -> Result<(), Split> {
        let ratio = tops[0].abs_diff(tops[1]);
        let is_near_low = tops[0] < tops[1];
        let (low, high) = (self.low().clone(), self.high().clone());
        let at = |halvings| guess::near_end(&low, &high, is_near_low, halvings);
        let unit = tops[0].min(tops[1]) - 3 * FIRST_BITS as isize - MARGIN;
        self.bits = FIRST_BITS;
        let mut reaches = |halvings: usize| {
            let time = at(halvings);
            self.cut(time.clone(), unit)?;
            Ok(time == *if is_near_low { self.high() } else { self.low() })
        };
        if reaches(ratio / 2 + 1)? {
            return reaches(ratio + 2).and_then(|_| reaches(ratio - 2)).map(|_| ());
        }
        let mut halvings = ratio / 2 - 1;
        while !reaches(halvings)? && halvings > 1 {
            halvings /= 2;
        }
        Ok(())
    }

    /// Moves the bracket's ends to the cell's ends, where these are in the bracket, and returns true if the
    /// root is in the cell.
    fn cut_to(&mut self, cell: [Split; 2], unit: isize) -> Result<bool, Split> {
        for t in &cell {
            self.cut(t.clone(), unit)?;
        }
        Ok(*self.low() >= cell[0] && *self.high() <= cell[1])
    }

    /// Moves one end to a time, with its value in a unit of at most 2ᵏ, unless the time is outside the
    /// bracket. It is returned if it is the root.
    fn cut(&mut self, time: Split, unit: isize) -> Result<(), Split> {
        if time <= *self.low() || time >= *self.high() {
            return Ok(());
        }
        let value = self.near.as_deref().map(|near| near.value_at(&time));
        let value = value.filter(|value| value.sign().is_some());
        let value = value.unwrap_or_else(|| self.of.value_in(&time, unit));
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
    /// The common roots are the roots of the greatest common divisor. In the bracket, the divisor has at most
    /// this root, which is simple, so that the divisor changes its sign there. It then takes the place of the
    /// polynomial, because its coefficients are shorter.
    pub(super) fn is_root_of(&mut self, polynomial: &Polynomial) -> bool {
        let common = self.of.gcd_between(polynomial, self.low(), self.high());
        let changes = |p: &Polynomial| p.sign_at(self.low()) != p.sign_at(self.high());
        let Some(common) = common.filter(changes) else {
            return false;
        };
        let ends = [self.low(), self.high()].map(|time| End::of(&common, time));
        *self = Self::new(Arc::new(common), ends);
        true
    }
}

#[cfg(test)]
mod tests;
