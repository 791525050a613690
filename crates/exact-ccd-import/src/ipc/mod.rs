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

use exact_ccd_mesh::HalfSpace;
use exact_ccd_sim::Length;

use crate::fault::Fault;
use crate::meshes::Meshes;
use crate::notes::Notes;
use exact_ccd_scene::Rendering;
use exact_ccd_scene::description::Description;
use file::File;

/// The scene in the text of a file.
pub(super) fn import(text: &str, meshes: &mut Meshes, notes: &Notes) -> Result<Description, Fault> {
    let file = File::parse(text, notes)?;
    let (mut body, size) = bodies::bodies(&file, meshes, notes)?;
    let mut half_space: Vec<HalfSpace> = file.planes.iter().map(|(plane, _)| plane.clone()).collect();
    let pairs = friction::pairs(&file, &mut body, &mut half_space, notes);
    let stiffness_damping = file.stiffness_damping();
    let mut settings = file.settings;
    settings.stiffness_damping = stiffness_damping;
    settings.friction.pairs = pairs;
    // The diagonal of a box along the axes is not the size of exact-ccd. Without solids, nothing moves.
    let unit = if file.is_absolute { 1.0 } else { size };
    if unit > 0.0 {
        let lengths = [
            &mut settings.contact_distance,
            &mut settings.friction.static_velocity,
            &mut settings.tolerance,
        ];
        for length in lengths {
            *length = Length::Absolute(length.meters(unit));
        }
    }
    Ok(Description {
        spring: Vec::new(),
        duration: Some(file.duration),
        settings,
        body,
        half_space,
        render: Rendering::default(),
    })
}
