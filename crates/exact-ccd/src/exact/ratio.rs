//! Ratios of polynomials and directions of vectors at an instant, by signs.

use super::narrowing::Narrowing;
use super::polynomial::Polynomial;
use super::polynomial::Vector;
use crate::tables::Point;
use crate::values::unit;

/// The number of bits of a ratio after the point.
const BITS: usize = 52;

/// The bits of a guess beyond these.
const GUARD: usize = 6;

impl Narrowing {
    /// The direction of a vector at this time, unless it vanishes then.
    pub(crate) fn direction(&self, vector: Vector) -> Option<Point> {
        let signs = [0, 1, 2].map(|axis: usize| self.sign(&vector[axis]));
        let mut magnitudes = vector;
        for (component, sign) in magnitudes.iter_mut().zip(signs) {
            if sign.is_lt() {
                *component = -component.clone();
            }
        }
        let is_less = |a: usize, b: usize| self.sign(&(&magnitudes[a] - &magnitudes[b])).is_lt();
        let largest = (1..3).fold(0, |best, axis| if is_less(best, axis) { axis } else { best });
        if signs[largest].is_eq() {
            return None;
        }
        Some(unit([0, 1, 2].map(|axis: usize| {
            let ratio = self.ratio(&magnitudes[axis], &magnitudes[largest]);
            if signs[axis].is_lt() { -ratio } else { ratio }
        })))
    }

    /// The quotient of two numbers 0 ≤ a ≤ b, b > 0, at this time, rounded down to a multiple of
    /// 2⁻⁵².
    ///
    /// The quotient at an end of the bracket is a guess, which signs prove or refute. Once the bracket is
    /// narrow enough, the quotient there and the one at this time differ by less than 1/2 unit, and the
    /// guess is off by less than 1/2 more. Its floor is then at most one above or below that of the quotient
    /// q, so that the floor of q is at least `low` and below `high`: the loop ends.
    pub(crate) fn ratio(&self, a: &Polynomial, b: &Polynomial) -> f64 {
        let scaled = a.shifted(BITS);
        let reaches = |n: u64| {
            self.sign(&(&scaled - &(&Polynomial::constant(n.into()) * b)))
                .is_ge()
        };
        loop {
            if let Some(guess) = self.guess(&scaled, b) {
                let (low, high) = (guess.saturating_sub(1), guess.saturating_add(2));
                if reaches(low) && !reaches(high) {
                    let floor = (low + 1..high).take_while(|&n| reaches(n)).last().unwrap_or(low);
                    return floor as f64 / (1_u64 << BITS) as f64;
                }
            }
            self.narrow_by(64);
        }
    }

    /// The quotient of two numbers at an end of the bracket, rounded down after an error of less than 1/8, if
    /// it is in the range of u64.
    ///
    /// Both numbers are known to 58 bits, and then rounded down to a unit of at most 2⁻⁵⁷ of b: the quotient,
    /// at most about 2⁵², is off by less than 2⁻⁵⁷ + 2⁻⁵⁶ of itself and by 2⁻⁵⁷.
    fn guess(&self, a: &Polynomial, b: &Polynomial) -> Option<u64> {
        let t = self.lower_bound();
        let [a, b] = [a, b].map(|polynomial| polynomial.value_at(&t, BITS + GUARD));
        let unit = b.top() - (BITS + GUARD) as isize;
        let [a, b] = [a, b].map(|value| value.in_units(unit));
        (!b.is_zero()).then(|| u64::try_from(a / b).ok())?
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec;

    use dashu_int::IBig;

    use super::*;
    use crate::exact::instant::Instant;
    use crate::exact::roots::roots;
    use crate::exact::split::Split;

    /// A polynomial that vanishes at the time is added to both numbers.
    #[test]
    fn ratios_do_not_depend_on_the_slope() {
        for (m, bits) in [(1, None), ((1_u64 << 59) - 55, Some(59))] {
            let denominator = bits.map_or(IBig::from(3), |bits: usize| IBig::ONE << bits);
            let vanishing = Polynomial::new(vec![-IBig::from(m), denominator]);
            for steepness in 0..130 {
                for steep in [vanishing.shifted(steepness), -vanishing.shifted(steepness)] {
                    for x in [0_u64, 1, 5, 7] {
                        let instant = match bits {
                            Some(bits) => Instant::At(Split::ratio(m.into(), -(bits as isize))),
                            None => roots(vec![vanishing.clone()]).remove(0),
                        };
                        let [a, b] = [x, 7].map(|x| Polynomial::between(&x.into(), &x.into()));
                        let expected = ((u128::from(x) << BITS) / 7) as f64 / (1_u64 << BITS) as f64;
                        let found = Narrowing::new(instant).ratio(&(&a + &steep), &b);
                        assert_eq!(found, expected, "{steepness} {x}");
                    }
                }
            }
        }
    }
}
