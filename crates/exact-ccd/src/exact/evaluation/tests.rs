//! Every precision against plain integers.

use alloc::vec::Vec;
use core::cmp::Ordering;

use dashu_int::IBig;

use super::super::ball::Ball;
use super::super::dyadic::Dyadic;
use super::super::polynomial::Polynomial;

/// Knuth's linear congruential generator.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 33) % bound
    }

    /// An integer of up to 96 bits times a power of two, so that terms are far apart and cancel.
    fn integer(&mut self) -> IBig {
        let digits = (0..self.below(4)).fold(IBig::ZERO, |sum, _| (sum << 31) + self.below(1 << 31));
        let magnitude = digits << [0, 0, 200, 3000][self.below(4) as usize];
        if self.below(2) == 0 { magnitude } else { -magnitude }
    }

    fn polynomial(&mut self) -> Polynomial {
        let length = self.below(8);
        Polynomial::new((0..length).map(|_| self.integer()).collect())
    }

    /// A number in [0, 1].
    fn time(&mut self) -> Dyadic {
        let digits = self.below((1 << 20) + 1) as f64 / f64::from(1 << 20);
        Dyadic::from_unit(digits).halved([0, 1, 90, 700][self.below(4) as usize])
    }
}

/// The value at n / 2ᵏ times 2ᵏᵈ, in integers.
fn plain_value(polynomial: &Polynomial, t: &Dyadic) -> IBig {
    let terms = polynomial.coefficients().iter().rev().enumerate();
    terms.fold(IBig::ZERO, |sum, (power, coefficient)| {
        sum * &t.numerator + (coefficient << (t.exponent * power))
    })
}

/// The coefficients of (1 + s)ᵈ q((b + a s) / (1 + s)) times 2ᵏᵈ, as Σ cᵢ (b + a s)ⁱ (1 + s)ᵈ⁻ⁱ, in integers.
fn plain_descartes(polynomial: &Polynomial, low: &Dyadic, high: &Dyadic) -> Vec<IBig> {
    let ([a, b], exponent) = Dyadic::align(low, high);
    let (inner, outer) = (
        Polynomial::new([b, a].into()),
        Polynomial::new([IBig::ONE; 2].into()).shifted(exponent),
    );
    let degree = polynomial.coefficients().len().saturating_sub(1);
    let power =
        |base: &Polynomial, exponent| (0..exponent).fold(Polynomial::one(), |product, _| &product * base);
    let mut sum = Polynomial::zero();
    for (i, coefficient) in polynomial.coefficients().iter().enumerate() {
        let term = &power(&inner, i) * &power(&outer, degree - i);
        sum = &sum + &(&term * &Polynomial::new([coefficient.clone()].into()));
    }
    sum.coefficients().to_vec()
}

fn signs_agree(balls: &[Ball], integers: &[IBig]) -> usize {
    let agrees = |(i, ball): (usize, &Ball)| {
        let exact = integers.get(i).map_or(Ordering::Equal, |x| x.cmp(&IBig::ZERO));
        let sign = ball.sign();
        assert!(sign.is_none_or(|sign| sign == exact), "{ball:?} {integers:?}");
        sign.is_some()
    };
    balls.iter().enumerate().filter(|&ball| agrees(ball)).count()
}

#[test]
fn signs_at_every_precision_are_those_of_integers() {
    let mut random = Random(1);
    let mut known = [0; 6];
    let mut all = 0;
    for _ in 0..2000 {
        let polynomial = random.polynomial();
        let mut times = [random.time(), random.time()];
        times.sort();
        let [low, high] = times;
        let value = [plain_value(&polynomial, &low)];
        let descartes = plain_descartes(&polynomial, &low, &high);
        all += 1 + polynomial.coefficients().len();
        for (known, precision) in known.iter_mut().zip([8, 60, 120, 480, 1920, usize::MAX]) {
            *known += signs_agree(&[polynomial.at(&low, precision)], &value);
            *known += signs_agree(&polynomial.descartes(&low, &high, precision), &descartes);
        }
        assert_eq!(polynomial.sign_at(&low), value[0].cmp(&IBig::ZERO));
    }
    // Each precision proves more signs than the one before it, and none is unknown without rounding.
    assert!(
        known.is_sorted() && known[0] < known[1] && known[5] == all,
        "{known:?} {all}"
    );
}

#[test]
fn a_sign_between_two_times_is_that_of_all_values() {
    let mut random = Random(2);
    let mut proved = 0;
    for _ in 0..5000 {
        let polynomial = random.polynomial();
        let mut times = [random.time(), random.time()];
        times.sort();
        let [low, high] = times;
        if low == high {
            continue;
        }
        let Some(sign) = polynomial.sign_between(&low, &high) else {
            continue;
        };
        proved += 1;
        for halvings in [1, 2, 5, 60] {
            for [from, to] in [[&low, &high], [&high, &low]] {
                let t = Dyadic::towards(from, to, halvings);
                assert_eq!(
                    plain_value(&polynomial, &t).cmp(&IBig::ZERO),
                    sign,
                    "{polynomial:?} {t:?}"
                );
            }
        }
    }
    assert!(proved > 1000, "{proved}");
}
