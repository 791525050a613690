//! Roots next to an extremum, of any flatness.

use alloc::sync::Arc;
use alloc::vec;

use dashu_int::IBig;

use super::{Bracket, End};
use crate::exact::polynomial::Polynomial;
use crate::exact::roots::roots;
use crate::exact::split::Split;

/// (t − s)ᵐ a 2ᵐᵏ − (t + s)ᵐ. The roots are near t / s = 1 ± 2¹⁻ᵏ, for a = 1.
fn flat(power: usize, factor: u32, halvings: usize) -> Polynomial {
    let power_of = |base: [i32; 2]| {
        let base = Polynomial::new(base.map(IBig::from).to_vec());
        (0..power).fold(Polynomial::constant(IBig::ONE), |product, _| &product * &base)
    };
    let scaled = &power_of([-1, 1]).shifted(power * halvings) * &Polynomial::constant(factor.into());
    &scaled - &power_of([1, 1])
}

#[test]
fn roots_next_to_an_extremum_are_found_at_any_distance() {
    for power in 1..=6 {
        for halvings in [3, 40, 333, 1500] {
            for factor in [1, 3, 1 << 30] {
                let polynomial = flat(power, factor, halvings);
                let found = roots(vec![polynomial.clone()]);
                assert_eq!(found.len(), 1 + usize::from(power % 2 == 0));
                for mut root in found {
                    root.narrow_to(2 * halvings);
                    let (low, high) = root.bounds();
                    let signs = [low, high].map(|t| polynomial.sign_at(t));
                    assert!(
                        signs[0] != signs[1] || signs[0].is_eq(),
                        "{power} {halvings} {factor}"
                    );
                    let one = Split::ratio(IBig::ONE, 0);
                    let distance = Split::closeness(low, &one).max(Split::closeness(&one, high));
                    assert!(
                        distance + 1 >= halvings,
                        "{power} {halvings} {factor}: {distance}"
                    );
                }
            }
        }
    }
}

/// The bracket [1 + 2⁻⁵⁰, 3/2] has one root, and another root is just before it. A coarse grid begins at 1.
#[test]
fn no_end_of_a_bracket_moves_outwards() {
    let at = |digits: u64, bits: isize| Split::ratio(digits.into(), -bits);
    let factor = |a: u64, bits: usize| Polynomial::new(vec![-IBig::from(a), IBig::ONE << bits]);
    let polynomial = &factor((1 << 51) + 1, 51) * &factor((3 << 44) - 1, 45);
    let ends = [at((1 << 50) + 1, 50), at(3, 1)].map(|time| End::of(&polynomial, &time));
    let mut bracket = Bracket::new(Arc::new(polynomial), ends);
    for _ in 0..40 {
        let before = bracket.clone();
        if bracket.narrow(32).is_err() {
            return;
        }
        assert!(before.low() <= bracket.low() && bracket.high() <= before.high());
        assert!(bracket.low() < bracket.high());
    }
}
