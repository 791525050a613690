//! Simulations that cannot start or go on.

use exact_ccd_mesh::Point;

use super::start::Primitive;
use crate::filter::UnknownFilter;
use crate::settings::SettingError;

/// What keeps a simulation from starting or from going on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// A number of the settings is out of range.
    #[error(transparent)]
    Setting(#[from] SettingError),
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
    /// More steps are said to have been taken than can be counted in f64.
    #[error("the state is after {step} steps, expected fewer than 2⁵³")]
    Late {
        /// How many.
        step: u64,
    },
    /// The checkpoint is that of a run with another setting.
    #[error("the checkpoint is of a run with `{what}` = {there}, now it is {here}")]
    OtherSetting {
        /// Which, as in [`Settings`](crate::Settings) with dots and hyphens.
        what: String,
        /// Its value in the checkpoint, as JSON.
        there: String,
        /// Its value now.
        here: String,
    },
    /// The checkpoint is that of another system.
    #[error("the checkpoint is of a run with other {what}")]
    OtherSystem {
        /// What differs: `positions`, `elements`, `velocities`, `materials` or `scripts`.
        what: &'static str,
    },
    /// Something intersects or touches something already.
    #[error("{} and {}, near {near:?}, meet where the simulation starts, expected a distance between them", primitives[0], primitives[1])]
    Start {
        /// What meets.
        primitives: [Primitive; 2],
        /// Where a vertex of them is, in m.
        near: Point,
    },
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
