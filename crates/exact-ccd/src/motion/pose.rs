//! The pose of a rigid body.

use super::error::InvalidMotion;
use crate::exact;
use crate::query::NonFinite;
use crate::tables::Point;

/// An orientation and a place: the point v of the body is at o + N v / |q|², where N v = q v q*.
///
/// The quaternion q, scalar first, is taken exactly, and may have any length but 0: every one is a rotation.
/// Nothing is normalised, so that a body keeps its shape, and the end of a step is the start of the next one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    rotation: [f64; 4],
    place: Point,
}

impl Pose {
    /// The pose with this quaternion, scalar first, and with the origin of the body at `place`.
    ///
    /// # Errors
    /// [`InvalidMotion`], if a number is not finite, or if the quaternion is 0.
    pub fn new(rotation: [f64; 4], place: Point) -> Result<Self, InvalidMotion> {
        check_rotation(rotation, None)?;
        check_points([[place]])?;
        Ok(Self { rotation, place })
    }

    /// The quaternion, scalar first.
    #[must_use]
    pub fn rotation(&self) -> [f64; 4] {
        self.rotation
    }

    /// The place of the origin of the body.
    #[must_use]
    pub fn place(&self) -> Point {
        self.place
    }

    /// This pose with the one of both opposite quaternions that is nearer to that of an earlier pose: the
    /// turn from there is at most 180°. The two are the same rotation.
    #[must_use]
    pub fn nearer_turn(self, earlier: &Self) -> Self {
        if exact::cosine_sign([earlier.rotation, self.rotation]).is_lt() {
            Self {
                rotation: self.rotation.map(|x| -x),
                ..self
            }
        } else {
            self
        }
    }
}

/// Checks that a quaternion is finite and not 0.
pub(super) fn check_rotation(rotation: [f64; 4], time: Option<usize>) -> Result<(), InvalidMotion> {
    let mut components = rotation.into_iter().enumerate();
    if let Some((component, value)) = components.find(|(_, value)| !value.is_finite()) {
        return Err(InvalidMotion::Quaternion {
            time,
            component,
            value,
        });
    }
    // By its bits: a floating-point comparison may read subnormal numbers as zero.
    if rotation.iter().all(|x| x.to_bits() << 1 == 0) {
        return Err(InvalidMotion::Zero { time });
    }
    Ok(())
}

/// Checks that the coordinates of sets of control points are finite.
pub(super) fn check_points<P: AsRef<[Point]>>(
    sets: impl IntoIterator<Item = P>,
) -> Result<(), InvalidMotion> {
    for (control, points) in sets.into_iter().enumerate() {
        NonFinite::check(&[points.as_ref()]).map_err(|error| InvalidMotion::ControlPoint {
            control,
            point: error.point,
            axis: error.axis,
            value: error.value,
        })?;
    }
    Ok(())
}
