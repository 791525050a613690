//! A cheap proof that two polynomials have no common root: they have none modulo a prime.

use alloc::vec::Vec;

use dashu_int::IBig;

/// p = 2⁶¹ − 2373, modulo which the powers 2⁰ … 2ᵖ⁻² are different: p is 3 modulo 8, so that 2 is no square,
/// and (p − 1) / 2 is a prime too.
///
/// Coefficients with many factors 2 are frequent. Modulo 2⁶¹ − 1, only 61 powers of two are different, and
/// polynomials often have a common factor that they do not have over the integers.
const PRIME: i64 = (1 << 61) - 2373;

/// Returns true if two polynomials, given by their coefficients from the constant one up, certainly
/// have no common factor.
///
/// Let g be their greatest common divisor over the integers. Its leading coefficient divides the leading
/// coefficients of both. If one of these is not a multiple of the prime, neither is the leading coefficient
/// of g, so that g keeps its degree modulo the prime. There, g divides both polynomials, and hence their
/// greatest common divisor modulo the prime. If this divisor is a constant, so is g. (The converse fails for
/// about one prime of this size in 2⁶¹.)
pub(super) fn are_coprime(a: &[IBig], b: &[IBig]) -> bool {
    let [mut a, mut b] = [a, b].map(reduced);
    let keeps_degree = a.last().is_some_and(|&leading| leading != 0);
    while b.pop_if(|leading| *leading == 0).is_some() {}
    while let [others @ .., leading] = &b[..]
        && !others.is_empty()
    {
        let rest = remainder(a, *leading, others);
        (a, b) = (b, rest);
    }
    keeps_degree && b.len() == 1
}

fn reduced(coefficients: &[IBig]) -> Vec<i64> {
    let modulo = |coefficient: &IBig| (coefficient % PRIME).rem_euclid(PRIME);
    coefficients.iter().map(modulo).collect()
}

/// The remainder of a division, times a number that is not zero.
fn remainder(mut a: Vec<i64>, leading: i64, rest: &[i64]) -> Vec<i64> {
    let modulo = |x: i128| (x % i128::from(PRIME)) as i64;
    let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
    while a.len() > rest.len() {
        let top = a.pop().unwrap_or_default();
        let shift = a.len() - rest.len();
        for (i, x) in a.iter_mut().enumerate() {
            let subtrahend = if i < shift {
                0
            } else {
                product(top, rest[i - shift])
            };
            *x = modulo(product(*x, leading) - subtrahend).rem_euclid(PRIME);
        }
    }
    while a.pop_if(|leading| *leading == 0).is_some() {}
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(a: &[i64], b: &[i64]) -> Vec<IBig> {
        let mut product = alloc::vec![IBig::ZERO; a.len() + b.len() - 1];
        for (i, &x) in a.iter().enumerate() {
            for (j, &y) in b.iter().enumerate() {
                product[i + j] += IBig::from(x) * IBig::from(y);
            }
        }
        product
    }

    #[test]
    fn polynomials_with_a_common_factor_are_not_coprime() {
        // The last factors are constant modulo the prime, which no longer proves that they are not common.
        for factor in [[1, 1], [-3, 2], [PRIME - 1, 5], [1, PRIME], [-7, 2 * PRIME]] {
            for [other, another] in [[[1, 2], [1, 3]], [[2, -1], [5, 7]]] {
                let [a, b] = [other, another].map(|other| product(&factor, &other));
                assert!(!are_coprime(&a, &b), "{factor:?}");
                assert!(!are_coprime(&b, &a), "{factor:?}");
                assert!(!are_coprime(&a, &product(&factor, &[1])), "{factor:?}");
            }
        }
    }

    #[test]
    fn most_others_are() {
        for (a, b) in [([1, 1], [1, 2]), ([3, -4], [5, 6]), ([0, 1], [1, 1])] {
            assert!(are_coprime(&product(&a, &[1]), &product(&b, &[1])));
            assert!(are_coprime(&product(&a, &a), &product(&b, &b)));
        }
    }
}
