//! The corners of F at one time, and what they prove about the distance then, and between two
//! times.

use core::ops::{Mul, Neg};

use super::closest::Closest;
use super::scaled::Scaled;
use crate::filter::double_double::{DoubleDouble, ROUNDOFF};
use crate::filter::number::{Number, subtract};
use crate::filter::roundoff::UNDERFLOW;
use crate::filter::vector::{cross, dot, minus};
use crate::kind::Kind;
use crate::query::Query;

/// f64, for guesses, or twice its precision, for proofs.
pub(super) trait Precision: Number<Real = f64> + Neg<Output = Self> + Mul<f64, Output = Self> {
    /// The step below which Newton's method has settled.
    const SETTLED: f64;
}

impl Precision for f64 {
    // 2⁻³²: one or two steps before twice the precision has settled. The error of a time is about that of
    // the corners over the speed of the approach, and may be far above the unit roundoff.
    const SETTLED: f64 = f64::from_bits((1023 - 32) << 52);
}

impl Precision for DoubleDouble {
    const SETTLED: f64 = 0.0;
}

type Vector<T> = [T; 3];

/// The moving corners of F, scaled.
pub(super) struct Moving<T> {
    start: [Vector<T>; 4],
    velocity: [Vector<T>; 4],
    count: usize,
    d: f64,
}

impl<T: Precision> Moving<T> {
    pub(super) fn new<K: Kind>(query: &Query<K>, scaled: &Scaled) -> Self {
        let factor = scaled.factor;
        let points = query.four().map(|now| now.map(|point| point.map(|x| x * factor)));
        let both = K::CORNERS.map(|difference| subtract::<T>(&points, difference));
        Self {
            start: both.map(|[start, _]| start),
            velocity: both.map(|[start, end]| [0, 1, 2].map(|axis: usize| end[axis] - start[axis])),
            count: K::FEATURES.vertices.len(),
            d: scaled.d,
        }
    }

    pub(super) fn at<K: Kind>(&self, t: f64) -> Snapshot<T> {
        let corners = [0, 1, 2, 3]
            .map(|i: usize| [0, 1, 2].map(|axis: usize| self.start[i][axis] + self.velocity[i][axis] * t));
        let rounded = corners.map(|corner| corner.map(Number::value));
        let closest = Closest::guess::<K>(&rounded);
        let closest = closest.refined::<K>(&rounded, point(&corners, closest).map(Number::value));
        let direction = direction(&corners, closest);
        Snapshot {
            corners,
            closest,
            direction,
            count: self.count,
            d: self.d,
        }
    }

    pub(super) fn separation(&self) -> f64 {
        self.d
    }

    /// The derivative of F at fixed parameters, to within rounding.
    pub(super) fn velocity(&self, closest: Closest) -> [f64; 3] {
        closest.point(&self.velocity.map(|corner| corner.map(Number::value)))
    }
}

/// The corners of F at one time, with a guess of the closest points and the direction from one to
/// the other.
///
/// Let ε be [`ROUNDOFF`], the largest error of one operation in twice the precision, relative to its
/// operands. A component of a corner, of magnitude at most 1, results from four operations on terms of at
/// most 1, 1, 2 and 3. Its error is at most 8 ε.
pub(super) struct Snapshot<T> {
    corners: [Vector<T>; 4],
    pub(super) closest: Closest,
    /// The bounds hold for any vector. They are sharpest for this one, whose length is about 1.
    direction: Vector<T>,
    count: usize,
    d: f64,
}

impl<T: Precision> Snapshot<T> {
    /// F at the guess, to within rounding.
    pub(super) fn point(&self) -> [f64; 3] {
        self.closest
            .point(&self.corners.map(|corner| corner.map(Number::value)))
    }

    /// |F|² − d² at the guess.
    pub(super) fn excess(&self) -> T {
        let x = point(&self.corners, self.closest);
        let d = T::difference(self.d, 0.0);
        dot(x, x) - d * d
    }
}

impl Snapshot<DoubleDouble> {
    /// True if the distance is certainly less than d, as |F| is at the guess.
    ///
    /// A component of F, of magnitude at most 1, is off by 8 ε for each of at most five corners
    /// with factors of at most 1, and by 17 ε for the operations on them; |F|² by twice that for
    /// each axis and by 12 ε more; d² by ε d², the difference by ε (3 + d²).
    pub(super) fn is_within(&self) -> bool {
        let error = 512.0 * ROUNDOFF * (1.0 + self.d * self.d);
        self.excess().value() < -error
    }

    /// True if the distance is certainly above d at this time, at another one, and at all times
    /// between.
    ///
    /// The proof is that of [`Heading::are_beyond_until`](super::turning::Heading::are_beyond_until).
    pub(super) fn is_beyond_until(&self, later: &Self) -> bool {
        are_beyond(self, self) && are_beyond(self, later) && are_beyond(later, later)
    }
}

/// True if gₐ · x_b + g_b · xₐ is certainly above d (|gₐ| + |g_b|) for all corners.
///
/// It is if the sum s on the left is positive and s² > 2 d² (gₐ · gₐ + g_b · g_b), as (p + q)² ≤ 2
/// (p² + q²). With e the sum of the magnitudes of the components of both directions, s is at most e
/// and off by (8 + 6) ε e; taken less 32 ε e it is below the exact one. Its square is off by 4 ε
/// times itself, the right side by 12 ε times itself.
fn are_beyond(a: &Snapshot<DoubleDouble>, b: &Snapshot<DoubleDouble>) -> bool {
    let extent = a
        .direction
        .iter()
        .chain(&b.direction)
        .fold(0.0, |sum, x| sum + x.value().abs());
    let slack = DoubleDouble::difference(32.0 * ROUNDOFF * extent + UNDERFLOW, 0.0);
    let d = DoubleDouble::difference(a.d, 0.0);
    let lengths = dot(a.direction, a.direction) + dot(b.direction, b.direction);
    let threshold = d * d * lengths * 2.0;
    let limit = 32.0 * ROUNDOFF * threshold.value() + UNDERFLOW;
    a.corners
        .iter()
        .zip(&b.corners)
        .take(a.count)
        .all(|(&of_a, &of_b)| {
            let least = dot(a.direction, of_b) + dot(b.direction, of_a) - slack;
            let square = least * least;
            least.value() > 0.0 && (square - threshold).value() > limit + 16.0 * ROUNDOFF * square.value()
        })
}

/// F at some parameters.
fn point<T: Precision>(corners: &[Vector<T>; 4], closest: Closest) -> Vector<T> {
    match closest {
        Closest::Corner(i) => corners[i],
        Closest::Between([i, j], s) => {
            let e = minus(corners[j], corners[i]);
            [0, 1, 2].map(|axis: usize| corners[i][axis] + e[axis] * s)
        }
        Closest::Inner([i, j], [u, v]) => {
            let (a, b) = (minus(corners[i], corners[0]), minus(corners[j], corners[0]));
            [0, 1, 2].map(|axis: usize| corners[0][axis] + (a[axis] * u + b[axis] * v))
        }
    }
}

/// A vector of a length of about 1 across the features, on the side of F.
fn direction<T: Precision>(corners: &[Vector<T>; 4], closest: Closest) -> Vector<T> {
    let across = match closest {
        Closest::Corner(i) => corners[i],
        Closest::Between([i, j], _) => {
            let (x, e) = (corners[i], minus(corners[j], corners[i]));
            let (ee, ex) = (dot(e, e), dot(e, x));
            [0, 1, 2].map(|axis: usize| ee * x[axis] - ex * e[axis])
        }
        Closest::Inner([i, j], _) => {
            let n = cross(minus(corners[i], corners[0]), minus(corners[j], corners[0]));
            if dot(n, corners[0]).value() < 0.0 {
                n.map(|x| -x)
            } else {
                n
            }
        }
    };
    let scale = 1.0 / libm::sqrt(dot(across, across).value());
    across.map(|x| x * scale)
}
