//! How a scene is simulated.

use exact_ccd_mesh::Point;
use serde::{Deserialize, Serialize};

use crate::integrator::Integrator;

/// The numbers of a simulation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Settings {
    /// The time step, in s.
    pub time_step: f64,
    /// The acceleration of gravity, in m/s².
    pub gravity: Point,
    /// The time integration.
    pub integrator: Integrator,
    /// The distance d̂ below which things repel each other.
    pub contact_distance: Length,
    /// Friction.
    pub friction: Friction,
    /// When Newton's method stops: along no axis would a vertex go on faster than this length per second, over the time that
    /// forces act, which is the time step or, of BDF2, two thirds of it; nor would more energy be set free than that of all free
    /// masses at this speed.
    pub tolerance: Length,
    /// How many iterations of Newton's method to do at most, for each lag of friction.
    pub max_iterations: usize,
    /// The name of the method of continuous collision detection, see [`filter::names`](crate::filter::names).
    pub ccd: String,
}

/// A number of the settings is out of range.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("`{what}` is {value}, expected {expected}")]
pub struct SettingError {
    /// Which, as in [`Settings`] with dots and hyphens.
    pub what: &'static str,
    /// Its value; that of a length in m.
    pub value: f64,
    /// What it should be.
    pub expected: &'static str,
}

impl Settings {
    /// Whether all numbers are in range, for a scene of a size (in m).
    ///
    /// # Errors
    /// [`SettingError`] names the first that is not.
    pub fn check(&self, size: f64) -> Result<(), SettingError> {
        let is_positive = |x: f64| x > 0.0 && x.is_finite();
        let (distance, tolerance) = (self.contact_distance.meters(size), self.tolerance.meters(size));
        let slow = self.friction.static_velocity.meters(size);
        let friction = self.friction.coefficient;
        let positive = "a positive number";
        let checks = [
            ("time-step", self.time_step, is_positive(self.time_step), positive),
            ("contact-distance", distance, is_positive(distance), positive),
            (
                "contact-distance",
                distance,
                (distance * distance).is_normal(),
                "a length whose square is a normal number",
            ),
            // Beyond it, everything would be in contact with everything.
            (
                "contact-distance",
                distance,
                distance <= size,
                "a length not above the diagonal of the box around the scene",
            ),
            ("tolerance", tolerance, is_positive(tolerance), positive),
            ("friction.static-velocity", slow, is_positive(slow), positive),
            (
                "friction.coefficient",
                friction,
                friction >= 0.0 && friction.is_finite(),
                "a number not below 0",
            ),
            (
                "friction.lags",
                self.friction.lags as f64,
                self.friction.lags > 0,
                "1 at least",
            ),
            (
                "max-iterations",
                self.max_iterations as f64,
                self.max_iterations > 0,
                "1 at least",
            ),
        ];
        let gravity = self
            .gravity
            .map(|g| ("gravity", g, g.is_finite(), "finite numbers"));
        match checks
            .into_iter()
            .chain(gravity)
            .find(|(_, _, is_good, _)| !is_good)
        {
            None => Ok(()),
            Some((what, value, _, expected)) => Err(SettingError {
                what,
                value,
                expected,
            }),
        }
    }
}

/// A length.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Length {
    /// In m.
    Absolute(f64),
    /// In diagonals of the box around the scene at its start.
    Relative(f64),
}

impl Length {
    /// The length in m, in a scene of a size.
    #[must_use]
    pub fn meters(self, size: f64) -> f64 {
        match self {
            Self::Absolute(meters) => meters,
            Self::Relative(share) => share * size,
        }
    }
}

/// Friction between all surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Friction {
    /// The friction coefficient μ.
    pub coefficient: f64,
    /// The slip velocity below which friction is static.
    pub static_velocity: Length,
    /// How often normal forces and tangent planes are updated in a step, 1 at least.
    pub lags: usize,
}

impl Default for Settings {
    /// Implicit Euler with 0.01 s, gravity along −y, without friction, and the lengths of *Incremental Potential Contact*.
    fn default() -> Self {
        Self {
            time_step: 0.01,
            gravity: [0.0, -9.81, 0.0],
            integrator: Integrator::default(),
            contact_distance: Length::Relative(1e-3),
            friction: Friction::default(),
            tolerance: Length::Relative(1e-2),
            max_iterations: 100,
            ccd: "exact".to_owned(),
        }
    }
}

impl Default for Friction {
    /// None.
    fn default() -> Self {
        Self {
            coefficient: 0.0,
            static_velocity: Length::Relative(1e-3),
            lags: 1,
        }
    }
}
