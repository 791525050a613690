//! Simulations that cannot start or go on.

use super::start::Meeting;
use crate::filter::UnknownFilter;
use crate::settings::{Length, Settings};

/// What keeps a simulation from starting or from going on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// A number of the settings is out of range.
    #[error("`{what}` is {value}, expected {expected}")]
    Setting {
        /// Which, as in [`Settings`] with dots and hyphens.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it should be.
        expected: &'static str,
    },
    /// There is no such method of continuous collision detection.
    #[error(transparent)]
    Filter(#[from] UnknownFilter),
    /// The state is that of another system.
    #[error("the state has {found} {what}, expected {expected}, one for each vertex")]
    State {
        /// `positions`, `velocities`, and so on.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many vertices the system has.
        expected: usize,
    },
    /// A number of the state is NaN or infinite.
    #[error("the {what} of the state are not all finite")]
    NotFinite {
        /// `positions`, `velocities`, and so on.
        what: &'static str,
    },
    /// The checkpoint is that of another simulation.
    #[error("the checkpoint is of a run with other `{what}`")]
    Checkpoint {
        /// The setting, as in [`Settings`] with dots and hyphens, or the part of the system: `positions`, `elements`,
        /// `velocities`, `materials` or `scripts`.
        what: &'static str,
    },
    /// Something intersects or touches something already.
    #[error("{0} meet where the simulation starts, expected a distance between them")]
    Start(Meeting),
    /// The linear system of a Newton iteration has no solution: forces are not finite, or far out of proportion.
    #[error("step {step}: the linear system has no solution")]
    Singular {
        /// The number of the step.
        step: u64,
    },
    /// No part of a Newton step is free of contact.
    #[error("step {step}: `{filter}` finds contact where the step begins")]
    Blocked {
        /// The number of the step.
        step: u64,
        /// The method of continuous collision detection.
        filter: String,
    },
}

/// Whether the settings are in range, for a scene of a size (in m).
pub(super) fn check(settings: &Settings, size: f64) -> Result<(), SimulationError> {
    let number = |length: Length| length.meters(size);
    let positive = [
        ("time-step", settings.time_step),
        ("contact-distance", number(settings.contact_distance)),
        ("tolerance", number(settings.tolerance)),
        (
            "friction.static-velocity",
            number(settings.friction.static_velocity),
        ),
    ];
    for (what, value) in positive {
        if !(value > 0.0 && value.is_finite()) {
            let expected = "a positive number";
            return Err(SimulationError::Setting {
                what,
                value,
                expected,
            });
        }
    }
    let distance = number(settings.contact_distance);
    if !(distance * distance).is_normal() {
        return Err(SimulationError::Setting {
            what: "contact-distance",
            value: distance,
            expected: "a length whose square is a normal number",
        });
    }
    if settings.max_iterations == 0 {
        return Err(SimulationError::Setting {
            what: "max-iterations",
            value: 0.0,
            expected: "1 at least",
        });
    }
    let coefficient = settings.friction.coefficient;
    if !(coefficient >= 0.0 && coefficient.is_finite()) {
        return Err(SimulationError::Setting {
            what: "friction.coefficient",
            value: coefficient,
            expected: "a number not below 0",
        });
    }
    match settings.gravity.iter().find(|g| !g.is_finite()) {
        None => Ok(()),
        Some(&value) => Err(SimulationError::Setting {
            what: "gravity",
            value,
            expected: "finite numbers",
        }),
    }
}
