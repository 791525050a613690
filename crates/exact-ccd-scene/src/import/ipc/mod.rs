//! The text scenes of IPC.
//!
//! Source of the format: the reference implementation of M. Li et al., *Incremental Potential Contact*, 2020
//! (github.com/ipc-sim/IPC, version of March 2024): `Config.cpp` and `Config.hpp` for keywords and default
//! values, `main.cpp` for the placement of meshes, `AnimScripter.cpp` for motions, `IglUtils.cpp` for
//! selections, and `Optimizer.cpp` for lengths relative to the box and for gravity.

mod bodies;
mod entries;
mod file;
mod friction;
mod held;
mod part;
mod shape;
mod words;

use super::Draft;
use super::fault::Fault;
use super::meshes::Meshes;
use crate::description::Description;
use crate::rendering::Rendering;
use exact_ccd_mesh::HalfSpace;
use exact_ccd_sim::Integrator;
use exact_ccd_sim::{Formulation, Friction, FrictionPair, Length, Settings};
use file::File;

/// The most Newton iterations of a time step in IPC (`Optimizer.cpp`).
const MAX_ITERATIONS: usize = 10_000;

/// The scene in the text of a file.
pub(super) fn import(text: &str, meshes: &mut Meshes) -> Result<Draft, Fault> {
    let mut file = File::parse(text)?;
    let mut notes = std::mem::take(&mut file.notes);
    let mut body = bodies::bodies(&file, meshes, &mut notes)?;
    let mut half_space: Vec<HalfSpace> = file.planes.iter().map(half_space).collect();
    let pairs = friction::pairs(&file, &mut body, &mut half_space, &mut notes);
    let description = Description {
        duration: Some(file.duration),
        settings: settings(&file, pairs),
        body,
        half_space,
        render: Rendering::default(),
    };
    Ok(Draft { description, notes })
}

fn half_space(plane: &file::Plane) -> HalfSpace {
    HalfSpace::new(plane.point, plane.normal)
}

fn settings(file: &File, pairs: Vec<FrictionPair>) -> Settings {
    let length = |number| {
        if file.is_absolute {
            Length::Absolute(number)
        } else {
            Length::Relative(number)
        }
    };
    Settings {
        time_step: file.time_step,
        gravity: file.gravity,
        integrator: Integrator::ImplicitEuler,
        contact_distance: length(file.contact_distance),
        formulation: Formulation::Sum,
        friction: Friction {
            coefficient: file.friction,
            static_velocity: length(file.static_velocity),
            lags: file.lags,
            pairs,
        },
        tolerance: length(file.tolerance),
        max_iterations: MAX_ITERATIONS,
        ..Settings::default()
    }
}
