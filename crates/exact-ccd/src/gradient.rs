//! Derivatives of the time of impact and of the distance with respect to the points of a query.

use core::array;

use crate::kind::Kind;
use crate::numbers::vector::{cross, dot, minus};
use crate::query::Query;
use crate::tables::Point;
use crate::values::{Impact, Options, Separation, TimeOutOfStep};

/// The derivatives of a value with respect to the coordinates of all points of a query.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient<K: Kind> {
    /// With respect to the points at t = 0 and at t = 1.
    pub points: [K::Points; 2],
}

/// The reason why a derivative is not defined, or not certain to be.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NotDifferentiable {
    /// The primitives do not touch in the step.
    #[error("the primitives do not touch in the step: there is no time of impact")]
    Free,
    /// The primitives touch at t = 0, where the time of impact is not a smooth function of the points.
    #[error("the primitives touch at the start of the step, where the time of impact is no smooth function")]
    Start,
    /// The first contact is at t = 1, or between 1 and the largest f64 below it: a small change of the points
    /// removes it.
    #[error(
        "the primitives first touch at the end of the step: a small change of the points removes the contact"
    )]
    End,
    /// The primitives do not approach each other along the normal: a tangency.
    #[error(
        "the primitives are tangent: their distance does not fall through the value at the time of impact"
    )]
    Tangent,
    /// The closest points pass from one feature to another, or are not unique, as on parallel edges.
    #[error("the closest points are not unique, or on the boundary of a primitive in contact")]
    Features,
    /// The distance is 0 at this time, or so small that rounding determines the direction.
    #[error("the distance at this time is 0, where it is no smooth function, or too small for f64")]
    Touching,
    /// A derivative overflows.
    #[error("a derivative is not a finite number")]
    Overflow,
    /// The time is not in [0, 1].
    #[error(transparent)]
    Time(#[from] TimeOutOfStep),
}

/// A parameter this near to 0 or 1 may be on the boundary: it is within 2⁻³² of the exact one, and u + v is
/// within 2⁻³¹.
const NEAR_BOUNDARY: f64 = 1.0 / (1u64 << 30) as f64;

/// A velocity along the normal below this fraction of the velocities relative to one point may vanish.
///
/// The weights are off by at most 2⁻³¹ and the normal by 2⁻³², so that the velocity is off by less than
/// 2⁻²⁹ of the sum of these velocities.
const NEAR_TANGENT: f64 = 1.0 / (1u64 << 28) as f64;

/// Distances of at most this fraction of the extent of a query are too small for a direction: see
/// [`Query::distance_gradient`].
const NEAR_CONTACT: f64 = 1.0 / (1u64 << 25) as f64;

/// Edges are nearly parallel, or a face nearly flat, if the square of the sine of their angle is below this.
const NEAR_PARALLEL: f64 = 1.0 / (1u64 << 40) as f64;

impl<K: Kind> Query<K> {
    /// The derivatives of the time of impact with respect to the points at both ends of the step.
    ///
    /// Let F be the vector from the closest point of the second primitive to the closest point of the first,
    /// the sum of the points with weights wᵢ, and n the normal. At the first time t at which the gap n · F
    /// has the given value, the derivatives of the gap with respect to the points at t = 0 and at t = 1 are
    /// wᵢ (1 − t) n and wᵢ t n (the parameters need not be varied: the gap does not change with them, to
    /// first order). By implicit differentiation, the derivatives of t are these times −1 / (n · Σ wᵢ vᵢ),
    /// vᵢ being the velocities.
    ///
    /// The factors are computed in f64, with the [errors](Impact) of parameters and normal.
    ///
    /// ```
    /// use exact_ccd::{CONTACT, Query, VertexFace};
    ///
    /// let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let at = |z: f64| [[0.25, 0.25, z], face[0], face[1], face[2]];
    /// let query = Query::<VertexFace>::new(at(1.0), at(-1.0))?;
    /// // The time is z₀ / (z₀ − z₁): 1/4 for each unit of z at either end.
    /// let gradient = query.time_gradient(CONTACT)?;
    /// assert_eq!(gradient.points.map(|points| points[0]), [[0.0, 0.0, 0.25]; 2]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`NotDifferentiable`], also where the errors leave it open.
    pub fn time_gradient(&self, options: impl Into<Options>) -> Result<Gradient<K>, NotDifferentiable> {
        let options = options.into();
        let impact = self.impact(options).ok_or(NotDifferentiable::Free)?;
        if impact.time.is_start() {
            return Err(NotDifferentiable::Start);
        }
        if impact.time.upper() >= 1.0 {
            return Err(NotDifferentiable::End);
        }
        let [x0, x1] = self.points().each_ref().map(AsRef::as_ref);
        let relative = |place: usize, axis: usize| [x0, x1].map(|x| x[place][axis] - x[0][axis]);
        let mut largest = 0.0;
        for place in 0..x0.len() {
            for axis in 0..3 {
                let [start, end] = relative(place, axis);
                // The difference is off by 2⁻⁵³ of its terms, below 2⁻²⁸ · 2⁻²⁴ of them.
                largest += (end - start).abs() + (start.abs() + end.abs()) / (1 << 24) as f64;
            }
        }
        if !f64::is_finite(largest) {
            return Err(NotDifferentiable::Overflow);
        }
        let normal = self.unique_normal(&impact, options.separation)?;
        let weights = impact.weights::<K>();
        let mut velocity: f64 = 0.0;
        for (place, weight) in weights.into_iter().enumerate().take(x0.len()) {
            for (axis, along) in normal.into_iter().enumerate() {
                // The weights add up to 0: a common velocity changes nothing.
                let [start, end] = relative(place, axis);
                velocity += weight * along * (end - start);
            }
        }
        if velocity.abs() <= NEAR_TANGENT * largest {
            return Err(NotDifferentiable::Tangent);
        }
        let t = impact.time.lower();
        gradient([1.0 - t, t].map(|at| -at / velocity), &weights, normal)
    }

    /// The derivatives of the distance of the primitives at time `t` with respect to the points at both ends
    /// of the step: wᵢ (1 − t) n and wᵢ t n, as in [`time_gradient`](Self::time_gradient).
    ///
    /// The points at t, relative to the first one, are rounded, in whatever direction: off by less than 8 u
    /// m each, for the extent m of the points at both ends. The set of differences of the primitives then
    /// is off by ε < 32 u m. Its point p next to 0, at the distance D, is off by at most √(4 ε D + ε²): an
    /// exact nearest point q and a rounded one r satisfy r · q ≥ D² − ε D and |r| ≤ D + ε. A distance of at
    /// most 2⁻²⁵ m is an error, so that ε < 2⁻²³ D, and the direction is within 2⁻¹⁰ at worst; it is within
    /// about 2⁻²² where the features do not change.
    ///
    /// # Errors
    /// [`NotDifferentiable`], also where the distance is too small for the rounding of the points.
    pub fn distance_gradient(&self, t: f64) -> Result<Gradient<K>, NotDifferentiable> {
        TimeOutOfStep::check(t)?;
        let [mut now, end] = *self.points();
        let origins = [now.as_ref()[0], end.as_ref()[0]];
        let mut extent: f64 = 0.0;
        for (now, end) in now.as_mut().iter_mut().zip(end.as_ref()) {
            *now = array::from_fn(|axis| {
                let [a, b] = [now[axis] - origins[0][axis], end[axis] - origins[1][axis]];
                extent = extent.max(a.abs()).max(b.abs());
                (1.0 - t) * a + t * b
            });
        }
        if !extent.is_finite() {
            return Err(NotDifferentiable::Overflow);
        }
        let resting = Self::from_finite([now, now]);
        let distance = resting.distance_at(0.0)?.upper;
        if distance <= NEAR_CONTACT * extent {
            return Err(NotDifferentiable::Touching);
        }
        let within = Separation::new(distance).map_err(|_| NotDifferentiable::Overflow)?;
        let impact = resting.impact(within).ok_or(NotDifferentiable::Features)?;
        let normal = resting.unique_normal(&impact, within)?;
        gradient([1.0 - t, t], &impact.weights::<K>(), normal)
    }

    /// The normal of an impact, if the closest points are unique, and within both primitives at contact.
    fn unique_normal(&self, impact: &Impact, separation: Separation) -> Result<Point, NotDifferentiable> {
        let [u, v] = impact.parameters;
        let normal = impact.normal.ok_or(NotDifferentiable::Features)?;
        if separation.is_zero() {
            // A vertex meets an edge, or two vertices meet, by coincidence only.
            let Some(_) = K::FEATURES.inner else {
                return Err(NotDifferentiable::Features);
            };
            let last = if K::FEATURES.are_of_triangle() {
                1.0 - u - v
            } else {
                (1.0 - u).min(1.0 - v)
            };
            if u.min(v).min(last) < NEAR_BOUNDARY {
                return Err(NotDifferentiable::Features);
            }
        }
        let t = impact.time.lower();
        let four = self.four();
        // Differences first: the error is relative to the edge, not to its place.
        let [e1, e2] = [K::SPAN[1], K::SPAN[2]].map(|(i, j)| {
            let [start, end] = four.each_ref().map(|x| minus(x[i], x[j]));
            let edge: Point = array::from_fn(|axis| (1.0 - t) * start[axis] + t * end[axis]);
            let longest = edge
                .iter()
                .fold(f64::MIN_POSITIVE, |longest, x| x.abs().max(longest));
            edge.map(|x| x / longest)
        });
        let [length1, length2] = [e1, e2].map(|e| dot(e, e));
        let is_unique = match K::FEATURES.inner {
            Some(_) => {
                let normal = cross(e1, e2);
                dot(normal, normal) > NEAR_PARALLEL * length1 * length2
            }
            // An edge, or two vertices.
            None => length2 > 0.0 || K::FEATURES.sides.is_empty(),
        };
        if is_unique {
            Ok(normal)
        } else {
            Err(NotDifferentiable::Features)
        }
    }
}

/// The derivatives: the normal times the weight of each point, and times a factor of each end.
fn gradient<K: Kind>(
    factors: [f64; 2],
    weights: &[f64; 4],
    normal: Point,
) -> Result<Gradient<K>, NotDifferentiable> {
    let points = factors.map(|factor| {
        let mut points = K::Points::default();
        for (point, weight) in points.as_mut().iter_mut().zip(weights) {
            *point = normal.map(|n| factor * weight * n);
        }
        points
    });
    let mut values = points.iter().flat_map(|points| points.as_ref().as_flattened());
    if values.all(|value| value.is_finite()) {
        Ok(Gradient { points })
    } else {
        Err(NotDifferentiable::Overflow)
    }
}
