//! The distance at one time, between two adjacent f64.

use dashu_int::IBig;
use dashu_int::ops::{BitTest, SquareRoot};

use super::approach::Approach;
use crate::distance::DistanceBounds;
use crate::exact::dyadic::{ENOUGH_BITS, rounded_down};
use crate::exact::instant::Instant;
use crate::exact::narrowing::Narrowing;
use crate::exact::polynomial::Polynomial;
use crate::exact::split::Split;
use crate::kind::Kind;
use crate::query::Query;

/// The distance of the primitives at a time of the step, by the integral part of a square root.
pub(crate) fn distance_at<K: Kind>(query: &Query<K>, t: f64) -> DistanceBounds {
    let approach = Approach::at(query, t);
    // All polynomials are constant.
    let now = Narrowing::new(Instant::At(Split::START));
    let closest = approach
        .features::<K>()
        .into_iter()
        .filter(|feature| feature.exists(&now))
        .min_by(|one, other| one.compare(other, &now));
    let [numerator, denominator] = closest.map_or([IBig::ZERO, IBig::ONE], |feature| {
        feature.squared_distance().map(Polynomial::at_start)
    });
    let square = Quotient {
        numerator,
        denominator,
    };
    let (lower, is_exact) = square.root(approach.unit as isize);
    DistanceBounds {
        lower: f64::from_bits(lower),
        upper: f64::from_bits(lower + u64::from(!is_exact)),
    }
}

/// A quotient of integers, not negative.
struct Quotient {
    numerator: IBig,
    denominator: IBig,
}

impl Quotient {
    /// The bits of the largest f64 that is not above the square root times 2ᵏ; and true if it is that number.
    fn root(self, k: isize) -> (u64, bool) {
        let Self {
            numerator,
            denominator,
        } = self;
        if numerator.is_zero() {
            return (0, true);
        }
        // Scaled by 4ˢ, the quotient has at least twice enough bits, and its root enough.
        let bits = numerator.bit_len() as isize - denominator.bit_len() as isize;
        let s = ENOUGH_BITS - bits.div_euclid(2);
        let by = 2 * s.unsigned_abs();
        let [numerator, denominator] = if s < 0 {
            [numerator, denominator << by]
        } else {
            [numerator << by, denominator]
        };
        // The root of a number and that of its integral part have the same integral part.
        let root = IBig::from((&numerator / &denominator).sqrt());
        let is_exact = &root * &root * denominator == numerator;
        let (floor, is_equal) = rounded_down(&root, k - s);
        (floor, is_equal && is_exact)
    }
}
