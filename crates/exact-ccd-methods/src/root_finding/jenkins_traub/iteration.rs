//! The second and the third stage: steps until the estimates of a zero or of a factor converge.

use arrayvec::ArrayVec;

use super::super::polynomial::Polynomial;
use super::division::{Quadratic, Remainder, divide, divide_by_linear, negligible};
use super::factor::{Factor, Zero, quadratic_zeros};
use super::sequence::{estimate, step};

/// A test of convergence of successive estimates of a number.
struct Convergence {
    value: f64,
    change: f64,
    /// The bound of the product of two successive relative changes.
    threshold: f64,
}

impl Convergence {
    fn new() -> Self {
        Self {
            value: f64::INFINITY,
            change: 1.0,
            threshold: 0.25,
        }
    }

    /// Adds an estimate. Returns the product of its relative change and the one before if the changes
    /// decrease and the product is below the threshold.
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
pub(super) fn fixed_shift(p: &Polynomial, mut k: Polynomial, sigma: Quadratic, limit: u32) -> Option<Factor> {
    let (mut linear, mut quadratic) = (Convergence::new(), Convergence::new());
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
        k = if value_of_k.abs() <= scale {
            Polynomial::from_fn(p.degree() - 1, |i| of_k.coefficient(i))
        } else {
            let ratio = -value / value_of_k;
            Polynomial::from_fn(p.degree() - 1, |i| {
                ratio * of_k.coefficient(i) + quotient.coefficient(i)
            })
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
