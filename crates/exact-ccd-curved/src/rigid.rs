//! Rigid motion: rotation about an axis that moves in a straight line.

use exact_ccd::{Point, environment};
use exact_ccd_mesh::vector::{cross, minus, unit};

use crate::rounding::{FLOOR, UNIT, above, length, sum};
use crate::sine::sine;
use crate::trajectory::{Position, Trajectory};

/// A rigid motion at constant speed: rotation about an axis that itself moves in a straight line.
///
/// The point at p at t = 0 is at p + (R(t θ) − 1) (p − c) + t v at time t, where R(φ) is the right-handed
/// rotation by the angle φ about the direction of the axis, c a point of the axis at t = 0, and v its
/// displacement in the step. If v is parallel to the axis, this is a screw motion. All numbers are taken
/// exactly; the direction need not have length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidMotion {
    center: Point,
    /// The direction with length 1, up to 10 u.
    direction: Point,
    angle: f64,
    displacement: Point,
}

/// Numbers that do not describe a rigid motion.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RigidMotionError {
    /// A number is infinite or NaN.
    #[error("the {quantity} of a rigid motion has the value {value}, expected a finite number")]
    NotFinite {
        /// The name of the quantity.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// The axis of a rotation by an angle other than 0 has no direction.
    #[error("the axis has the direction {0:?}, expected one that is not zero")]
    Axis(Point),
    /// A quaternion does not describe a rotation.
    #[error("the rotation is the quaternion {0:?}, expected one that is finite and not zero")]
    Rotation([f64; 4]),
}

impl RigidMotion {
    /// Rotation about the axis through `center` along `direction`, by `angle` in radians, of any number
    /// of turns; the axis moves by `displacement`.
    ///
    /// # Errors
    /// [`RigidMotionError`], if a number is not finite, or if the angle is not 0 and the
    /// direction is zero.
    pub fn new(
        center: Point,
        direction: Point,
        angle: f64,
        displacement: Point,
    ) -> Result<Self, RigidMotionError> {
        let quantities: [(_, &[f64]); 4] = [
            ("center", &center),
            ("direction", &direction),
            ("angle", &[angle]),
            ("displacement", &displacement),
        ];
        for (quantity, values) in quantities {
            if let Some(&value) = values.iter().find(|x| !x.is_finite()) {
                return Err(RigidMotionError::NotFinite { quantity, value });
            }
        }
        // All components are finite: only the zero vector has no direction.
        let direction = match unit(direction) {
            None if angle != 0.0 => return Err(RigidMotionError::Axis(direction)),
            found => found.unwrap_or_default(),
        };
        Ok(Self {
            center,
            direction,
            angle,
            displacement,
        })
    }

    /// The trajectory of the point that is at `start` at t = 0.
    #[must_use]
    pub fn point(&self, start: Point) -> RigidPoint {
        // Where subnormal numbers count as 0, so does such an angle; the error below is infinite there.
        if self.angle == 0.0 && environment::is_default() {
            let [tangent, radius] = [[0.0; 3]; 2];
            return RigidPoint {
                start,
                tangent,
                radius,
                error: 0.0,
                motion: *self,
            };
        }
        let arm = minus(start, self.center);
        let tangent = cross(self.direction, arm);
        RigidPoint {
            start,
            tangent,
            radius: cross(tangent, self.direction),
            error: above(RADIUS_ERROR * length(arm)),
            motion: *self,
        }
    }
}

/// A bound of the errors of tangent and radius, relative to the arm r = p − c.
///
/// With errors to first order: a quotient of the direction w by its largest component is off by u, also
/// if both are subnormal, or by less than 2⁻¹⁰⁷⁴ beside the quotient 1; the
/// norm by 8 u and the unit vector a by 10 u; r is off by u |r|. A component of a × r has the error
/// 2 u (|aⱼ rₖ| + |aₖ rⱼ|) ≤ 2 u |r| by Cauchy's inequality, hence the vector 3.5 u |r|. So a × r is off
/// by (10 + 1 + 3.5) u |r|, and (a × r) × a by (14.5 + 10 + 3.5) u |r| = 28 u |r|. If the unit vector was
/// computed on a thread that rounds in another direction, with twice the error, these are 24.5 u |r| and
/// (24.5 + 20 + 3.5) u |r| = 48 u |r|. The bound has 64 u.
const RADIUS_ERROR: f64 = 64.0 * UNIT;

/// The trajectory of a point of a rigid body.
///
/// With the unit vector a of the axis, w = a × (p − c) and the radius vector ρ = w × a, it is
/// x(t) = p − 2 sin²(φ / 2) ρ + sin(φ) w + t v, φ = θ t. At t = 0 there is no error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RigidPoint {
    start: Point,
    /// w, up to `error`.
    tangent: Point,
    /// ρ, up to `error`.
    radius: Point,
    error: f64,
    motion: RigidMotion,
}

impl Trajectory for RigidPoint {
    /// The bound of the error is a sum of five parts, each with the constants of first order rounded up:
    ///
    /// - φ = fl(θ t) is off by u |φ|, and sine and cosine by no more.
    /// - The sine comes with a bound of its error. With h = sin(φ / 2), off by η, 2 h² is off by
    ///   2 η (2 |h| + η), and by 2 u · 2 h² from its two roundings.
    /// - ρ and w are off by the constant error of the point.
    /// - The products and sums of ρ (2 h²), w sin(φ) and t v have at most three roundings each: 4 u of
    ///   their lengths.
    /// - The rounding of the final sum is computed exactly.
    fn at(&self, time: f64) -> Position {
        let Self {
            start,
            tangent,
            radius,
            error,
            motion,
        } = self;
        if time == 0.0 {
            return Position::exactly(*start);
        }
        let phi = motion.angle * time;
        let [(sine, sine_error), (half, half_error)] = [phi, 0.5 * phi].map(sine);
        let versine = 2.0 * half * half;
        let offset = [0, 1, 2].map(|axis: usize| {
            (sine * tangent[axis] - versine * radius[axis]) + time * motion.displacement[axis]
        });
        let sums = [0, 1, 2].map(|axis: usize| sum(start[axis], offset[axis]));
        let point = sums.map(|(x, _)| x);
        let last = length(sums.map(|(_, error)| error));
        let travel = length(motion.displacement);
        if motion.angle == 0.0 && (time == 1.0 || travel == 0.0) {
            // t v is exact.
            let error = if last == 0.0 { 0.0 } else { above(last) };
            return Position { point, error };
        }
        let sine_error = sine_error + 2.0 * UNIT * phi.abs() + FLOOR;
        let half_error = half_error + UNIT * phi.abs() + FLOOR;
        let versine_error = 2.0 * half_error * (2.0 * half.abs() + half_error) + 2.0 * UNIT * versine + FLOOR;
        let (w, rho) = (length(*tangent), length(*radius));
        let inexact_factors = w * sine_error + rho * versine_error;
        let inexact_vectors = error * (sine.abs() + sine_error + versine + versine_error);
        let rounding = 4.0 * UNIT * (w * sine.abs() + rho * versine + time * travel);
        Position {
            point,
            error: above(inexact_factors + inexact_vectors + rounding + last),
        }
    }

    /// With the angle α = θ (end − start) and the radius r = |ρ|: |x″| = r θ², so that the deviation is at
    /// most r α² / 8. It is at most 2 r too, because arc and chord lie in a disc of that radius. The
    /// straight motion by t v does not deviate. For comparison, the deviation half way is r
    /// (1 − cos(α / 2)).
    fn deviation(&self, start: f64, end: f64) -> f64 {
        let angle = self.motion.angle * (end - start);
        if self.motion.angle == 0.0 {
            return 0.0;
        }
        let radius = length(self.radius) + self.error;
        // In this order, no underflow is amplified.
        above((0.125 * angle.abs() * (angle.abs() * radius)).min(2.0 * radius))
    }
}
