//! Poses of rigid bodies.

use exact_ccd::Point;
use exact_ccd_mesh::vector::{cross, minus};

use crate::rigid::{RigidMotion, RigidMotionError};
use crate::rounding::length;

/// A place and an orientation of a rigid body: the point p of the body is at R p + x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// x, the place of the body's origin.
    pub origin: Point,
    /// The rotation R as a quaternion \[w, x, y, z\]. It is finite and not zero; its length need not be 1.
    pub rotation: [f64; 4],
}

impl Pose {
    /// The pose without rotation.
    #[must_use]
    pub fn at(origin: Point) -> Self {
        Self {
            origin,
            rotation: [1.0, 0.0, 0.0, 0.0],
        }
    }

    /// The place of a point of the body, rounded; NaN for a quaternion that is zero or not finite.
    #[must_use]
    pub fn place(&self, point: Point) -> Point {
        // p + 2 q × (q × p + w p) / |(w, q)|²
        let [w, x, y, z] = self.scaled();
        let q = [x, y, z];
        let inner = cross(q, point);
        let outer = cross(q, [0, 1, 2].map(|axis: usize| inner[axis] + w * point[axis]));
        let scale = 2.0 / (w * w + x * x + y * y + z * z);
        [0, 1, 2].map(|axis: usize| (point[axis] + scale * outer[axis]) + self.origin[axis])
    }

    /// The rigid motion from this pose to another: the body turns about its origin, by at most half a
    /// turn, and the origin moves in a straight line.
    ///
    /// The parameters of the motion are rounded, and then taken exactly: the motion ends at `end` up
    /// to this rounding.
    ///
    /// # Errors
    /// [`RigidMotionError`], if a number is not finite, or if a quaternion is zero.
    pub fn motion_to(&self, end: &Self) -> Result<RigidMotion, RigidMotionError> {
        for rotation in [self.rotation, end.rotation] {
            if rotation == [0.0; 4] || !rotation.iter().all(|x| x.is_finite()) {
                return Err(RigidMotionError::Rotation(rotation));
            }
        }
        let [a, b, c, d] = self.scaled();
        let [w, x, y, z] = end.scaled();
        // The product of the end with the conjugate of the start.
        let real = w * a + x * b + y * c + z * d;
        let axis = [
            x * a - w * b - y * d + z * c,
            y * a - w * c - z * b + x * d,
            z * a - w * d - x * c + y * b,
        ];
        // q and −q are the same rotation; the one with a positive real part has the smaller angle.
        let (real, axis) = if real < 0.0 {
            (-real, axis.map(|x| -x))
        } else {
            (real, axis)
        };
        let angle = 2.0 * libm::atan2(length(axis), real);
        let displacement = minus(end.origin, self.origin);
        RigidMotion::new(self.origin, axis, angle, displacement)
    }

    /// The same rotation as a quaternion whose largest component is ±1, so that products neither overflow
    /// nor vanish together.
    fn scaled(&self) -> [f64; 4] {
        let largest = self.rotation.into_iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        self.rotation.map(|x| x / largest)
    }
}
