//! Scripted motions.

use exact_ccd_mesh::Point;
use nalgebra::{Rotation3, Unit, Vector3};
use serde::{Deserialize, Serialize};

/// A prescribed motion of vertices (a Dirichlet condition).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
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
}

/// A parameter of a script that is out of range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{field}` is out of range, expected {expected}")]
pub struct ScriptError {
    /// The kind of the script, a dot, and the name of the parameter.
    pub field: &'static str,
    /// The values that are allowed.
    pub expected: &'static str,
}

impl Script {
    /// Checks that the parameters are in range.
    ///
    /// # Errors
    /// [`ScriptError`] names the first parameter that is out of range.
    pub fn check(&self) -> Result<(), ScriptError> {
        let is_finite = |point: &Point| point.iter().all(|x| x.is_finite());
        let is_time = |until: Option<f64>| until.is_none_or(|until| until >= 0.0);
        let (numbers, time) = ("finite numbers", "a number not below 0");
        let checks = match self {
            Self::Fixed => Vec::new(),
            Self::Moving { velocity, until } => vec![
                ("moving.velocity", is_finite(velocity), numbers),
                ("moving.until", is_time(*until), time),
            ],
            Self::Twisting {
                center,
                axis,
                rate,
                until,
            } => vec![
                ("twisting.center", is_finite(center), numbers),
                (
                    "twisting.axis",
                    Vector3::from(*axis).norm().is_normal(),
                    "a vector of positive length",
                ),
                ("twisting.rate", rate.is_finite(), "a finite number"),
                ("twisting.until", is_time(*until), time),
            ],
        };
        match checks.into_iter().find(|(_, is_good, _)| !is_good) {
            None => Ok(()),
            Some((field, _, expected)) => Err(ScriptError { field, expected }),
        }
    }

    /// The position at a time (in s) of a vertex that is at `start` at time 0.
    #[must_use]
    pub fn position(&self, start: Point, time: f64) -> Point {
        let clock = |until: Option<f64>| until.map_or(time, |until| time.min(until));
        match *self {
            Self::Fixed => start,
            Self::Moving { velocity, until } => {
                let time = clock(until);
                core::array::from_fn(|axis| start[axis] + time * velocity[axis])
            }
            Self::Twisting {
                center,
                axis,
                rate,
                until,
            } => {
                let center = Vector3::from(center);
                let Some(axis) = Unit::try_new(Vector3::from(axis), 0.0) else {
                    return start;
                };
                let rotation = Rotation3::from_axis_angle(&axis, rate * clock(until));
                (center + rotation * (Vector3::from(start) - center)).into()
            }
        }
    }
}
