//! Every precision against plain integers.

use alloc::vec::Vec;
use core::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

use crate::exact::polynomial::Polynomial;
use crate::exact::split::Split;

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
        let length = 1 + self.below(7);
        Polynomial::new((0..length).map(|_| self.integer()).collect())
    }

    /// A ratio with an exponent of any sign, and one above it.
    fn interval(&mut self) -> [Split; 2] {
        let exponent = [0, -30, 90, -700, 2000][self.below(5) as usize] - 20;
        let digits = 1 + self.below(1 << 20);
        let width = IBig::from(1 + self.below(1 << 20));
        let fine = [0, 5, 60, 900][self.below(4) as usize];
        let low = IBig::from(digits) << fine;
        let high = &low + width;
        [low, high].map(|a| Split::ratio(a, exponent - fine as isize))
    }
}

/// The sign of Σ cᵢ aⁱ 2ᵏⁱ, in integers.
fn plain_sign(polynomial: &Polynomial, t: &Split) -> Ordering {
    let mut sum = IBig::ZERO;
    let mut power = IBig::ONE;
    let degree = polynomial.coefficients().len() - 1;
    for (i, coefficient) in polynomial.coefficients().iter().enumerate() {
        let doublings = if t.exponent < 0 { degree - i } else { i };
        sum += (coefficient * &power) << (t.exponent.unsigned_abs() * doublings);
        power *= &t.elapsed;
    }
    sum.cmp(&IBig::ZERO)
}

#[test]
fn signs_at_every_precision_are_those_of_integers() {
    let mut random = Random(1);
    let precisions = [8, 60, 120, 480, 1920, 40_000];
    let mut known = [0; 6];
    for _ in 0..3000 {
        let polynomial = random.polynomial();
        let [t, _] = random.interval();
        let sign = plain_sign(&polynomial, &t);
        for (known, precision) in known.iter_mut().zip(precisions) {
            let found = polynomial.values(&t, &t, precision).sign();
            assert!(found.is_none_or(|found| found == sign), "{polynomial:?} {t:?}");
            *known += usize::from(found.is_some());
        }
        assert_eq!(polynomial.sign_at(&t), sign);
    }
    assert!(known.is_sorted() && known[0] < known[1], "{known:?}");
}

#[test]
fn a_sign_between_two_times_is_that_of_all_values() {
    let mut random = Random(2);
    let mut proved = 0;
    for _ in 0..5000 {
        let polynomial = random.polynomial();
        let [low, high] = random.interval();
        let Some(sign) = polynomial.values_between(&low, &high).sign() else {
            continue;
        };
        proved += 1;
        let grid = |index: u64| Split::on_grid(&low, &high, &index.into(), 3);
        let inside: Vec<Split> = (1..8).map(grid).collect();
        for t in [&low, &high].into_iter().chain(&inside) {
            assert_eq!(plain_sign(&polynomial, t), sign, "{polynomial:?} {t:?}");
        }
    }
    assert!(proved > 1000, "{proved}");
}

#[test]
fn an_expansion_has_the_values_of_its_polynomial() {
    let mut random = Random(3);
    let mut known = 0;
    for _ in 0..5000 {
        let polynomial = random.polynomial();
        let [low, high] = random.interval();
        if Split::closeness(&low, &high) < 8 {
            continue;
        }
        let unit = polynomial.top_at(high.top()) - [10, 100, 2000][random.below(3) as usize];
        let expansion = polynomial.expansion(&low, &high, unit);
        let grid = |index: u64| Split::on_grid(&low, &high, &index.into(), 3);
        let inside: Vec<Split> = (1..8).map(grid).collect();
        for t in [&low, &high].into_iter().chain(&inside) {
            let (found, exact) = (expansion.value_at(t), polynomial.plain_value(t));
            let unit = found.unit.min(exact.unit);
            let off = (found.in_units(unit) - exact.in_units(unit)).bit_len();
            let error = found.error.unwrap_or_default() as isize + found.unit - unit;
            assert!(off as isize <= error, "{polynomial:?} {t:?}: {off} {error}");
            known += usize::from(found.sign().is_some());
        }
    }
    assert!(known > 10_000, "{known}");
}

/// Two roots with an extremum between them, and an interval from the extremum across one of them.
#[test]
fn an_interval_with_a_root_has_no_sign() {
    let mut random = Random(4);
    for _ in 0..5000 {
        let a = (1 << 30) + random.below(1 << 30);
        let bits = random.below(26);
        let width = 1 + random.below(1 << bits);
        let distance = 1 + random.below(width);
        let factor = |root: u64| Polynomial::new([-IBig::from(root), IBig::ONE << 30].to_vec());
        let polynomial = &factor(a - distance) * &factor(a + distance);
        for ends in [[a, a + width], [a - width, a]] {
            let [low, high] = ends.map(|a| Split::ratio(a.into(), -30));
            let sign = polynomial.values_between(&low, &high).sign();
            assert_eq!(sign, None, "{a} {width} {distance}");
        }
    }
}

#[test]
fn errors_add_up_to_at_most_their_bound() {
    let digits = (IBig::ONE << 200) - IBig::ONE;
    let t = Split::ratio(digits.clone(), -200);
    for length in 1..=64 {
        let polynomial = Polynomial::new((0..length).map(|_| digits.clone()).collect());
        for precision in [8, 20, 60] {
            let (found, exact) = (polynomial.values(&t, &t, precision), polynomial.plain_value(&t));
            let unit = found.unit.min(exact.unit);
            let off = (found.in_units(unit) - exact.in_units(unit)).bit_len() as isize;
            let bound = found.error.unwrap_or_default() as isize + found.unit - unit;
            assert!(off <= bound, "{length} {precision}");
        }
    }
}
