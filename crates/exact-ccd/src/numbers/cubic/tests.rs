//! Cubics with small integer coefficients: roots by exact arithmetic, and derivatives without rounding.

use alloc::vec::Vec;
use core::cmp::Ordering;

use dashu_int::IBig;

use super::Cubic;
use crate::exact::{Polynomial, roots};
use crate::numbers::roundoff::UNIT;

/// Cubics with the Bernstein coefficients b₀ … b₃, all integers of this magnitude at most.
fn all_cubics(most: i32) -> impl Iterator<Item = [f64; 4]> {
    let range = move || -most..=most;
    let pairs = move || range().flat_map(move |a| range().map(move |b| [f64::from(a), f64::from(b)]));
    pairs().flat_map(move |[a, b]| pairs().map(move |[c, d]| [a, b, c, d]))
}

fn cubic([b0, b1, b2, b3]: [f64; 4]) -> Cubic<f64> {
    let magnitude = [b0, b1, b2, b3].map(f64::abs).into_iter().fold(0.0, f64::max);
    Cubic::new([b0, 3.0 * b1, 3.0 * b2, b3], magnitude)
}

/// c(t) for t = time / 64 in [0, 1], without rounding.
fn value([b0, b1, b2, b3]: [f64; 4], time: f64) -> f64 {
    let t = time / 64.0;
    let s = 1.0 - t;
    b0 * s * s * s + 3.0 * b1 * s * s * t + 3.0 * b2 * s * t * t + b3 * t * t * t
}

/// The sign of c(t) for an f64 t, in integers.
fn exact_sign([b0, b1, b2, b3]: [f64; 4], t: f64) -> Ordering {
    const UNITS: f64 = (1_u128 << 100) as f64;
    // No end of a bracket is so near to 0 that it is no multiple of 2⁻¹⁰⁰.
    let elapsed = t * UNITS;
    assert_eq!(elapsed.fract(), 0.0, "{t}");
    let elapsed = IBig::from(elapsed as i128);
    let left = (IBig::ONE << 100) - &elapsed;
    let integer = |b: f64| IBig::from(b as i64);
    let three = IBig::from(3);
    let sum = integer(b0) * &left * &left * &left
        + &three * integer(b1) * &left * &left * &elapsed
        + &three * integer(b2) * &left * &elapsed * &elapsed
        + integer(b3) * &elapsed * &elapsed * &elapsed;
    sum.cmp(&IBig::ZERO)
}

#[test]
fn roots_are_all_roots_of_the_exact_cubic() {
    let mut found = [0; 4];
    for bernstein in all_cubics(6) {
        let Some(brackets) = cubic(bernstein).roots() else {
            continue;
        };
        let [b0, b1, b2, b3] = bernstein.map(|b| IBig::from(b as i64));
        let coefficients = [b0, b1 * IBig::from(3), b2 * IBig::from(3), b3];
        let exact = roots([Polynomial::new(coefficients.to_vec())].to_vec());
        assert_eq!(brackets.len(), exact.len(), "{bernstein:?}");
        let ends: Vec<f64> = brackets.iter().flat_map(|root| [root.low, root.high]).collect();
        assert!(ends.is_sorted(), "{bernstein:?}");
        // The brackets are disjoint and as many as the roots: each has one, if it has an odd number of them.
        for root in &brackets {
            let signs = [root.low, root.high].map(|t| exact_sign(bernstein, t));
            assert_eq!(signs, [root.before, root.before.reverse()], "{bernstein:?}");
        }
        found[brackets.len()] += 1;
    }
    assert!(found.iter().all(|&count| count > 10), "{found:?}");
}

#[test]
fn slopes_are_those_of_the_blossom() {
    // The exact derivative of the cubic, and its mean over both arguments of the blossom.
    for b @ [b0, b1, b2, b3] in all_cubics(2) {
        let [linear, square] = [b2 - 2.0 * b1 + b0, b3 - 3.0 * b2 + 3.0 * b1 - b0];
        for (low, high) in [(0.0, 1.0), (0.25, 0.5), (0.125, 0.875)] {
            let of_blossom = |s: f64, t: f64| (b1 - b0) + linear * (s + t) + square * s * t;
            let expected = [
                of_blossom(low, low),
                of_blossom(low, high),
                of_blossom(high, high),
            ];
            assert_eq!(cubic(b).slopes(low, high), expected, "{b:?}");
        }
    }
}

#[test]
fn pieces_between_cuts_are_monotone() {
    for b in all_cubics(3) {
        let mut ends: Vec<f64> = [0.0].into_iter().chain(cubic(b).cuts()).chain([1.0]).collect();
        ends.retain(|t| !t.is_nan());
        for pair in ends.windows(2) {
            // At the multiples of 1 / 64 in the piece, the cubic does not turn.
            let inner = (0..=64)
                .map(f64::from)
                .filter(|time| *time >= 64.0 * pair[0] && *time <= 64.0 * pair[1]);
            let values: Vec<f64> = inner.map(|time| value(b, time)).collect();
            let falls = values.iter().rev().is_sorted();
            assert!(values.is_sorted() || falls, "{b:?} {pair:?}");
        }
        let [b0, b1, b2, b3] = b;
        let bend = (b2 - 2.0 * b1 + b0) + (b3 - 3.0 * b2 + 3.0 * b1 - b0) * cubic(b).inflection();
        assert!(bend.is_nan() || bend.is_infinite() || bend.abs() < 1e-12, "{b:?}");
    }
}

#[test]
fn signs_until_a_time_are_those_of_the_values() {
    let mut known = 0;
    for bernstein in all_cubics(3) {
        for end in [0.25, 0.5, 1.0] {
            let signs = cubic(bernstein).signs_until(end);
            let sign = |time: f64| {
                let value = value(bernstein, time);
                (value > 0.0).cmp(&(value < 0.0))
            };
            let times = || (0..64).map(f64::from).filter(|time| *time < 64.0 * end);
            let there = exact_sign(bernstein, end);
            assert!(signs[3].is_none_or(|at_end| at_end == there), "{bernstein:?}");
            assert!(signs[0].is_none_or(|before| before == sign(0.0)), "{bernstein:?}");
            if signs[0].is_some() && signs == [signs[0]; 4] {
                assert!(
                    times().all(|time| Some(sign(time)) == signs[0]),
                    "{bernstein:?} {end}"
                );
                known += 1;
            }
        }
    }
    assert!(known > 1000, "{known}");
}

#[test]
fn a_coefficient_is_beyond_its_bound_by_more_than_its_error() {
    for place in 0..4 {
        for sign in [1.0, -1.0] {
            let is_beyond = |b: f64| {
                let mut bernstein = [sign * 8.0; 4];
                bernstein[place] = sign * b;
                let magnitude = 1.0;
                Cubic { bernstein, magnitude }.is_beyond([1.0; 4])
            };
            let units = |n: f64| 1.0 + n * UNIT;
            let answers = [-8.0, 0.5, units(-16.0), 1.0, units(16.0), units(18.0)].map(is_beyond);
            assert_eq!(answers, [false, false, false, false, false, true]);
        }
    }
}

#[test]
fn monotone_cubics_are_strictly_monotone() {
    let mut known = [0; 2];
    for b in all_cubics(3) {
        for [low, high] in [[0, 64], [16, 32]] {
            if cubic(b).is_monotone(f64::from(low) / 64.0, f64::from(high) / 64.0) {
                let values: Vec<f64> = (low..=high).map(|time| value(b, f64::from(time))).collect();
                let rises = values.windows(2).all(|pair| pair[0] < pair[1]);
                assert!(rises || values.windows(2).all(|pair| pair[0] > pair[1]), "{b:?}");
                known[usize::from(rises)] += 1;
            }
        }
    }
    assert!(known.iter().all(|&count| count > 100), "{known:?}");
}

/// One root between the middle and a bend after it.
#[test]
fn a_root_before_a_bend_counts_once() {
    let found = cubic([54.0, -36.0, 24.0, -17.0]).roots();
    assert!(found.is_none_or(|roots| roots.len() == 1));
}
