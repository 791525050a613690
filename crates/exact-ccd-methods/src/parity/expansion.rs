//! Exact sums of f64, as lists of their components.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use geometry_predicates::predicates::{fast_expansion_sum_zeroelim, scale_expansion_zeroelim};

use exact_ccd::Point;

/// The sum of numbers of increasing magnitude that have no bits in common: exact, as long as
/// nothing overflows or underflows.
///
/// J. R. Shewchuk, *Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates*, Discrete & Computational Geometry 18, 1997. There is at least one component. Only the
/// expansion of zero has a component that is zero.
#[derive(Clone)]
pub(super) struct Expansion(Vec<f64>);

/// Between these magnitudes, polynomials of degree six in differences of f64 neither overflow nor
/// underflow: the last bit of a coordinate is worth 2⁻¹²⁰⁻⁵² at least, and the last bit of a product of six
/// coordinates 2⁻¹⁰³²; the largest such product has two determinants as factors, and is less than
/// 2 · (48 · 2¹⁶⁰ · 2¹⁶⁰ · 2¹⁶⁰)² < 2⁹⁷³.
const RANGE: [f64; 2] = [7.6e-37, 1.4e48];

impl Expansion {
    /// Returns true if predicates of points of such coordinates are exact.
    pub(super) fn can_hold(points: &[Point]) -> bool {
        let is_in_range = |&x: &f64| (x == 0.0) | ((x.abs() >= RANGE[0]) & (x.abs() < RANGE[1]));
        points
            .as_flattened()
            .iter()
            .fold(true, |all, x| all & is_in_range(x))
    }

    fn of_length(bound: usize, fill: impl FnOnce(&mut [f64]) -> usize) -> Self {
        let mut components = vec![0.0; bound];
        let length = fill(&mut components);
        components.truncate(length);
        Self(components)
    }

    /// The sign, unless an overflow made it undefined.
    pub(super) fn sign(&self) -> Option<Ordering> {
        self.0.last()?.partial_cmp(&0.0)
    }
}

impl From<f64> for Expansion {
    fn from(x: f64) -> Self {
        Self(vec![x])
    }
}

impl Add for Expansion {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::of_length(self.0.len() + other.0.len(), |sum| {
            fast_expansion_sum_zeroelim(&self.0, &other.0, sum)
        })
    }
}

impl Neg for Expansion {
    type Output = Self;

    fn neg(mut self) -> Self {
        self.0.iter_mut().for_each(|component| *component = -*component);
        self
    }
}

impl Sub for Expansion {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.add(-other)
    }
}

impl Mul for Expansion {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let scaled = |factor: &f64| {
            Self::of_length(2 * self.0.len(), |product| {
                scale_expansion_zeroelim(&self.0, *factor, product)
            })
        };
        other.0.iter().map(scaled).fold(Self::from(0.0), Self::add)
    }
}

#[cfg(test)]
mod tests {
    use dashu_ratio::RBig;
    use proptest::array::{uniform2, uniform3, uniform9};
    use proptest::prelude::*;

    use super::*;
    use crate::integers::to_integers;
    use crate::parity::image::{Differences, Predicate, integers, vectors};

    fn coordinate() -> impl Strategy<Value = f64> {
        let magnitude = prop_oneof![
            Just(RANGE[0]),
            Just(RANGE[1].next_down()),
            RANGE[0]..1.0,
            1.0..RANGE[1]
        ];
        (magnitude, -1..=1i8).prop_map(|(magnitude, sign)| magnitude * f64::from(sign))
    }

    fn exactly(x: f64) -> RBig {
        RBig::try_from(x).unwrap()
    }

    /// The number that an integer 1 stands for.
    fn unit(differences: &Differences) -> RBig {
        let numbers = differences.as_flattened().as_flattened().iter();
        let integers = to_integers(differences);
        let mut pairs = numbers.zip(integers.as_flattened().as_flattened());
        pairs
            .find(|(x, _)| **x != 0.0)
            .map_or(RBig::ONE, |(&x, n)| exactly(x) / RBig::from(n.clone()))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        /// To the last bit, and the last component has the sign.
        #[test]
        fn predicates_are_exact_within_the_range(differences in uniform9(uniform2(uniform3(coordinate())))) {
            prop_assert!(Expansion::can_hold(differences.as_flattened()));
            let (expansions, integers) = (vectors::<Expansion>(&differences), integers(&differences));
            let unit = unit(&differences);
            let predicates = [
                (Predicate::Phi([0, 1, 2, 3]), 6),
                (Predicate::Volume([4, 5, 6]), 3),
                (Predicate::Dot([7, 8]), 2),
            ];
            for (predicate, degree) in predicates {
                let (expansion, integer) = (predicate.value(&expansions), predicate.value(&integers));
                let sum = expansion.0.iter().fold(RBig::ZERO, |sum, &x| sum + exactly(x));
                prop_assert_eq!(expansion.sign(), Some(predicate.sign(&integers)));
                prop_assert_eq!(sum, RBig::from(integer) * unit.pow(degree));
            }
        }
    }
}
