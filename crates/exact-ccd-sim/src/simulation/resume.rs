//! Simulations from checkpoints.

use serde_json::Value;

use super::{Simulation, SimulationError};
use crate::checkpoint::Checkpoint;
use crate::filter::StepFilter;
use crate::settings::Settings;
use crate::system::System;

impl Checkpoint {
    /// The simulation in the state of the checkpoint, with a filter that has the name in its settings.
    ///
    /// # Errors
    /// [`SimulationError::OtherSetting`] and [`SimulationError::OtherSystem`] name the difference between
    /// the checkpoint and the arguments. [`SimulationError::OtherVersion`] is that of a checkpoint which
    /// cannot be compared. All other errors are those of [`Simulation::resume`].
    pub fn resume(
        self,
        system: System,
        settings: Settings,
        filter: StepFilter,
    ) -> Result<Simulation, SimulationError> {
        let settings = Settings {
            ccd: filter.name().to_owned(),
            ..settings
        };
        if let Some(different) = different_setting(&self.settings, &settings) {
            return Err(different);
        }
        if !self.system.is_current() {
            return Err(SimulationError::OtherVersion);
        }
        match self.system.difference(&system.fingerprint()) {
            None => Simulation::resume_with(system, settings, self.state, filter),
            Some(what) => Err(SimulationError::OtherSystem { what }),
        }
    }
}

/// The first setting that differs.
fn different_setting(there: &Settings, here: &Settings) -> Option<SimulationError> {
    let [there, here] = [there, here].map(|settings| {
        // The case of a method's name does not matter.
        let ccd = settings.ccd.to_lowercase();
        let settings = Settings {
            ccd,
            ..settings.clone()
        };
        // Settings always serialise.
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
