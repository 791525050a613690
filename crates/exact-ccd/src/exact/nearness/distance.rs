//! The distance at one time, between two adjacent f64.

use dashu_int::IBig;
use dashu_int::ops::{BitTest, SquareRoot};

use super::scaled::Scaled;
use crate::exact::dyadic::{ENOUGH_BITS, rounded_down};
use crate::exact::instant::Instant;
use crate::exact::narrowing::Narrowing;
use crate::exact::polynomial::Polynomial;
use crate::exact::split::Split;
use crate::tables::{Points, Tables};
use crate::values::DistanceBounds;

/// The distance of the primitives at a time of the step, by the integral part of a square root.
pub(crate) fn distance_at<K: Tables>(points: &Points<f64>, t: f64) -> DistanceBounds {
    let scaled = Scaled::at(points, t);
    // All polynomials are constant.
    let now = Narrowing::new(Instant::At(Split::START));
    let closest = scaled
        .features::<K>()
        .into_iter()
        .filter(|feature| feature.exists(&now))
        .min_by(|one, other| one.compare(other, &now));
    let square = closest.map_or([IBig::ZERO, IBig::ONE], |feature| {
        feature.squared_distance().map(Polynomial::at_start)
    });
    let (lower, is_exact) = root(square, scaled.unit as isize);
    DistanceBounds {
        lower: f64::from_bits(lower),
        upper: f64::from_bits(lower + u64::from(!is_exact)),
    }
}

/// The bits of the largest f64 that is not above the square root of a quotient, not negative, times 2ᵏ; and
/// true if it is that number.
fn root([numerator, denominator]: [IBig; 2], k: isize) -> (u64, bool) {
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
    // A number and its integral part have square roots with the same integral part.
    let root = IBig::from((&numerator / &denominator).sqrt());
    let is_exact = &root * &root * denominator == numerator;
    let (floor, is_equal) = rounded_down(&root, k - s);
    (floor, is_equal && is_exact)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::to_integers;

    /// f ≤ √(n / d) < g for adjacent f64 f < g, and f² d = n exactly if the root is f.
    #[test]
    fn roots_are_rounded_down() {
        let mut random = fastrand::Rng::with_seed(1);
        let mut exact = 0;
        for _ in 0..2000 {
            let mut integer = || {
                let digits = random.usize(1..300);
                let digits = (0..digits / 32).fold(IBig::ONE, |sum, _| (sum << 32) + random.u32(..));
                digits << (random.usize(..3) * 20)
            };
            let (numerator, denominator) = (integer(), integer());
            let numerator = if random.bool() {
                &numerator * &numerator * &denominator
            } else {
                numerator
            };
            let (bits, is_exact) = root([numerator.clone(), denominator.clone()], 0);
            let [low, high] = [bits, bits + 1].map(|bits| {
                let ([_, x], unit) = to_integers([0.0, f64::from_bits(bits)]);
                (&x * &x * &denominator, 2 * unit.unwrap_or(0))
            });
            let compare = |(m, k): &(IBig, i32)| {
                let shift = k.unsigned_abs() as usize;
                if *k < 0 {
                    m.cmp(&(&numerator << shift))
                } else {
                    (m << shift).cmp(&numerator)
                }
            };
            assert!(
                compare(&low).is_le() && compare(&high).is_gt(),
                "{numerator} {denominator}"
            );
            assert_eq!(compare(&low).is_eq(), is_exact, "{numerator} {denominator}");
            exact += usize::from(is_exact);
        }
        assert!(exact > 100, "{exact}");
    }
}
