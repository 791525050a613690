//! Motions that are given.

use exact_ccd_mesh::Point;
use nalgebra::{Rotation3, Unit, Vector3};
use serde::{Deserialize, Serialize};

/// How vertices move, whatever else happens.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Script {
    /// Not at all.
    #[default]
    Fixed,
    /// At constant velocity.
    Moving {
        /// The velocity, in m/s.
        velocity: Point,
        /// When the motion ends, in s; if not given, never.
        until: Option<f64>,
    },
    /// About an axis at constant angular velocity.
    Twisting {
        /// A point on the axis, in m.
        center: Point,
        /// The direction of the axis, of any length.
        axis: Point,
        /// The angular velocity, in rad/s, counterclockwise seen against the axis.
        rate: f64,
        /// When the motion ends, in s; if not given, never.
        until: Option<f64>,
    },
}

/// A number of a script is out of range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{field}` is out of range, expected {expected}")]
pub struct ScriptError {
    /// Which, after the kind of the script and a dot.
    pub field: &'static str,
    /// What it should be.
    pub expected: &'static str,
}

impl Script {
    /// Whether its numbers are in range.
    ///
    /// # Errors
    /// [`ScriptError`] names the one that is not.
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
                    "a direction",
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

    /// Where a vertex is at a time (in s) that was at `start` at time 0.
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
