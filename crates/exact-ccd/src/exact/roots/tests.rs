//! Roots that are known, and signs at them that are known.

use alloc::vec;

use super::*;

/// The product of b t − a (1 − t) for pairs (a, b), which vanish at the ratios a / b.
fn product(ratios: &[[i64; 2]]) -> Polynomial {
    let linear = |[a, b]: [i64; 2]| Polynomial::new([-a, b].map(IBig::from).to_vec());
    let one = Polynomial::constant(IBig::ONE);
    ratios
        .iter()
        .fold(one, |product, &ratio| &product * &linear(ratio))
}

#[test]
fn signs_next_to_a_root_are_known() {
    let mut random = fastrand::Rng::with_seed(1);
    for _ in 0..1000 {
        let bits = random.u32(4..40);
        let [a, b] = [(); 2].map(|()| random.i64(1..1 << bits));
        let [c, d] = [a + random.i64(0..2), b + random.i64(0..2)];
        let other = product(&[[c, d]]);
        for ratios in [vec![[a, b]], vec![[a, b + 7], [a, b], [a + 7, b]]] {
            let roots = roots(vec![product(&ratios)]);
            assert_eq!(roots.len(), ratios.len());
            for (mut root, ratio) in roots.into_iter().zip(&ratios) {
                let [a, b, c, d] = [ratio[0], ratio[1], c, d].map(i128::from);
                assert_eq!(
                    root.narrow_to_sign(&other),
                    (a * d).cmp(&(b * c)),
                    "{ratios:?} {c} {d}"
                );
            }
        }
    }
}

/// Narrow brackets end at such a root.
#[test]
fn signs_next_to_a_root_of_few_digits_are_known() {
    for digits in 1..50 {
        // 1 ± 2⁻ᵏ, and numbers next to them.
        let one = 1_i64 << digits;
        let ratios = [[one - 1, one], [one + 1, one]];
        let roots = roots(vec![product(&ratios)]);
        assert_eq!(roots.len(), 2);
        for more in 1..(60 - digits) {
            for (root, [a, b]) in roots.iter().zip(ratios) {
                for offset in [-1, 0, 1] {
                    let other = product(&[[(a << more) + offset, b << more]]);
                    assert_eq!(
                        root.clone().narrow_to_sign(&other),
                        0.cmp(&offset),
                        "{digits} {more} {offset}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_common_divisor_has_the_common_roots() {
    let (t, u) = ([0, 1], [-1, 0]);
    let all: [&[[i64; 2]]; 8] = [
        &[],
        &[t],
        &[u],
        &[t, u],
        &[[1, 1]],
        &[t, [1, 1]],
        &[[1, 1], u],
        &[t, [1, 1], [3, 1], u],
    ];
    let small = |c: [i64; 3]| Polynomial::new(c.map(IBig::from).to_vec());
    for ratios in all {
        let common = product(ratios);
        let times = roots(vec![common.clone()]);
        let is_common = |divisor: Polynomial| {
            assert!(!divisor.is_zero(), "{ratios:?}");
            let found = roots(vec![divisor]);
            assert_eq!(found.len(), times.len(), "{ratios:?}");
            let mut found = found.into_iter();
            assert!(found.all(|mut time| time.narrow_to_sign(&common).is_eq()));
        };
        let zero = Polynomial::new(vec![IBig::ZERO; 3]);
        is_common(common.clone().gcd(zero.clone()));
        is_common(zero.gcd(common.clone()));
        for [a, b] in [
            [product(&[[1, 2]]), product(&[[1, 3]])],
            [small([1, -1, 1]), small([1, 0, 1])],
        ] {
            is_common((&common * &a).gcd(&common * &b));
        }
    }
    // 2 τ³ − 3 τ² + 1, whose derivative has the root 0.
    assert_eq!(roots(vec![product(&[[1, 1], [1, 1], [-1, 2]])]).len(), 1);
}

#[test]
fn roots_on_both_sides_of_a_bisection_are_two() {
    let one = 3_i64 << 40;
    for offsets in [[-1, 1], [1, -1]] {
        let polynomials = offsets.map(|offset| product(&[[one + offset, one]])).to_vec();
        assert_eq!(roots(polynomials).len(), 2);
    }
}

#[test]
fn the_sign_before_a_root_is_that_at_its_lower_bound() {
    let all: [&[[i64; 2]]; 4] = [
        &[[1, 3]],
        &[[1, 3], [1, 3]],
        &[[1, 3], [1, 3], [5, 7]],
        &[[1, 3], [5, 7]],
    ];
    for ratios in all {
        let polynomial = product(ratios);
        for root in roots(vec![polynomial.clone()]) {
            for other in [polynomial.clone(), -polynomial.clone(), polynomial.squared()] {
                let sign = root.sign_before(&other);
                let is_right = |sign| sign == other.sign_at(root.bounds().0);
                assert!(sign.is_none_or(is_right), "{ratios:?}");
            }
        }
    }
}
