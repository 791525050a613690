//! The zeros of a real polynomial, by the three-stage algorithm of Jenkins and Traub.
//!
//! M. A. Jenkins and J. F. Traub, *A Three-Stage Algorithm for Real Polynomials Using Quadratic
//! Iteration*, SIAM Journal on Numerical Analysis 7(4), 1970. What the paper leaves open (limits of
//! iterations, when to stop) is as in M. A. Jenkins, *Algorithm 493: Zeros of a Real Polynomial*,
//! ACM Transactions on Mathematical Software 1(2), 1975.
//!
//! A sequence of polynomials K, of one degree less than P, comes to be P without its smallest
//! zeros. Each step takes from K the multiple of P that makes it divisible by z (first stage), by a
//! fixed quadratic σ (second stage), or by the latest estimate of a factor of P (third stage), and
//! divides.

use arrayvec::ArrayVec;

use super::polynomial::{MAX_DEGREE, Polynomial};

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Zero {
    pub(super) re: f64,
    pub(super) im: f64,
}

impl Zero {
    fn real(re: f64) -> Self {
        Self { re, im: 0.0 }
    }
}

/// The zeros of a polynomial, the smaller ones roughly first. All of them, unless an iteration does
/// not converge or a coefficient is not finite: then those found before.
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

/// Zeros that have been found, and the polynomial without them.
struct Factor {
    zeros: ArrayVec<Zero, 2>,
    quotient: Polynomial,
}

impl Factor {
    fn linear(zero: f64, quotient: Polynomial) -> Self {
        Self {
            zeros: [Zero::real(zero)].into_iter().collect(),
            quotient,
        }
    }
}

/// z² + u z + v.
#[derive(Clone, Copy)]
struct Quadratic {
    u: f64,
    v: f64,
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

/// The zeros of a z² + b z + c. Of two real ones, the smaller comes first.
fn quadratic_zeros(a: f64, b: f64, c: f64) -> [Zero; 2] {
    let half = b / 2.0;
    let discriminant = half * half - a * c;
    let root = discriminant.abs().sqrt();
    if discriminant < 0.0 {
        let (re, im) = (-half / a, root / a);
        return [Zero { re, im }, Zero { re, im: -im }];
    }
    let sum = -(half + root.copysign(half));
    // Both vanish only together.
    let smaller = if sum == 0.0 { 0.0 } else { c / sum };
    [Zero::real(smaller), Zero::real(sum / a)]
}

/// P / (z − s) and P(s).
fn divide_by_linear(p: &Polynomial, s: f64) -> (Polynomial, f64) {
    let mut quotient = [0.0; MAX_DEGREE + 1];
    let mut value = 0.0;
    for (i, c) in p.coefficients().iter().enumerate().rev() {
        quotient[i] = value;
        value = value * s + c;
    }
    (Polynomial::from_fn(p.degree() - 1, |i| quotient[i]), value)
}

/// b (z + u) + a, the remainder of a division by z² + u z + v.
#[derive(Clone, Copy)]
struct Remainder {
    a: f64,
    b: f64,
}

/// P / σ and its remainder.
fn divide(p: &Polynomial, sigma: Quadratic) -> (Polynomial, Remainder) {
    let mut quotient = [0.0; MAX_DEGREE + 1];
    let (mut a, mut b) = (0.0, 0.0);
    for (i, c) in p.coefficients().iter().enumerate().rev() {
        quotient[i] = b;
        (a, b) = (c - sigma.u * a - sigma.v * b, a);
    }
    (
        Polynomial::from_fn(p.degree() - 2, |i| quotient[i]),
        Remainder { a, b },
    )
}

/// The bound below which sums of terms of this size count as zero.
fn negligible(size: f64) -> f64 {
    10.0 * f64::EPSILON * size.abs()
}

/// A factor of P with its smallest zero or pair of zeros. P has at least degree three and does not
/// vanish at zero.
fn factor(p: &Polynomial) -> Option<Factor> {
    let start = (0..5).fold(derivative(p), |k, _| step_without_shift(p, &k));
    let radius = zero_free_radius(p);
    // Another direction whenever one does not converge, by an angle of which no small multiple is a
    // full turn.
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
    // Ends, as the value at zero is negative.
    while bound.at(0.1 * x) > 0.0 {
        x *= 0.1;
    }
    // From above, on a convex function; it takes a few steps.
    for _ in 0..50 {
        let change = bound.at(x) / slope.at(x);
        x -= change;
        if change.abs() <= 0.005 * x {
            break;
        }
    }
    x
}

/// The first stage: (K − (K(0) / P(0)) P) / z, with the leading coefficient of P unless K(0) is zero.
fn step_without_shift(p: &Polynomial, k: &Polynomial) -> Polynomial {
    let (p, k) = (p.coefficients(), k.coefficients());
    let after = |i: usize| k.get(i + 1).copied().unwrap_or(0.0);
    if k[0].abs() <= negligible(p[1]) {
        Polynomial::from_fn(p.len() - 2, after)
    } else {
        let ratio = -p[0] / k[0];
        Polynomial::from_fn(p.len() - 2, |i| p[i + 1] + ratio * after(i))
    }
}

/// The next K for the shifts at the zeros of σ, with the leading coefficient of P if possible.
///
/// It is (k₀ K + (z + k₁) P) / σ. With P = σ Q + b (z + u) + a and K = σ R + d (z + u) + c, that is
/// a polynomial if k₀ = (a² + u a b + v b²) / (b c − a d) and k₁ = −(a c + u a d + v b d) / (b c −
/// a d).
fn step(p: &Polynomial, k: &Polynomial, sigma: Quadratic) -> Polynomial {
    let Quadratic { u, v } = sigma;
    let (q, Remainder { a, b }) = divide(p, sigma);
    let (r, Remainder { a: c, b: d }) = divide(k, sigma);
    let determinant = b * c - a * d;
    let of_r = a * a + u * a * b + v * b * b;
    let of_q = a * c + u * a * d + v * b * d;
    let n = p.degree();
    let at = |polynomial: &Polynomial, i: usize| polynomial.coefficients().get(i).copied().unwrap_or(0.0);
    if determinant.abs() <= negligible((b * c).abs() + (a * d).abs()) {
        // K contains σ, or is a multiple of P on its zeros.
        return Polynomial::from_fn(n - 1, |i| of_r * at(&r, i) - of_q * at(&q, i));
    }
    let (of_r, of_q) = (of_r / determinant, of_q / determinant);
    Polynomial::from_fn(n - 1, |i| {
        let leading = if i == 0 { b } else { at(&q, i - 1) };
        of_r * at(&r, i) - of_q * at(&q, i) + leading
    })
}

/// The quadratic factor of P that K and σ suggest.
///
/// If K is P without two zeros, it satisfies K + u K′ + v K″ = 0 modulo σ, where each dash is a
/// step without a shift and z² + u z + v has these zeros.
fn estimate(p: &Polynomial, k: &Polynomial, sigma: Quadratic) -> Option<Quadratic> {
    let Quadratic { u, v } = sigma;
    // A residue α z + β modulo σ as [α, β], and its product with 1 / z.
    let residue = |f: &Polynomial| {
        let Remainder { a, b } = divide(f, sigma).1;
        [b, a + u * b]
    };
    let over_z = |[alpha, beta]: [f64; 2]| [-beta / v, alpha - u * (beta / v)];
    let combine = |s: f64, x: [f64; 2], t: f64, y: [f64; 2]| [s * x[0] + t * y[0], s * x[1] + t * y[1]];
    let det = |x: [f64; 2], y: [f64; 2]| x[0] * y[1] - x[1] * y[0];

    let (c, h) = (p.coefficients(), k.coefficients());
    let ratio = h[0] / c[0];
    let next_ratio = (h[1] - ratio * c[1]) / c[0];
    let of_p = residue(p);
    // K / z and K / z² modulo σ, and by how much K′ and K″ differ from them: as P is nearly zero
    // there, by little.
    let first = over_z(residue(k));
    let second = over_z(first);
    let first_off = over_z(combine(-ratio, of_p, 0.0, of_p));
    let second_off = over_z(combine(1.0, first_off, -next_ratio, of_p));
    let first = combine(1.0, first, 1.0, first_off);
    let second = combine(1.0, second, 1.0, second_off);
    let off = combine(u, first_off, v, second_off);
    let determinant = det(first, second);
    let estimate = Quadratic {
        u: u - det(off, second) / determinant,
        v: v - det(first, off) / determinant,
    };
    (estimate.u.is_finite() && estimate.v.is_finite() && estimate.v != 0.0).then_some(estimate)
}

/// Successive estimates of the same number, and whether they seem to converge.
struct Sequence {
    value: f64,
    change: f64,
    /// The bound of the product of two successive relative changes.
    threshold: f64,
}

impl Sequence {
    fn new() -> Self {
        Self {
            value: f64::INFINITY,
            change: 1.0,
            threshold: 0.25,
        }
    }

    /// Adds an estimate. The product of its relative change with that before, if they decrease and pass.
    fn push(&mut self, value: f64) -> Option<f64> {
        let change = ((value - self.value) / value).abs();
        let change = if change.is_finite() { change } else { 1.0 };
        let product = change * self.change;
        let passes = change < self.change && product < self.threshold;
        (self.value, self.change) = (value, change);
        passes.then_some(product)
    }

    fn tighten(&mut self) {
        self.threshold *= 0.25;
    }
}

/// The second stage: steps with the same σ until the estimates of a zero or of a quadratic factor
/// converge, and from there the third.
fn fixed_shift(p: &Polynomial, mut k: Polynomial, sigma: Quadratic, limit: u32) -> Option<Factor> {
    let (mut linear, mut quadratic) = (Sequence::new(), Sequence::new());
    for _ in 0..limit {
        k = step(p, &k, sigma);
        let zero = -p.coefficients()[0] / k.coefficients()[0];
        let factor = estimate(p, &k, sigma);
        let linear_passes = linear.push(zero);
        let quadratic_passes = quadratic.push(factor.map_or(0.0, |f| f.v));
        let quadratic_first = match (linear_passes, quadratic_passes) {
            (Some(of_linear), Some(of_quadratic)) => of_quadratic <= of_linear,
            (_, passes) => passes.is_some(),
        };
        let try_quadratic = || {
            factor
                .filter(|_| quadratic_passes.is_some())
                .and_then(|f| quadratic_iteration(p, k, f))
        };
        let try_linear = || linear_passes.and_then(|_| linear_iteration(p, k, zero));
        let found = if quadratic_first {
            try_quadratic().or_else(try_linear)
        } else {
            try_linear().or_else(try_quadratic)
        };
        if found.is_some() {
            return found;
        }
        if linear_passes.is_some() {
            linear.tighten();
        }
        if quadratic_passes.is_some() {
            quadratic.tighten();
        }
    }
    None
}

/// The third stage for a pair of zeros that are complex or close to each other.
fn quadratic_iteration(p: &Polynomial, mut k: Polynomial, mut sigma: Quadratic) -> Option<Factor> {
    let mut last_residual = 0.0;
    let mut change = 0.0_f64;
    let mut stalled = false;
    let mut steps = 0;
    while steps <= 20 {
        let zeros = quadratic_zeros(1.0, sigma.u, sigma.v);
        let [smaller, larger] = zeros.map(|zero| zero.re.abs());
        if larger - smaller > 0.01 * larger {
            return None;
        }
        let (quotient, remainder) = divide(p, sigma);
        let residual = (remainder.a - zeros[0].re * remainder.b).abs() + (zeros[0].im * remainder.b).abs();
        if residual <= 20.0 * quadratic_error(&quotient, remainder, sigma, zeros[0]) {
            return Some(Factor {
                zeros: ArrayVec::from(zeros),
                quotient,
            });
        }
        steps += 1;
        if steps >= 2 && change <= 0.01 && residual >= last_residual && !stalled {
            // Several zeros close to each other: five steps from nearby.
            let offset = change.max(f64::EPSILON).sqrt();
            sigma = Quadratic {
                u: sigma.u - sigma.u * offset,
                v: sigma.v + sigma.v * offset,
            };
            k = (0..5).fold(k, |k, _| step(p, &k, sigma));
            stalled = true;
            steps = 0;
        }
        last_residual = residual;
        k = step(p, &k, sigma);
        let next = estimate(p, &k, sigma)?;
        change = ((next.v - sigma.v) / next.v).abs();
        sigma = next;
    }
    None
}

/// A bound on the rounding errors in the value at a zero of σ, from the quotient and the remainder.
fn quadratic_error(quotient: &Polynomial, remainder: Remainder, sigma: Quadratic, zero: Zero) -> f64 {
    let modulus = sigma.v.abs().sqrt();
    let product = zero.re * remainder.b;
    let value = (remainder.a - product).abs();
    let [lower @ .., leading] = quotient.coefficients() else {
        return 0.0;
    };
    let sum = lower
        .iter()
        .rev()
        .chain([&remainder.b])
        .fold(2.0 * leading.abs(), |sum, c| sum * modulus + c.abs())
        * modulus
        + value;
    f64::EPSILON * (9.0 * sum - 7.0 * (value + remainder.b.abs() * modulus) + 2.0 * product.abs())
}

/// The third stage for a real zero.
fn linear_iteration(p: &Polynomial, mut k: Polynomial, mut s: f64) -> Option<Factor> {
    let mut last_residual = 0.0;
    let mut change = 0.0_f64;
    for step in 0..=10 {
        let (quotient, value) = divide_by_linear(p, s);
        let residual = value.abs();
        if residual <= 20.0 * linear_error(&quotient, value, s) {
            return Some(Factor::linear(s, quotient));
        }
        if step >= 1 && change.abs() <= 0.001 * (s - change).abs() && residual >= last_residual {
            // Another zero is close.
            let double = Quadratic {
                u: -2.0 * s,
                v: s * s,
            };
            return quadratic_iteration(p, k, double);
        }
        last_residual = residual;
        let (of_k, value_of_k) = divide_by_linear(&k, s);
        let scale = negligible(k.coefficients()[0]);
        let at = |polynomial: &Polynomial, i: usize| polynomial.coefficients().get(i).copied().unwrap_or(0.0);
        k = if value_of_k.abs() <= scale {
            Polynomial::from_fn(p.degree() - 1, |i| at(&of_k, i))
        } else {
            let ratio = -value / value_of_k;
            Polynomial::from_fn(p.degree() - 1, |i| ratio * at(&of_k, i) + at(&quotient, i))
        };
        let value_of_k = k.at(s);
        change = if value_of_k.abs() > negligible(k.coefficients()[0]) {
            -value / value_of_k
        } else {
            0.0
        };
        s += change;
    }
    None
}

/// The running error bound of Horner's rule (N. J. Higham, *Accuracy and Stability of Numerical
/// Algorithms*, algorithm 5.1), from the quotient and the value.
fn linear_error(quotient: &Polynomial, value: f64, s: f64) -> f64 {
    let [lower @ .., leading] = quotient.coefficients() else {
        return 0.0;
    };
    let sum = lower
        .iter()
        .rev()
        .chain([&value])
        .fold(0.5 * leading.abs(), |sum, c| sum * s.abs() + c.abs());
    f64::EPSILON * (2.0 * sum - value.abs())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

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

    /// A double zero is as uncertain as the square root of the precision; so much for the squares of volumes.
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
        #![proptest_config(ProptestConfig {
            rng_seed: RngSeed::Fixed(0),
            failure_persistence: None,
            ..ProptestConfig::default()
        })]

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
