//! Polynomials against integers.

use exact_ccd_curved::{Polynomial, Trajectory};

use crate::check;
use crate::fixed::Fixed;

/// A number of any of many magnitudes.
fn number(random: &mut fastrand::Rng) -> f64 {
    (random.f64() - 0.5) * 2.0_f64.powi(random.i32(-40..40))
}

fn points<const N: usize>(random: &mut fastrand::Rng) -> [[f64; 3]; N] {
    let near = random.bool();
    let base = [0; 3].map(|_| number(random));
    [0; N].map(|_| {
        let offset = [0; 3].map(|_| number(random));
        [0, 1, 2].map(|k: usize| {
            if near {
                base[k] + 1e-9 * base[k] * (random.f64() - 0.5)
            } else {
                offset[k]
            }
        })
    })
}

/// Σ C(n, i) (1 − t)ⁿ⁻ⁱ tⁱ pᵢ.
fn bernstein<const N: usize>(points: &[[f64; 3]; N], time: &Fixed) -> [Fixed; 3] {
    let one = Fixed::from(1.0);
    let mut binomial = 1.0;
    let mut sum = [0.0; 3].map(Fixed::from);
    for (i, point) in points.iter().enumerate() {
        let mut weight = Fixed::from(binomial);
        for k in 0..N - 1 {
            weight = weight.times(&if k < i { time.clone() } else { one.minus(time) });
        }
        sum = [0, 1, 2].map(|k: usize| sum[k].plus(&weight.times(&Fixed::from(point[k]))));
        binomial = binomial * (N - 1 - i) as f64 / (i + 1) as f64;
    }
    sum
}

fn by_control_points<const N: usize>(seed: u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    for _ in 0..3_000 {
        let points = points::<N>(&mut random);
        check(
            &Polynomial::new(points),
            &|time| bernstein(&points, &time),
            &mut random,
        );
    }
}

fn by_coefficients<const N: usize>(seed: u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    for _ in 0..3_000 {
        let points = points::<N>(&mut random);
        let horner = |time: Fixed| {
            [0, 1, 2].map(|k: usize| {
                let coefficients = points.iter().rev().map(|point| Fixed::from(point[k]));
                coefficients.fold(Fixed::from(0.0), |sum, c| sum.times(&time).plus(&c))
            })
        };
        check(&Polynomial::from_coefficients(points), &horner, &mut random);
    }
}

#[test]
fn errors_and_deviations_hold() {
    by_control_points::<1>(1);
    by_control_points::<2>(2);
    by_control_points::<3>(3);
    by_control_points::<4>(4);
    by_control_points::<7>(7);
}

#[test]
fn errors_and_deviations_hold_for_coefficients() {
    by_coefficients::<2>(12);
    by_coefficients::<3>(13);
    by_coefficients::<4>(14);
}

#[test]
fn the_deviation_of_a_parabola_is_tight() {
    // 4 t (1 − t): the chord over the step is at rest, and the vertex at 1.
    let arch = Polynomial::new([[0.0; 3], [0.0, 2.0, 0.0], [0.0; 3]]);
    let deviation = arch.deviation(0.0, 1.0);
    assert!((1.0..=1.0 + 1e-12).contains(&deviation));
    assert!((0.25..=0.25 + 1e-12).contains(&arch.deviation(0.5, 1.0)));
}
