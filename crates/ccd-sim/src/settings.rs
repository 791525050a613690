//! How a scene is simulated.

use ccd_mesh::Point;
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
    /// When Newton's method stops: all vertices' next displacements, per time step, are below this length per second.
    pub tolerance: Length,
    /// How many iterations of Newton's method to do at most, for each lag of friction.
    pub max_iterations: usize,
    /// The name of the method of continuous collision detection, see [`filter::names`](crate::filter::names).
    pub ccd: String,
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
