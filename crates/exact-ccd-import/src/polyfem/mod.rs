//! PolyFEM's JSON.
//!
//! Source of the format: PolyFEM (github.com/polyfem/polyfem, version of June 2026): `json-specs` for keys
//! and default values, `GeometryReader.cpp` for the placement of meshes and for obstacles, `MshReader.cpp`
//! for the ids of cells in mesh files, `Selection.cpp` for selections, `JSONUtils.cpp` for `common` and for
//! rotations, `RhsAssembler.cpp` for signs, and `NonlinearElasticVarForm.cpp` for the contact distance.

mod boundary;
mod entry;
mod expression;
mod geometry;
mod inherited;
mod material;
mod motion;
mod region;
mod settings;
mod surface;
mod transformation;
mod volume;

use std::path::Path;

use serde_json::Value;

use crate::fault::{Fault, Place, Problem};
use crate::meshes::Meshes;
use crate::notes::Notes;
use entry::{Entry, NOTHING, Rule};
use exact_ccd_scene::Rendering;
use exact_ccd_scene::description::Description;

const VIEWING: Rule = Rule::Ignored("it concerns the output of PolyFEM");

/// The keys of the file.
const RULES: [(&str, Rule); 3] = [
    (
        "geometry materials boundary_conditions initial_conditions contact time solver space units",
        Rule::Said,
    ),
    ("constraints preset_problem input", NOTHING),
    ("output tests", VIEWING),
];

/// The scene in the text of a file in a folder.
pub(super) fn import(
    text: &str,
    folder: &Path,
    meshes: &mut Meshes,
    notes: &Notes,
) -> Result<Description, Fault> {
    let json: Value = serde_json::from_str(text)
        .map_err(|error| Problem::File(error.to_string()).at(&Place::Pointer(String::new())))?;
    let json = inherited::resolved(json, folder)?;
    let root = Entry::new(&json, notes);
    root.check(&RULES)?;
    settings::check_units_and_space(&root)?;
    let time = settings::time(&root)?;
    let conditions = boundary::Conditions::parse(&root, &time)?;
    let scene = geometry::Geometry::parse(&root, &conditions, meshes)?;
    conditions.check_use()?;
    Ok(Description {
        spring: Vec::new(),
        duration: Some(time.duration),
        settings: settings::settings(&root, &time, conditions.gravity, scene.shortest_edge)?,
        body: scene.bodies,
        half_space: scene.half_spaces,
        render: Rendering::default(),
    })
}
