//! The cubic c(t) = w · (e₁ × e₂), which vanishes when the primitives lie in one plane.

use super::gap::Gap;
use crate::numbers::cubic::Cubic;
use crate::numbers::double_double::DoubleDouble;
use crate::numbers::number::{Lanes, Number, reach, subtract};
use crate::numbers::precise_cubic::PreciseCubic;
use crate::numbers::roundoff::{UNIT, margin};
use crate::numbers::vector::{add, cross, cross_magnitude, dot};
use crate::tables::{Points, Tables};

/// c, and the normals from which it is computed.
pub(crate) struct Coplanarity<T> {
    pub(super) cubic: Cubic<T>,
    /// e₁ × e₂ at t = 0 and at t = 1.
    pub(crate) normals: [[T; 3]; 2],
    /// Twice the blossom of e₁ × e₂ at (0, 1).
    pub(super) mixed: [T; 3],
    /// The sum over the axes of a bound for the magnitudes that are added up to e₁ × e₂: a bound of |e₁ × e₂|
    /// at all times, up to a few roundings.
    pub(super) extent: T,
}

/// c = b₀ (1−t)³ + 3 b₁ (1−t)² t + 3 b₂ (1−t) t² + b₃ t³.
pub(super) struct Expansion<T: Number> {
    /// b₀, 3 b₁, 3 b₂, b₃. The longest chain of roundings leads to 3 b₁ and 3 b₂: a difference, a
    /// product, the difference in `cross`, the sum in `mixed`, a product, two sums in `dot` and one
    /// more; and the two other differences in each term.
    pub(super) coefficients: [T; 4],
    pub(super) magnitude: T::Real,
    normals: [[T; 3]; 2],
    mixed: [T; 3],
    extent: T::Real,
}

impl<T: Lanes> Coplanarity<T> {
    #[inline(always)]
    pub(crate) fn new<K: Tables>(points: &Points<T>) -> Self {
        let expansion = Expansion::<T>::new::<K>(points);
        Self {
            cubic: Cubic::new(expansion.coefficients, expansion.magnitude),
            normals: expansion.normals,
            mixed: expansion.mixed,
            extent: expansion.extent,
        }
    }

    /// True where the planes of the primitives are certainly farther than the gap d apart at all times: |c|
    /// > d |n| for n = e₁ × e₂. For contact, c has no root.
    ///
    /// Let n₀, m and n₁ be the Bernstein coefficients of n. |n| is convex, hence at most the combination of
    /// |n₀|, |m| and |n₁|, of degree 2. Call this combination N; as a polynomial of degree 3, it has the
    /// coefficients |n₀|, (|n₀| + 2 |m|) / 3, (2 |m| + |n₁|) / 3 and |n₁|. So it suffices that each
    /// coefficient of c exceeds d times the coefficient of N. Where n vanishes, so does c, which excludes
    /// it.
    ///
    /// A component of n₀ and n₁ results from four roundings, a component of 2 m from five, of terms of at
    /// most the extent: each coefficient of N is off by at most the error of n = 5 times the extent. The
    /// lengths, their means and the bound add eleven roundings, and [`TINY`] in case the squares underflow.
    #[inline(always)]
    pub(crate) fn are_planes_beyond<G: Gap<T>>(&self, gap: G) -> T::Mask {
        if !G::IS_POSITIVE {
            return self.cubic.has_constant_sign();
        }
        self.cubic.is_beyond(self.least_distances(gap))
    }

    /// The bounds of the coefficients of d |n|.
    #[inline(always)]
    pub(super) fn least_distances(&self, gap: impl Gap<T>) -> [T; 4] {
        let [start, end] = self.normals;
        let (start, mixed, end) = (length_bound(start), length_bound(self.mixed), length_bound(end));
        let mut bounds = [start, (start + mixed) / 3.0, (mixed + end) / 3.0, end];
        let slack = self.extent * (margin(5) * UNIT);
        for bound in &mut bounds {
            *bound = gap.value(slack) * (*bound * (1.0 + margin(11) * UNIT) + slack);
        }
        bounds
    }
}

/// 2⁻⁵⁰⁰: more than the error of a length whose square underflows, 2⁻⁵³⁶.
const TINY: f64 = f64::from_bits((1023 - 500) << 52);

/// An upper bound of the length of a vector, up to five roundings.
#[inline(always)]
pub(super) fn length_bound<T: Lanes>(vector: [T; 3]) -> T {
    dot(vector, vector).sqrt() + TINY
}

/// c in twice the precision.
pub(super) fn precise<K: Tables>(points: &Points<f64>) -> PreciseCubic {
    let expansion = Expansion::<DoubleDouble>::new::<K>(points);
    PreciseCubic::new(expansion.coefficients, expansion.magnitude)
}

impl<T: Number> Expansion<T> {
    #[inline(always)]
    pub(super) fn new<K: Tables>(points: &Points<T::Real>) -> Self {
        let w = subtract::<T>(points, K::SPAN[0]);
        let e1 = subtract::<T>(points, K::SPAN[1]);
        let e2 = subtract::<T>(points, K::SPAN[2]);
        let normals = [cross(e1[0], e2[0]), cross(e1[1], e2[1])];
        // Twice the blossom of e₁ × e₂ at (0, 1).
        let mixed = add(cross(e1[0], e2[1]), cross(e1[1], e2[0]));
        let coefficients = [
            dot(w[0], normals[0]),
            dot(w[1], normals[0]) + dot(w[0], mixed),
            dot(w[0], normals[1]) + dot(w[1], mixed),
            dot(w[1], normals[1]),
        ];
        let (w, e1, e2) = (reach(&w), reach(&e1), reach(&e2));
        let across = cross_magnitude(e1, e2);
        Self {
            coefficients,
            magnitude: dot(w, across),
            normals,
            mixed,
            extent: across[0] + across[1] + across[2],
        }
    }
}
