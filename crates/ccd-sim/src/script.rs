//! Motions that are given.

use ccd_mesh::Point;
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

impl Script {
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
