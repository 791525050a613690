//! The sine, with a bound of its error.
//!
//! Let k be an integer next to 2 x / π and r = x − k π / 2, so that |r| ≤ π / 4 + 2⁻³⁰ < 0.786. The sine of x
//! is ± sin r or ± cos r, which are sums of their series. All bounds are to first order in u = 2⁻⁵³;
//! underflow, below 2⁻¹⁰⁰⁰ in total, is left to the caller.
//!
//! - *The remainder r* is x if k = 0. Else, for |x| ≤ 2²⁰, the products of k, of 20 bits, and the parts of
//!   π / 2, of 33 bits, are exact. Each of three differences is at most 0.786 in magnitude and has one
//!   rounding, and the rest of π / 2 is below 2⁻¹⁰³, so that r is off by 3 · 0.786 u + 2⁻⁸³ < 2.37 u, and
//!   sine and cosine by no more.
//! - *The sine* is r + r (z p), with z = r² ≤ 0.618 and p the series from −1/3!. The terms of p behind the
//!   first, of magnitude z / 120, are off by less than 0.026 u; with the rounded coefficient and its sum, p
//!   is off by (1/6 + 1/6 + 0.026) u = 0.36 u, z p by 0.618 · 0.36 u + 2 u · 0.618 / 6 < 0.43 u, r (z p) by
//!   (0.43 + 0.11) u |r|, and the sum by 1.54 u |r|. The first term left out, r¹⁹ / 19!, is below
//!   0.002 u |r|.
//! - *The cosine* is 1 + z h, with h the series from −1/2!. The terms of h behind the first are off by less
//!   than 0.13 u, h by (0.13 + 0.5) u, z h by 0.618 · 0.63 u + 2 u · 0.309 < 1.01 u, and the sum by 2.01 u.
//!   The first term left out, r²⁰ / 20!, is below 10⁻⁴ u.
//!
//! So the error is at most 1.55 u |x| if k = 0, and the function returns the bound 2 u |x|; otherwise it
//! is at most (2.37 + 2.02) u, and the function returns the bound 5 u.

/// u, the largest relative error of one operation.
pub(crate) const UNIT: f64 = f64::EPSILON / 2.0;

/// π / 2 in three parts of 33 bits.
const RIGHT_ANGLE: [f64; 3] = [
    f64::from_bits(0x3ff9_21fb_5440_0000),
    f64::from_bits(0x3dd0_b461_1a60_0000),
    f64::from_bits(0x3ba3_198a_2e00_0000),
];

/// The coefficients of r³, r⁵, … in the sine.
const SINE: [f64; 8] = [
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5_040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
    1.0 / 355_687_428_096_000.0,
];

/// The coefficients of r², r⁴, … in the cosine.
const COSINE: [f64; 9] = [
    -1.0 / 2.0,
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
    -1.0 / 6_402_373_705_728_000.0,
];

/// The sine of a finite number, and a bound of its error: 0 and 1 for numbers above 2²⁰ in magnitude.
pub(crate) fn sine(x: f64) -> (f64, f64) {
    if x.abs() > 1_048_576.0 {
        return (0.0, 1.0);
    }
    let turns = x * core::f64::consts::FRAC_2_PI;
    let quarters = (turns + 0.5_f64.copysign(turns)) as i32;
    let k = f64::from(quarters);
    let r = RIGHT_ANGLE.iter().fold(x, |r, part| r - k * part);
    let z = r * r;
    let series = |coefficients: &[f64]| coefficients.iter().rev().fold(0.0, |sum, c| c + z * sum);
    let magnitude = if quarters % 2 == 0 {
        r + r * (z * series(&SINE))
    } else {
        1.0 + z * series(&COSINE)
    };
    let value = if quarters & 2 == 0 { magnitude } else { -magnitude };
    let error = if quarters == 0 { 2.0 * x.abs() } else { 5.0 };
    (value, error * UNIT)
}
