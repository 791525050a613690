//! The constants of the error bounds.
//!
//! The bounds follow Higham (Accuracy and Stability of Numerical Algorithms, 2002, chapter 3) and
//! Meyer and Pion (FPG: a code generator for fast and certified geometric predicates, 2008). u =
//! 2⁻⁵³ is the unit roundoff. A result of n successive roundings differs from the exact one by at
//! most γₙ = n u / (1 − n u) times the same expression with all terms replaced by upper bounds of
//! their magnitudes and all subtractions by additions. Each bound rounds n up to a power of two, at
//! least by a quarter, which covers the roundings in the computation of the bound itself.
//!
//! Two effects lie outside of that model. *Overflow* cannot happen:
//! [`Hull::is_out_of_range`](super::hull::Hull) limits differences to [`LARGEST`], and no filter
//! multiplies more than four of them. *Underflow* adds at most 2⁻¹⁰⁷⁵ to a product, which later
//! factors of at most (2 · LARGEST)² may enlarge; [`UNDERFLOW`] bounds the sum of hundreds of
//! these. All comparisons are written so that a NaN proves nothing. The model assumes rounding
//! to nearest and gradual underflow; see [`environment`](crate::environment).

use core::cmp::Ordering;

/// The unit roundoff u.
pub(crate) const UNIT: f64 = f64::EPSILON / 2.0;

/// 2²⁰⁰: the largest difference of two coordinates that the filters work on.
pub(crate) const LARGEST: f64 = f64::from_bits((1023 + 200) << 52);

/// 2⁻⁶⁰⁰ > 1000 · 2⁻¹⁰⁷⁵ · (2 · LARGEST)².
pub(crate) const UNDERFLOW: f64 = f64::from_bits((1023 - 600) << 52);

/// The sign of a number that differs from `value` by at most `error`; `None` if it may be zero or
/// of either sign.
#[inline(always)]
pub(crate) fn certain_sign(value: f64, error: f64) -> Option<Ordering> {
    (value.abs() > error).then(|| value.total_cmp(&0.0))
}
