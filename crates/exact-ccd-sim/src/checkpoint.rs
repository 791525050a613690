//! Where a simulation is, and of what.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::settings::Settings;
use crate::simulation::{Simulation, SimulationError};
use crate::state::State;
use crate::system::{Fingerprint, System};

/// A state with the settings and the system of which it is: only with these, it goes on as if it had never stopped.
///
/// To be written and read without loss as JSON, it needs the feature `float_roundtrip` of `serde_json`.
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
    /// [`SimulationError::OtherSetting`] and [`SimulationError::OtherSystem`] name what is not as in the checkpoint. Others are as
    /// in [`Simulation::resume`].
    pub fn resume(self, system: System, settings: Settings) -> Result<Simulation, SimulationError> {
        if let Some(different) = different_setting(&self.settings, &settings) {
            return Err(different);
        }
        match self.system.difference(&system.fingerprint()) {
            None => Simulation::resume(system, settings, self.state),
            Some(what) => Err(SimulationError::OtherSystem { what }),
        }
    }
}

/// The first setting that differs.
fn different_setting(there: &Settings, here: &Settings) -> Option<SimulationError> {
    let [there, here] = [there, here].map(|settings| {
        // Names of methods are the same in upper and lower case.
        let ccd = settings.ccd.to_lowercase();
        let settings = Settings {
            ccd,
            ..settings.clone()
        };
        // All of them can be written.
        serde_json::to_value(settings).unwrap_or_default()
    });
    difference("", &there, &here)
}

fn difference(name: &str, there: &Value, here: &Value) -> Option<SimulationError> {
    match (there, here) {
        _ if there == here => None,
        (Value::Object(there), Value::Object(here)) if there.keys().eq(here.keys()) => {
            let dot = if name.is_empty() { "" } else { "." };
            let mut pairs = there.iter().zip(here.values());
            pairs.find_map(|((key, there), here)| difference(&format!("{name}{dot}{key}"), there, here))
        }
        _ => Some(SimulationError::OtherSetting {
            what: name.to_owned(),
            there: there.to_string(),
            here: here.to_string(),
        }),
    }
}
