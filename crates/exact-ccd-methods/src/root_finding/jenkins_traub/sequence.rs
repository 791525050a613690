//! The sequence of polynomials K, and the factors of P that they approximate.

use super::super::polynomial::Polynomial;
use super::division::{Quadratic, Remainder, divide, negligible};

/// The first stage: (K − (K(0) / P(0)) P) / z, with the leading coefficient of P unless K(0) is zero.
pub(super) fn step_without_shift(p: &Polynomial, k: &Polynomial) -> Polynomial {
    let ([p0, p1], k0) = ([p.coefficient(0), p.coefficient(1)], k.coefficient(0));
    let after = |i: usize| k.coefficient(i + 1);
    if k0.abs() <= negligible(p1) {
        Polynomial::from_fn(p.degree() - 1, after)
    } else {
        let ratio = -p0 / k0;
        Polynomial::from_fn(p.degree() - 1, |i| p.coefficient(i + 1) + ratio * after(i))
    }
}

/// The next K for the shifts at the zeros of σ, with the leading coefficient of P if possible.
///
/// It is (k₀ K + (z + k₁) P) / σ. With P = σ Q + b (z + u) + a and K = σ R + d (z + u) + c, that is
/// a polynomial if k₀ = (a² + u a b + v b²) / (b c − a d) and k₁ = −(a c + u a d + v b d) / (b c −
/// a d).
pub(super) fn step(p: &Polynomial, k: &Polynomial, sigma: Quadratic) -> Polynomial {
    let Quadratic { u, v } = sigma;
    let (q, Remainder { a, b }) = divide(p, sigma);
    let (r, Remainder { a: c, b: d }) = divide(k, sigma);
    let determinant = b * c - a * d;
    let of_r = a * a + u * a * b + v * b * b;
    let of_q = a * c + u * a * d + v * b * d;
    let n = p.degree();
    if determinant.abs() <= negligible((b * c).abs() + (a * d).abs()) {
        // K contains σ, or is a multiple of P on its zeros.
        return Polynomial::from_fn(n - 1, |i| of_r * r.coefficient(i) - of_q * q.coefficient(i));
    }
    let (of_r, of_q) = (of_r / determinant, of_q / determinant);
    Polynomial::from_fn(n - 1, |i| {
        let leading = if i == 0 { b } else { q.coefficient(i - 1) };
        of_r * r.coefficient(i) - of_q * q.coefficient(i) + leading
    })
}

/// The quadratic factor of P that K and σ suggest.
///
/// If K is P without two zeros, it satisfies K + u K′ + v K″ = 0 modulo σ, where each dash is a
/// step without a shift and z² + u z + v has these zeros.
pub(super) fn estimate(p: &Polynomial, k: &Polynomial, sigma: Quadratic) -> Option<Quadratic> {
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
