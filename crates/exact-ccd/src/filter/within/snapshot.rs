//! The corners of F at one time, and what they prove about the distance then, and between two
//! times.

use core::ops::{Mul, Neg};

use super::closest::Closest;
use super::scaled::Scaled;
use super::turning::{Heading, limit};
use crate::numbers::double_double::{DoubleDouble, ROUNDOFF};
use crate::numbers::number::{Number, subtract};
use crate::numbers::roundoff::{UNDERFLOW, margin};
use crate::numbers::vector::{cross, dot, minus};
use crate::tables::{Points, Tables};

/// f64, for guesses, or twice its precision, for proofs.
pub(super) trait Precision: Number<Real = f64> + Neg<Output = Self> + Mul<f64, Output = Self> {
    /// The step below which Newton's method has settled.
    const SETTLED: f64;
    /// True if points are more precise than parameters in f64.
    const REFINES: bool;
}

impl Precision for f64 {
    // 2⁻³²: one or two steps before twice the precision has settled. The error of a time is about the error
    // of the corners over the speed of the approach, and may be far above the unit roundoff.
    const SETTLED: f64 = f64::from_bits((1023 - 32) << 52);
    const REFINES: bool = false;
}

impl Precision for DoubleDouble {
    const SETTLED: f64 = 0.0;
    const REFINES: bool = true;
}

type Vector<T> = [T; 3];

/// The moving corners of F, scaled.
pub(super) struct Moving<T> {
    start: [Vector<T>; 4],
    velocity: [Vector<T>; 4],
    count: usize,
    pub(super) d: f64,
    /// d with the errors of f64.
    limit: f64,
}

impl<T: Precision> Moving<T> {
    pub(super) fn new<K: Tables>(points: &Points<f64>, scaled: &Scaled) -> Self {
        let factor = scaled.factor;
        let points = points.map(|now| now.map(|point| point.map(|x| x * factor)));
        let both = K::CORNERS.map(|difference| subtract::<T>(&points, difference));
        Self {
            start: both.map(|[start, _]| start),
            velocity: both.map(|[start, end]| [0, 1, 2].map(|axis: usize| end[axis] - start[axis])),
            count: K::FEATURES.vertices.len(),
            d: scaled.d,
            limit: limit(scaled.d, scaled.reach),
        }
    }

    pub(super) fn at<K: Tables>(&self, t: f64) -> Snapshot<T> {
        let corners = self.corners(t);
        let rounded = corners.map(|corner| corner.map(Number::value));
        let guess = Closest::guess::<K>(&rounded);
        let closest = if T::REFINES {
            guess.refined::<K, T>(&corners, &rounded)
        } else {
            guess
        };
        Snapshot {
            corners,
            closest,
            count: self.count,
            d: self.d,
            limit: self.limit,
        }
    }

    pub(super) fn corners(&self, t: f64) -> [Vector<T>; 4] {
        [0, 1, 2, 3]
            .map(|i: usize| [0, 1, 2].map(|axis: usize| self.start[i][axis] + self.velocity[i][axis] * t))
    }

    /// F at one time, at the closest points of another one.
    pub(super) fn place(&self, t: f64, closest: Closest) -> Vector<T> {
        closest.point(&self.corners(t))
    }

    /// The derivative of F at fixed parameters, to within rounding.
    pub(super) fn velocity(&self, closest: Closest) -> [f64; 3] {
        closest.point(&self.velocity.map(|corner| corner.map(Number::value)))
    }
}

/// The corners of F at one time, with a guess of the closest points.
///
/// Let ε be [`ROUNDOFF`], the largest error of one operation in twice the precision, relative to its
/// operands. A component of a corner, of magnitude at most 1, is off by at most 8 ε
/// (`proof/precise_corner.g`).
pub(super) struct Snapshot<T> {
    corners: [Vector<T>; 4],
    pub(super) closest: Closest,
    /// The number of different corners.
    pub(super) count: usize,
    d: f64,
    limit: f64,
}

impl<T: Precision> Snapshot<T> {
    /// F at the guess, to within rounding.
    pub(super) fn point(&self) -> [f64; 3] {
        self.closest
            .point(&self.corners.map(|corner| corner.map(Number::value)))
    }

    /// |F|² − d² at the guess.
    pub(super) fn excess(&self) -> T {
        excess(self.closest.point(&self.corners), self.d)
    }
}

/// |x|² − d².
pub(super) fn excess<T: Precision>(x: Vector<T>, d: f64) -> T {
    let d = T::difference(d, 0.0);
    dot(x, x) - d * d
}

impl Moving<DoubleDouble> {
    /// Returns true if |F| is certainly less than d at one time, at the closest points of another one.
    pub(super) fn is_within(&self, t: f64, closest: Closest) -> bool {
        is_below(self.place(t, closest), self.d)
    }
}

/// Returns true if |x| is certainly less than d, for x = F at some parameters.
fn is_below(x: Vector<DoubleDouble>, d: f64) -> bool {
    let m = x.iter().fold(0.0, |sum, component| sum + component.value().abs());
    excess(x, d).value() < -error_of_excess(m, d)
}

/// The error of |F|² − d², given the sum m of the magnitudes of the components.
///
/// A component is off by 53 ε (`proof/precise_point.g`), so that |F|² is off by 106 ε m + 3 (53 ε)². Four
/// operations lead from the components to the result, two from d.
pub(super) fn error_of_excess(m: f64, d: f64) -> f64 {
    let own = margin(4) * m * m + margin(2) * d * d;
    ROUNDOFF * (128.0 * m + own) + 16384.0 * ROUNDOFF * ROUNDOFF
}

impl Snapshot<DoubleDouble> {
    /// Returns true if the distance is certainly less than d, as |F| is at the guess.
    pub(super) fn is_within(&self) -> bool {
        is_below(self.closest.point(&self.corners), self.d)
    }

    /// A corner, each component off by 8 ε and one rounding.
    pub(super) fn corner(&self, i: usize) -> [f64; 3] {
        self.corners[i].map(Number::value)
    }

    /// F at the guess, each component off by 53 ε, as in [`error_of_excess`], and one rounding.
    pub(super) fn precise_point(&self) -> [f64; 3] {
        self.closest.point(&self.corners).map(Number::value)
    }
}

/// The corners at a time at which D certainly is above d, perhaps next to it, and a direction that proves it:
/// any vector of a length of about 1. In f64 too.
pub(super) struct Headed<'a> {
    snapshot: &'a Snapshot<DoubleDouble>,
    direction: Vector<DoubleDouble>,
    rounded: Heading<f64>,
}

impl<'a> Headed<'a> {
    /// `None` if the distance may be d.
    pub(super) fn new(snapshot: &'a Snapshot<DoubleDouble>) -> Option<Self> {
        let direction = direction(&snapshot.corners, snapshot.closest);
        let headed = Self {
            snapshot,
            rounded: Heading::rounded(&snapshot.corners, direction),
            direction,
        };
        headed.is_beyond_across(&headed).then_some(headed)
    }

    /// Returns true if the distance is certainly above d at all times between this one and another one, given
    /// in f64, at which it may be d.
    ///
    /// [`Heading::is_beyond_across`] proves it.
    pub(super) fn is_beyond_from(&self, other: &Heading<f64>) -> bool {
        let Snapshot { count, limit, .. } = *self.snapshot;
        other.is_beyond(count, limit) && self.rounded.is_beyond_across(other, count, limit)
    }

    /// The same for another time at which D certainly is above d: gₐ · x_b + g_b · xₐ certainly is above d
    /// (|gₐ| + |g_b|) for all corners. Where D is not next to d, f64 prove it.
    pub(super) fn is_beyond_across(&self, other: &Self) -> bool {
        let Snapshot { count, limit, .. } = *self.snapshot;
        self.rounded.is_beyond_across(&other.rounded, count, limit) || are_beyond(self, other)
    }
}

/// The errors of [`are_beyond`]: of [`least_of`], for corners that are off by 8 ε; of [`threshold`], and
/// of the square of the first, with the difference of the two.
pub(super) const OF_SUM: f64 = margin(8 + 5) * ROUNDOFF;
pub(super) const OF_THRESHOLD: f64 = margin(7 + 1) * ROUNDOFF;
pub(super) const OF_SQUARE: f64 = margin(1 + 1) * ROUNDOFF;

/// Returns true if gₐ · x_b + g_b · xₐ is certainly above d (|gₐ| + |g_b|) for all corners.
///
/// It is if the sum s on the left is positive and s² > 2 d² (gₐ · gₐ + g_b · g_b), as (p + q)² ≤ 2
/// (p² + q²). With e the sum of the magnitudes of the components of both directions, s is at most e and off
/// by (8 + 5) ε e. The computed s less twice this error is below the exact s. Its square has one operation,
/// the right side seven, and the difference of the two adds one to each.
fn are_beyond(one: &Headed<'_>, other: &Headed<'_>) -> bool {
    let [(a, of_a), (b, of_b)] = [one, other].map(|headed| (headed.snapshot, headed.direction));
    let extent = of_a.iter().chain(&of_b).fold(0.0, |sum, x| sum + x.value().abs());
    let slack = DoubleDouble::difference(OF_SUM * extent + UNDERFLOW, 0.0);
    let threshold = threshold(a.d, of_a, of_b);
    let limit = OF_THRESHOLD * threshold.value() + UNDERFLOW;
    let is_same = core::ptr::eq(one, other);
    a.corners
        .iter()
        .zip(&b.corners)
        .take(a.count)
        .all(|(&at_a, &at_b)| {
            let along = dot(of_a, at_b);
            let least = least_of(along, if is_same { along } else { dot(of_b, at_a) }, slack);
            let square = least * least;
            let above = limit + OF_SQUARE * square.value();
            least.value() > 0.0 && (square - threshold).value() > above
        })
}

/// The sum of two scalar products, less the error of all.
pub(super) fn least_of<T: Precision>(one: T, other: T, slack: T) -> T {
    one + other - slack
}

/// 2 d² (g · g + h · h).
pub(super) fn threshold<T: Precision>(d: f64, g: Vector<T>, h: Vector<T>) -> T {
    let d = T::difference(d, 0.0);
    d * d * (dot(g, g) + dot(h, h)) * 2.0
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
