//! Simulations from checkpoints.

use super::Simulation;
use crate::checkpoint::Checkpoint;
use crate::error::SimulationError;
use crate::filter::StepFilter;
use crate::settings::Settings;
use crate::system::{Fingerprint, System};

impl Checkpoint {
    /// The simulation in the state of the checkpoint, with a filter that has the name in its settings.
    ///
    /// # Errors
    /// [`SimulationError::OtherSetting`] and [`SimulationError::OtherSystem`] name the difference between
    /// the checkpoint and the arguments. [`SimulationError::OtherVersion`] means a checkpoint that cannot be
    /// compared. All other errors are as for [`Simulation::resume`].
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
        match self.system.difference(&Fingerprint::of(&system)) {
            None => Simulation::resume_with(system, settings, self.state, filter),
            Some(what) => Err(SimulationError::OtherSystem { what }),
        }
    }
}

/// The first setting that differs.
fn different_setting(there: &Settings, here: &Settings) -> Option<SimulationError> {
    let mut pairs = there.values().into_iter().zip(here.values());
    let ((what, there), (_, here)) = pairs.find(|((_, there), (_, here))| there != here)?;
    Some(SimulationError::OtherSetting { what, there, here })
}
