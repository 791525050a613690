//! The state of a simulation.

use std::collections::BTreeMap;

use exact_ccd_mesh::Point;
use serde::{Deserialize, Serialize};

/// The state of a simulation between two time steps.
///
/// A simulation that is resumed from a saved state continues with identical bits on the same machine, if
/// the state is written and read without loss. Friction has no state of its own: the normal forces at
/// the start of a step follow from `positions` and `stiffness`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// The number of time steps taken.
    pub step: u64,
    /// The position of each vertex, in m.
    pub positions: Vec<Point>,
    /// The velocity of each vertex, in m/s.
    pub velocities: Vec<Point>,
    /// The state one step earlier, for BDF2.
    pub earlier: Option<Earlier>,
    /// The stiffness of the barrier as an energy, in kg/(m² s²): κ over the square of the effective time
    /// step of the last step. `None` before the first contact. It is stored in this form because the
    /// effective time step changes when BDF2 follows its first step, which is one of implicit Euler.
    pub stiffness: Option<f64>,
    /// For each axis, the position in m of a vertex where its script began, by the number of the vertex.
    /// Vertices without an entry were at their start.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub origins: BTreeMap<u32, [Point; 3]>,
    /// The time in s by which the scripts of a body are behind because of an obstruction, by the number of
    /// the body. Bodies without an entry are not behind.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub behind: BTreeMap<u32, f64>,
    /// The twist in rad at an inner vertex of a rod between two held edges, by the number of the vertex: the
    /// angle between the cross sections of its two edges. Vertices without an entry are not twisted.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub twists: BTreeMap<u32, f64>,
}

/// Positions and velocities one step earlier.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Earlier {
    /// The position of each vertex, in m.
    pub positions: Vec<Point>,
    /// The velocity of each vertex, in m/s.
    pub velocities: Vec<Point>,
}
