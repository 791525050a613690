//! Where a simulation is.

use exact_ccd_mesh::Point;
use serde::{Deserialize, Serialize};

/// All that a simulation needs to go on. Written and read without loss, it goes on to the same bits, on
/// the same machine.
///
/// Friction needs nothing more: its normal forces at the start of a step are those at `positions`, with `stiffness`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// How many steps have been taken.
    pub step: u64,
    /// The position of each vertex, in m.
    pub positions: Vec<Point>,
    /// The velocity of each vertex, in m/s.
    pub velocities: Vec<Point>,
    /// A step earlier, for BDF2.
    pub earlier: Option<Earlier>,
    /// The stiffness of the barrier as an energy, in kg/(m² s²), once there has been contact: κ over the square of the time
    /// that forces act, which is not that of the next step where BDF2 follows implicit Euler.
    pub stiffness: Option<f64>,
}

/// Positions and velocities a step earlier.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Earlier {
    /// The position of each vertex, in m.
    pub positions: Vec<Point>,
    /// The velocity of each vertex, in m/s.
    pub velocities: Vec<Point>,
}
