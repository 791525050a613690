//! The pictures of a scene.

use exact_ccd_mesh::Point;
use exact_ccd_mesh::vector::{DIRECTION, has_direction};
use serde::{Deserialize, Serialize};

use super::field_error::FieldError;

/// The settings of the pictures, `[render]`. The simulation does not depend on them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Rendering {
    /// Width and height in pixels.
    pub size: [u16; 2],
    /// The direction upwards. If not given, it is opposite to gravity, or along y without gravity.
    pub up: Option<Point>,
    /// The direction from the scene to the viewer. If not given, it is slightly above the horizon.
    pub camera: Option<Point>,
    /// The part of the scene that fills the pictures.
    pub subject: Subject,
    /// True if the subject fills each picture at its time; false if its whole motion does.
    pub follow: bool,
    /// The simulated time that the animation shows in one second, in s.
    pub speed: f64,
}

/// The part of a scene that fills its pictures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Subject {
    /// The bodies with mass, and vertices that move. If there are none, everything.
    #[default]
    Moving,
    /// All bodies, obstacles included.
    All,
    /// A box.
    Box {
        /// The least coordinates, in m.
        lower: Point,
        /// The greatest coordinates, in m.
        upper: Point,
    },
}

impl Default for Rendering {
    fn default() -> Self {
        Self {
            size: [800, 600],
            up: None,
            camera: None,
            subject: Subject::Moving,
            follow: false,
            speed: 1.0,
        }
    }
}

impl Rendering {
    /// The direction upwards: the given one, or else opposite to gravity, or along y without gravity.
    #[must_use]
    pub fn upwards(&self, gravity: Point) -> Point {
        let falls = gravity.iter().any(|&g| g != 0.0);
        let otherwise = if falls {
            gravity.map(|g| 0.0 - g)
        } else {
            [0.0, 1.0, 0.0]
        };
        self.up.unwrap_or(otherwise)
    }

    /// Checks all settings.
    pub(super) fn check(&self) -> Result<(), FieldError> {
        let is_box = match self.subject {
            Subject::Box { lower, upper } => (0..3)
                .all(|axis| lower[axis].is_finite() && upper[axis].is_finite() && lower[axis] <= upper[axis]),
            Subject::Moving | Subject::All => true,
        };
        let is_size = self.size.iter().all(|side| (16..=4096).contains(side));
        let corners = "finite corners, `lower` not above `upper` along any axis";
        let checks = [
            ("size", is_size, "a width and a height from 16 to 4096 pixels"),
            ("up", self.up.is_none_or(has_direction), DIRECTION),
            ("camera", self.camera.is_none_or(has_direction), DIRECTION),
            ("subject", is_box, corners),
            (
                "speed",
                self.speed > 0.0 && self.speed.is_finite(),
                "a positive number",
            ),
        ];
        match checks.iter().find(|(_, is_in_range, _)| !is_in_range) {
            None => Ok(()),
            Some((field, _, expected)) => Err(FieldError::new(
                *field,
                format!("out of range, expected {expected}"),
            )),
        }
    }
}
