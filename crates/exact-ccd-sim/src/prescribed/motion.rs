//! Scripted motions.

use exact_ccd_mesh::Point;
use nalgebra::{Rotation3, Unit, Vector3};
use serde::{Deserialize, Serialize};

use crate::digest::{Digest, Hash};
use crate::range::{NOT_NEGATIVE, OutOfRange, check, check_direction, check_finite};

/// A prescribed motion of vertices (a Dirichlet condition).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Script {
    /// No motion.
    #[default]
    Fixed,
    /// Translation at constant velocity.
    Moving {
        /// The velocity, in m/s.
        velocity: Point,
        /// The time at which the motion ends, in s. `None`: it does not end.
        until: Option<f64>,
    },
    /// Rotation about an axis at constant angular velocity.
    Twisting {
        /// A point on the axis, in m.
        center: Point,
        /// The direction of the axis, of any length.
        axis: Point,
        /// The angular velocity, in rad/s. Positive rates are counterclockwise for a viewer at whom the
        /// axis points.
        rate: f64,
        /// The time at which the motion ends, in s. `None`: it does not end.
        until: Option<f64>,
    },
    /// A rotation about an axis, followed by a translation, through key frames. Both are relative to the
    /// position where the script begins, and interpolated linearly in time; before the first key frame and
    /// after the last one, they do not change.
    KeyFrames {
        /// The key frames, by increasing time.
        frames: Vec<KeyFrame>,
        /// A point on the axis of rotation before the translation, in m.
        #[serde(default)]
        center: Point,
        /// The direction of the axis, of any length.
        #[serde(default = "upward")]
        axis: Point,
    },
}

/// The rotation and the translation of vertices at one time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct KeyFrame {
    /// The time, in s.
    pub time: f64,
    /// The translation from the position where the script begins, in m.
    #[serde(default)]
    pub translate: Point,
    /// The angle of rotation of the position where the script begins. Positive angles are counterclockwise
    /// for a viewer at whom the axis points.
    #[serde(default)]
    pub degrees: f64,
}

fn upward() -> Point {
    [0.0, 1.0, 0.0]
}

impl Script {
    /// Checks that the parameters are in range.
    ///
    /// # Errors
    /// [`OutOfRange`] names the first parameter that is out of range, after the kind of the script and a dot.
    pub fn check(&self) -> Result<(), OutOfRange> {
        let time = |field, until: &Option<f64>| {
            let until = until.unwrap_or(f64::INFINITY);
            check(until >= 0.0, field, until, NOT_NEGATIVE)
        };
        match self {
            Self::Fixed => Ok(()),
            Self::Moving { velocity, until } => {
                check_finite("moving.velocity", velocity)?;
                time("moving.until", until)
            }
            Self::Twisting {
                center,
                axis,
                rate,
                until,
            } => {
                check_finite("twisting.center", center)?;
                check_direction("twisting.axis", axis)?;
                check(rate.is_finite(), "twisting.rate", rate, "a finite number")?;
                time("twisting.until", until)
            }
            Self::KeyFrames { frames, center, axis } => {
                let is_finite = |frame: &KeyFrame| {
                    let numbers = [frame.time, frame.degrees];
                    numbers.iter().chain(&frame.translate).all(|x| x.is_finite())
                };
                let increase = frames.windows(2).all(|pair| pair[0].time < pair[1].time);
                check(
                    !frames.is_empty() && increase && frames.iter().all(is_finite),
                    "key-frames.frames",
                    format_args!("a list of {}", frames.len()),
                    "at least one key frame, at increasing times, of finite numbers",
                )?;
                check_finite("key-frames.center", center)?;
                check_direction("key-frames.axis", axis)
            }
        }
    }

    /// The time at which a motion at constant velocity ends, in s, if it does.
    pub(crate) fn until(&self) -> Option<f64> {
        match self {
            Self::Moving { until, .. } | Self::Twisting { until, .. } => *until,
            Self::Fixed | Self::KeyFrames { .. } => None,
        }
    }

    /// Returns true if it turns vertices, so that it is rigid along all axes together only.
    pub(crate) fn turns(&self) -> bool {
        match self {
            Self::Fixed | Self::Moving { .. } => false,
            Self::Twisting { rate, .. } => *rate != 0.0,
            Self::KeyFrames { frames, .. } => frames.iter().any(|frame| frame.degrees != 0.0),
        }
    }

    /// The position at a time of a vertex that is at `origin` when the script begins, at the time `from`,
    /// both in s.
    #[must_use]
    pub fn position(&self, origin: Point, from: f64, time: f64) -> Point {
        let clock = |until: Option<f64>| until.map_or(time, |until| time.min(until)) - from;
        match self {
            Self::Fixed => origin,
            Self::Moving { velocity, until } => {
                let time = clock(*until);
                core::array::from_fn(|axis| origin[axis] + time * velocity[axis])
            }
            Self::Twisting {
                center,
                axis,
                rate,
                until,
            } => turned(origin, *center, *axis, rate * clock(*until)),
            Self::KeyFrames { frames, center, axis } => {
                let (translate, degrees) = between(frames, time);
                let turned = turned(origin, *center, *axis, degrees.to_radians());
                (Vector3::from(turned) + translate).into()
            }
        }
    }
}

/// A point after a rotation about an axis, counterclockwise for a viewer at whom the axis points.
fn turned(point: Point, center: Point, axis: Point, angle: f64) -> Point {
    let center = Vector3::from(center);
    let Some(axis) = Unit::try_new(Vector3::from(axis), 0.0) else {
        return point;
    };
    if angle == 0.0 {
        return point;
    }
    let rotation = Rotation3::from_axis_angle(&axis, angle);
    (center + rotation * (Vector3::from(point) - center)).into()
}

/// The translation and the angle in degrees at a time, between key frames.
fn between(frames: &[KeyFrame], time: f64) -> (Vector3<f64>, f64) {
    let next = frames.partition_point(|frame| frame.time <= time);
    let at = |frame: &KeyFrame| (Vector3::from(frame.translate), frame.degrees);
    match (
        next.checked_sub(1).and_then(|last| frames.get(last)),
        frames.get(next),
    ) {
        (Some(last), Some(next)) => {
            let share = (time - last.time) / (next.time - last.time);
            let ((from, before), (to, after)) = (at(last), at(next));
            (from + (to - from) * share, before + (after - before) * share)
        }
        (Some(frame), None) | (None, Some(frame)) => at(frame),
        (None, None) => (Vector3::zeros(), 0.0),
    }
}

impl Digest for Script {
    fn digest(&self, hash: &mut Hash) {
        match self {
            Self::Fixed => 0_u32.digest(hash),
            Self::Moving { velocity, until } => (1_u32, (velocity, until)).digest(hash),
            Self::Twisting {
                center,
                axis,
                rate,
                until,
            } => (2_u32, ([center, axis], (rate, until))).digest(hash),
            Self::KeyFrames { frames, center, axis } => (3_u32, (frames, [center, axis])).digest(hash),
        }
    }
}

impl Digest for KeyFrame {
    fn digest(&self, hash: &mut Hash) {
        let Self {
            time,
            translate,
            degrees,
        } = self;
        ([time, degrees], translate).digest(hash);
    }
}
