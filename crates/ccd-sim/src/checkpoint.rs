//! Where a simulation is, and of what.

use serde::{Deserialize, Serialize};

use crate::settings::{Friction, Settings};
use crate::simulation::{Simulation, SimulationError};
use crate::state::State;
use crate::system::{Fingerprint, System};

/// A state with the settings and the system of which it is: only with these, it goes on as if it had never stopped.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    /// The numbers of the simulation.
    pub settings: Settings,
    /// What tells its system from others.
    pub system: Fingerprint,
    /// Where it is.
    pub state: State,
}

impl Checkpoint {
    /// The simulation, which goes on.
    ///
    /// # Errors
    /// [`SimulationError::Checkpoint`] names the first setting, or part of the system, that is another one than that of the
    /// checkpoint. Others are as in [`Simulation::resume`].
    pub fn resume(self, system: System, settings: Settings) -> Result<Simulation, SimulationError> {
        let difference = difference(&self.settings, &settings);
        match difference.or_else(|| self.system.difference(&system.fingerprint())) {
            None => Simulation::resume(system, settings, self.state),
            Some(what) => Err(SimulationError::Checkpoint { what }),
        }
    }
}

/// The first setting that differs.
fn difference(a: &Settings, b: &Settings) -> Option<&'static str> {
    let Settings {
        time_step,
        gravity,
        integrator,
        contact_distance,
        friction,
        tolerance,
        max_iterations,
        ccd,
    } = a;
    let Friction {
        coefficient,
        static_velocity,
        lags,
    } = friction;
    let are_same = [
        ("time-step", *time_step == b.time_step),
        ("gravity", *gravity == b.gravity),
        ("integrator", *integrator == b.integrator),
        ("contact-distance", *contact_distance == b.contact_distance),
        ("friction.coefficient", *coefficient == b.friction.coefficient),
        (
            "friction.static-velocity",
            *static_velocity == b.friction.static_velocity,
        ),
        ("friction.lags", *lags == b.friction.lags),
        ("tolerance", *tolerance == b.tolerance),
        ("max-iterations", *max_iterations == b.max_iterations),
        ("ccd", *ccd == b.ccd),
    ];
    let different = are_same.into_iter().find(|(_, same)| !same);
    different.map(|(what, _)| what)
}
