//! The distance at one time, between two adjacent f64.

use core::cmp::Ordering;

use dashu_int::IBig;

use super::approach::Approach;
use crate::distance::DistanceBounds;
use crate::exact::dyadic::decompose;
use crate::exact::instant::Instant;
use crate::exact::narrowing::Narrowing;
use crate::exact::polynomial::Polynomial;
use crate::exact::split::Split;
use crate::kind::Kind;
use crate::query::Query;

/// The distance of the primitives at a time, by bisection over the bit patterns of f64, which are
/// ordered like the numbers.
pub(super) fn bounds<K: Kind>(query: &Query<K>, t: f64) -> DistanceBounds {
    let approach = Approach::at(query, t);
    // All polynomials are constant.
    let now = Narrowing::new(&Instant::At(Split::START));
    let closest = approach
        .features::<K>()
        .into_iter()
        .filter(|feature| feature.exists(&now))
        .min_by(|one, other| one.compare(other, &now));
    let [numerator, denominator] = closest.map_or([IBig::ZERO, IBig::ONE], |feature| {
        feature.squared_distance().map(Polynomial::at_start)
    });
    // (m 2ᵉ)² against numerator / denominator, in units of 4 to the power of `unit`.
    let compare = |bits: u64| {
        let (mantissa, exponent) = decompose(f64::from_bits(bits));
        if mantissa == 0 {
            return IBig::ZERO.cmp(&numerator);
        }
        let square = IBig::from(mantissa) * IBig::from(mantissa) * &denominator;
        let shift = 2 * (exponent - approach.unit);
        let by = shift.unsigned_abs() as usize;
        if shift < 0 {
            square.cmp(&(&numerator << by))
        } else {
            (square << by).cmp(&numerator)
        }
    };
    let (mut low, mut high) = (0.0f64.to_bits(), f64::INFINITY.to_bits());
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if compare(middle).is_le() {
            low = middle;
        } else {
            high = middle;
        }
    }
    let upper = if compare(low) == Ordering::Equal {
        low
    } else {
        high
    };
    DistanceBounds {
        lower: f64::from_bits(low),
        upper: f64::from_bits(upper),
    }
}
