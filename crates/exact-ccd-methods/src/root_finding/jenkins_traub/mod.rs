//! The zeros of a real polynomial, by the three-stage algorithm of Jenkins and Traub.
//!
//! M. A. Jenkins and J. F. Traub, *A Three-Stage Algorithm for Real Polynomials Using Quadratic
//! Iteration*, SIAM Journal on Numerical Analysis 7(4), 1970. The details that it leaves open (limits
//! of iterations, stopping criteria) follow M. A. Jenkins, *Algorithm 493: Zeros of a Real Polynomial*,
//! ACM Transactions on Mathematical Software 1(2), 1975.
//!
//! A sequence of polynomials K, of one degree less than P, converges to P without its smallest zeros.
//! Each step subtracts from K the multiple of P that makes it divisible by z (first stage), by a
//! fixed quadratic σ (second stage), or by the latest estimate of a factor of P (third stage), and
//! divides.

mod division;
mod factor;
mod iteration;
mod sequence;

use arrayvec::ArrayVec;

use super::polynomial::{MAX_DEGREE, Polynomial};
use division::Quadratic;
use factor::{Factor, quadratic_zeros};
use iteration::fixed_shift;
use sequence::step_without_shift;

pub(super) use factor::Zero;

/// The zeros of a polynomial, the smaller ones roughly first. If an iteration does not converge or a
/// coefficient is not finite, only the zeros found before.
pub(super) fn zeros(polynomial: &Polynomial) -> ArrayVec<Zero, MAX_DEGREE> {
    let mut p = normalized(polynomial.trimmed());
    let mut zeros = ArrayVec::new();
    while p.coefficients().iter().all(|c| c.is_finite()) {
        let factor = match *p.coefficients() {
            [] | [_] => break,
            [c0, c1] => Factor::linear(-c0 / c1, Polynomial::new([c1])),
            [c0, c1, c2] => Factor {
                zeros: ArrayVec::from(quadratic_zeros(c2, c1, c0)),
                quotient: Polynomial::new([c2]),
            },
            [0.0, ..] => Factor::linear(0.0, shifted(&p)),
            _ => match factor(&p) {
                Some(factor) => factor,
                None => break,
            },
        };
        zeros.extend(factor.zeros);
        p = factor.quotient;
    }
    zeros
}

/// P with the power of two as a factor that makes its largest coefficient less than 2, but not less than 1.
fn normalized(p: Polynomial) -> Polynomial {
    let largest = p.coefficients().iter().fold(0.0_f64, |max, c| max.max(c.abs()));
    let exponent = f64::from_bits(largest.to_bits() & f64::INFINITY.to_bits());
    Polynomial::from_fn(p.degree(), |i| {
        p.coefficients()[i] / exponent.max(f64::MIN_POSITIVE)
    })
}

/// P / z, for a P that vanishes at zero.
fn shifted(p: &Polynomial) -> Polynomial {
    Polynomial::from_fn(p.degree() - 1, |i| p.coefficients()[i + 1])
}

/// A factor of P with its smallest zero or pair of zeros. P has at least degree three and does not
/// vanish at zero.
fn factor(p: &Polynomial) -> Option<Factor> {
    let start = (0..5).fold(derivative(p), |k, _| step_without_shift(p, &k));
    let radius = zero_free_radius(p);
    // If a direction does not converge, the next one is turned by an angle; no small multiple of that
    // angle is a full turn.
    (1..=20_u32).find_map(|attempt| {
        let angle = (94.0 * f64::from(attempt) - 45.0).to_radians();
        let sigma = Quadratic {
            u: -2.0 * radius * angle.cos(),
            v: radius * radius,
        };
        fixed_shift(p, start, sigma, 20 * attempt)
    })
}

/// The derivative of P, with the leading coefficient of P.
fn derivative(p: &Polynomial) -> Polynomial {
    let n = p.degree();
    Polynomial::from_fn(n - 1, |i| (i + 1) as f64 * p.coefficients()[i + 1] / n as f64)
}

/// A lower bound on the absolute values of the zeros, to two digits: the positive zero of |cₙ| xⁿ +
/// … + |c₁| x − |c₀|.
fn zero_free_radius(p: &Polynomial) -> f64 {
    let c = p.coefficients();
    let bound = Polynomial::from_fn(p.degree(), |i| if i == 0 { -c[0].abs() } else { c[i].abs() });
    let slope = Polynomial::from_fn(p.degree() - 1, |i| (i + 1) as f64 * bound.coefficients()[i + 1]);
    let mut x = (c[0] / c[p.degree()])
        .abs()
        .powf((p.degree() as f64).recip())
        .min(f64::MAX);
    if c[1] != 0.0 {
        x = x.min((c[0] / c[1]).abs());
    }
    // Terminates, because the value at zero is negative.
    while bound.at(0.1 * x) > 0.0 {
        x *= 0.1;
    }
    // Newton's method from above on a convex function takes a few steps.
    for _ in 0..50 {
        let change = bound.at(x) / slope.at(x);
        x -= change;
        if change.abs() <= 0.005 * x {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn from_zeros(real: &[f64], pairs: &[(f64, f64)]) -> Polynomial {
        let linear = real.iter().map(|&s| Polynomial::new([-s, 1.0]));
        let quadratic = pairs
            .iter()
            .map(|&(re, im)| Polynomial::new([re * re + im * im, -2.0 * re, 1.0]));
        linear.chain(quadratic).fold(Polynomial::new([1.0]), |p, f| p * f)
    }

    fn sorted_real_parts(p: &Polynomial) -> Vec<f64> {
        let mut parts: Vec<_> = zeros(p).into_iter().map(|zero| zero.re).collect();
        parts.sort_by(f64::total_cmp);
        parts
    }

    fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
        assert_eq!(found.len(), expected.len(), "{found:?} for {expected:?}");
        for (x, y) in found.iter().zip(expected) {
            assert!((x - y).abs() <= tolerance, "{found:?} for {expected:?}");
        }
    }

    #[test]
    fn separate_zeros_are_found() {
        let real = [-2.0, -0.5, 0.25, 0.75, 1.5, 4.0];
        for n in 1..=6 {
            assert_close(
                &sorted_real_parts(&from_zeros(&real[..n], &[])),
                &real[..n],
                1e-12,
            );
        }
    }

    #[test]
    fn complex_pairs_are_found_with_their_imaginary_parts() {
        let found = zeros(&from_zeros(&[0.5], &[(0.25, 2.0), (-1.0, 0.5)]));
        assert_eq!(found.len(), 5);
        for (re, im) in [(0.5, 0.0), (0.25, 2.0), (0.25, -2.0), (-1.0, 0.5), (-1.0, -0.5)] {
            assert!(
                found.iter().any(|z| (z.re - re).hypot(z.im - im) < 1e-12),
                "{found:?}"
            );
        }
    }

    #[test]
    fn zeros_at_the_origin_are_found() {
        assert_close(
            &sorted_real_parts(&Polynomial::new([0.0, 0.0, 0.0, 2.0])),
            &[0.0; 3],
            0.0,
        );
        assert_close(
            &sorted_real_parts(&from_zeros(&[0.0, 0.0, 0.5], &[])),
            &[0.0, 0.0, 0.5],
            1e-15,
        );
    }

    /// The error of a double zero is about the square root of the precision.
    #[test]
    fn double_zeros_come_as_close_pairs() {
        let c = from_zeros(&[0.1, 0.7, -3.0], &[]);
        assert_close(
            &sorted_real_parts(&(c * c)),
            &[-3.0, -3.0, 0.1, 0.1, 0.7, 0.7],
            1e-6,
        );
    }

    #[test]
    fn constants_have_no_zeros() {
        assert!(zeros(&Polynomial::new([0.0; 7])).is_empty());
        assert!(zeros(&Polynomial::new([1.0])).is_empty());
    }

    proptest! {
        /// All zeros, and where the polynomial is small compared with what its terms can be.
        #[test]
        fn the_polynomial_vanishes_at_its_zeros(coefficients in prop::array::uniform7(-1.0..1.0)) {
            let p = Polynomial::new(coefficients);
            let found = zeros(&p);
            prop_assert_eq!(found.len(), 6);
            for zero in found {
                let (mut re, mut im) = (0.0, 0.0);
                let (mut size, modulus) = (0.0, zero.re.hypot(zero.im));
                for c in coefficients.iter().rev() {
                    (re, im) = (re * zero.re - im * zero.im + c, re * zero.im + im * zero.re);
                    size = size * modulus + c.abs();
                }
                prop_assert!(re.hypot(im) <= 1e-9 * size, "{zero:?}: {}", re.hypot(im) / size);
            }
        }

        #[test]
        fn any_numbers_come_to_an_end(coefficients in prop::array::uniform7(any::<f64>())) {
            prop_assert!(zeros(&Polynomial::new(coefficients)).len() <= 6);
        }
    }
}
