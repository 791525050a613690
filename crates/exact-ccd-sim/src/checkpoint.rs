//! Checkpoints of a simulation.

use serde::{Deserialize, Serialize};

use crate::settings::Settings;
use crate::state::State;
use crate::system::Fingerprint;

/// The state of a simulation, with its settings and the fingerprint of its system.
///
/// A resumed simulation continues as an uninterrupted one only with the same settings and system. To
/// write and read a checkpoint as JSON without loss, enable the feature `float_roundtrip` of `serde_json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    /// The settings of the simulation.
    pub settings: Settings,
    /// The fingerprint of its system.
    pub system: Fingerprint,
    /// Its state.
    pub state: State,
}
