//! The only pair of closest points in a bracket of time: its parameters, its direction, and whether the
//! distance grows.

use core::cmp::Ordering;

use super::closest::Closest;
use super::snapshot::{Moving, Snapshot};
use crate::filter::impact::TOLERANCE;
use crate::numbers::double_double::{DoubleDouble, ROUNDOFF};
use crate::numbers::number::Lanes;
use crate::numbers::roundoff::{UNDERFLOW, UNIT, certain_sign, margin};
use crate::numbers::vector::{cross, dot, minus, towards};
use crate::tables::{Point, Tables};
use crate::values::{ContactTime, Impact, unit};

/// The closest points at all times of a bracket.
///
/// Let x be F at the parameters of a guess, at some time of the bracket, and x* the point of F then that is
/// closest to the origin. F is affine in its parameters, and its values are the hull of its corners.
///
/// - *Inner points*, with the sides a and b from a corner: the foot of the perpendicular on the plane is x +
///   δᵤ a + δᵥ b, where δ solves the normal equations for a · x and b · x. It is x* if its parameters are
///   inner ones, and has the direction of a × b or of −a × b.
/// - *Between two corners*, with e from one to the other: the foot on the line is x + δ e for δ = −(e · x) /
///   (e · e). It is x* if it is between the corners and x* · (c − x*) > 0 for all other corners c.
/// - *A corner*: it is x* if x* · (c − x*) > 0 for all others.
///
/// There are no other closest points then. So D is differentiable, and D D′ = x* · v* with the velocity v* of
/// F at these parameters (Danskin, The theory of max-min, 1966).
pub(super) struct Approach {
    closest: Closest,
    /// The largest error of the guessed parameters.
    of_parameters: f64,
    /// A positive multiple of x*.
    direction: Near,
    /// Its scalar product with v*, and the error.
    rate: [f64; 2],
}

impl Approach {
    /// The closest points from the time of a snapshot on, for a time of this width; `None` if they are not
    /// certain.
    pub(super) fn new<K: Tables>(
        now: &Snapshot<DoubleDouble>,
        moving: &Moving<DoubleDouble>,
        width: f64,
    ) -> Option<Self> {
        let corner = |i: usize| Near {
            value: now.corner(i),
            error: error_of_corner(width),
        };
        let x = now.precise_point();
        let x = Near {
            value: x,
            error: error_of_point(width, extent(x)),
        };
        let (of_parameters, direction) = match now.closest {
            Closest::Corner(own) => {
                let all_behind = (0..now.count).all(|i| i == own || is_behind(&corner(i), &x));
                (0.0, all_behind.then_some(x)?)
            }
            Closest::Between(ends @ [i, j], s) => {
                let e = corner(j).minus(&corner(i));
                let step = along(&e, &x)?;
                is_inside([s, 1.0 - s], step.most())?;
                let foot = x.plus(&e, step);
                let all_behind = (0..now.count).all(|i| ends.contains(&i) || is_behind(&corner(i), &foot));
                (step.most(), all_behind.then_some(foot)?)
            }
            Closest::Inner([i, j], [u, v]) => {
                let [a, b] = [i, j].map(|i| corner(i).minus(&corner(0)));
                let [of_u, of_v] = in_plane(&a, &b, &x)?.map(Step::most);
                if K::FEATURES.are_of_triangle() {
                    is_inside([u, v, 1.0 - u - v], of_u + of_v)?;
                } else {
                    is_inside([u, 1.0 - u], of_u)?;
                    is_inside([v, 1.0 - v], of_v)?;
                }
                let normal = a.cross(&b);
                let [value, error] = product(&normal, &x);
                let is_along = certain_sign(value, error)?.is_gt();
                (of_u.max(of_v), if is_along { normal } else { normal.reversed() })
            }
        };
        let velocity = Near {
            value: moving.velocity(now.closest),
            error: error_of_velocity(of_parameters),
        };
        Some(Self {
            closest: now.closest,
            rate: product(&direction, &velocity),
            direction,
            of_parameters,
        })
    }

    /// `Greater` if D grows in the whole bracket, `Less` if it falls.
    pub(super) fn sense(&self) -> Option<Ordering> {
        certain_sign(self.rate[0], self.rate[1])
    }

    /// The closest points as the impact at a time of the bracket, if they are accurate enough.
    ///
    /// For vectors x and x + d, the unit vectors differ by at most 2 |d| / |x|, and |d| is at most √3 times
    /// the error of a component.
    pub(super) fn impact<K: Tables>(&self, time: ContactTime) -> Option<Impact> {
        let Near { value, error } = self.direction;
        let largest = value.into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let is_accurate = 4.0 * error <= TOLERANCE * largest && self.of_parameters <= TOLERANCE;
        let of_corner = |i: usize| K::FEATURES.vertices[i].1;
        let parameters = match self.closest {
            Closest::Corner(i) => of_corner(i),
            Closest::Between([i, j], s) => {
                let [start, end] = [of_corner(i), of_corner(j)];
                [0, 1].map(|k: usize| start[k] + s * (end[k] - start[k]))
            }
            Closest::Inner(_, parameters) => parameters,
        };
        is_accurate.then(|| Impact {
            time,
            parameters,
            normal: Some(unit(value.map(|x| x / largest))),
        })
    }
}

/// The error of a component of a corner at all times of a width w, in which it moves by at most 2 w: it is at
/// most 1, off by 8 ε, and rounded once.
pub(super) fn error_of_corner(width: f64) -> f64 {
    2.0 * width + margin(1) * UNIT
}

/// The same of F at fixed parameters, given the sum m of the magnitudes of its components: it is off by 53 ε.
pub(super) fn error_of_point(width: f64, m: f64) -> f64 {
    2.0 * width + margin(1) * UNIT * m + 64.0 * ROUNDOFF
}

/// The error of a component of the velocity of F. A component of a corner's velocity is at most 2, so that
/// two parameters that are off by δ change the result by at most 8 δ. Its terms are at most 10 together,
/// with n = 5 roundings; one of them is in the velocity of a corner.
pub(super) fn error_of_velocity(of_parameters: f64) -> f64 {
    8.0 * of_parameters + 64.0 * UNIT
}

/// Returns true if a corner certainly is behind the closest point: x* · (c − x*) > 0.
fn is_behind(corner: &Near, closest: &Near) -> bool {
    let [value, error] = product(closest, &corner.minus(closest));
    value > error
}

/// A vector. Each component is within an error.
#[derive(Clone, Copy)]
pub(super) struct Near {
    pub(super) value: Point,
    pub(super) error: f64,
}

impl Near {
    /// The difference: one more rounding.
    pub(super) fn minus(&self, other: &Self) -> Self {
        let value = minus(self.value, other.value);
        Self {
            value,
            error: self.error + other.error + UNIT * extent(value),
        }
    }

    /// The sum of this one and of a side times a step; three roundings of terms of at most the sum.
    pub(super) fn plus(&self, side: &Self, step: Step) -> Self {
        let [value, error] = [step.value, step.error];
        let moved = towards(self.value, side.value, value);
        let length = value.abs() * side.extent();
        Self {
            value: moved,
            error: self.error
                + error * side.extent()
                + value.abs() * side.error
                + margin(3) * UNIT * (extent(self.value) + length),
        }
    }

    /// The cross product. The error of a component is at most the error of a scalar product.
    pub(super) fn cross(&self, other: &Self) -> Self {
        Self {
            value: cross(self.value, other.value),
            error: product(self, other)[1],
        }
    }

    fn reversed(&self) -> Self {
        Self {
            value: self.value.map(|x| -x),
            error: self.error,
        }
    }

    /// A bound of the length.
    pub(super) fn extent(&self) -> f64 {
        extent(self.value) + 3.0 * self.error
    }
}

/// The sum of the magnitudes of the components, a bound of the length.
fn extent(vector: Point) -> f64 {
    vector.into_iter().fold(0.0, |sum, x| sum + x.abs())
}

/// A scalar product and its error: the error of each factor times the magnitude of the other, and n = 3
/// roundings. The bound takes the errors into the magnitudes, and is doubled for its own roundings.
pub(super) fn product(a: &Near, b: &Near) -> [f64; 2] {
    let (of_a, of_b) = (a.extent(), b.extent());
    let error = a.error * of_b + b.error * of_a + margin(3) * UNIT * of_a * of_b;
    [dot(a.value, b.value), 2.0 * error + UNDERFLOW]
}

/// The change of a parameter from x to the foot of the perpendicular, and its error.
#[derive(Clone, Copy)]
pub(super) struct Step {
    pub(super) value: f64,
    pub(super) error: f64,
}

impl Step {
    fn most(self) -> f64 {
        self.value.abs() + self.error
    }
}

/// The quotient of two numbers with errors, if the denominator certainly is positive. The least denominator
/// is less by twice its error, for the roundings of that.
pub(super) fn quotient([r, of_r]: [f64; 2], [s, of_s]: [f64; 2]) -> Option<Step> {
    let (value, least) = (r / s, s - 2.0 * of_s);
    let error = error_of_quotient(value, of_r, of_s, least);
    (least > 0.0).then_some(Step { value, error })
}

/// The error of q, the rounded quotient of r and s, given their errors and the least s.
///
/// The exact (r + ρ) / (s + σ) differs from r / s by (ρ − σ r / s) / (s + σ), and q by u of itself. The least
/// s has one rounding, as |q| has; sums, the product and the quotient lead to n = 6. The factors of 2 and 4
/// cover them, and less than 2⁵⁰ roundings of the errors.
pub(super) fn error_of_quotient<T: Lanes>(value: T, of_r: T, of_s: T, least: T) -> T {
    let size = value.abs();
    (of_r + size * of_s) * 2.0 / least + size * (4.0 * UNIT)
}

/// −(e · x) / (e · e), if e certainly is not zero.
fn along(e: &Near, x: &Near) -> Option<Step> {
    let [residual, of_residual] = product(e, x);
    quotient([-residual, of_residual], product(e, e))
}

/// a b − c d.
pub(super) fn minor<T: Lanes>([a, b]: [T; 2], [c, d]: [T; 2]) -> T {
    a * b - c * d
}

/// a b − c d of numbers with errors, and its error: the error of each factor times the largest possible
/// value of the other, and n = 2 roundings.
pub(super) fn minor_within(ab: [[f64; 2]; 2], cd: [[f64; 2]; 2]) -> [f64; 2] {
    let values = |factors: [[f64; 2]; 2]| factors.map(|[value, _]| value);
    let error = |[[a, of_a], [b, of_b]]: [[f64; 2]; 2]| {
        of_a * b.abs() + (a.abs() + of_a) * of_b + margin(2) * UNIT * (a * b).abs()
    };
    [minor(values(ab), values(cd)), error(ab) + error(cd)]
}

/// The steps along a and b to the foot of the perpendicular, if these certainly are not parallel: by Cramer's
/// rule, for [aa, ab; ab, bb] δ = −[ax, bx].
fn in_plane(a: &Near, b: &Near, x: &Near) -> Option<[Step; 2]> {
    let [aa, bb, ab] = [(a, a), (b, b), (a, b)].map(|(p, q)| product(p, q));
    let [ax, bx] = [a, b].map(|side| product(side, x));
    let determinant = minor_within([aa, bb], [ab, ab]);
    Some([
        quotient(minor_within([ab, bx], [bb, ax]), determinant)?,
        quotient(minor_within([ab, ax], [aa, bx]), determinant)?,
    ])
}

/// `Some` if all distances of the parameters from the ends of their range certainly are positive.
pub(super) fn is_inside<const N: usize>(distances: [f64; N], error: f64) -> Option<()> {
    let least = 2.0 * error + 8.0 * UNIT;
    distances.iter().all(|&distance| distance > least).then_some(())
}
