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

use super::Draft;
use super::fault::{Fault, Place, Problem};
use super::meshes::Meshes;
use crate::description::Description;
use crate::rendering::Rendering;
use entry::{Entry, IfAbsent, Rule};

const VIEWING: Rule = Rule::Ignored("it concerns the output of PolyFEM");
const NOTHING: Rule = Rule::Only(IfAbsent::Nothing);

/// The keys of the file.
const RULES: [(&str, Rule); 14] = [
    ("geometry", Rule::Said),
    ("materials", Rule::Said),
    ("boundary_conditions", Rule::Said),
    ("initial_conditions", Rule::Said),
    ("contact", Rule::Said),
    ("time", Rule::Said),
    ("solver", Rule::Said),
    ("space", Rule::Said),
    ("units", Rule::Said),
    ("constraints", NOTHING),
    ("preset_problem", NOTHING),
    ("input", NOTHING),
    ("output", VIEWING),
    ("tests", VIEWING),
];

/// The scene in the text of a file in a folder.
pub(super) fn import(text: &str, folder: &Path, meshes: &mut Meshes) -> Result<Draft, Fault> {
    let json: Value = serde_json::from_str(text)
        .map_err(|error| Problem::File(error.to_string()).at(&Place::Pointer(String::new())))?;
    let json = inherited::resolved(json, folder)?;
    let root = Entry::new(&json);
    let mut notes = Vec::new();
    root.check(&RULES, &mut notes)?;
    settings::check_units_and_space(&root, &mut notes)?;
    let time = settings::time(&root, &mut notes)?;
    let conditions = boundary::Conditions::parse(&root, &time, &mut notes)?;
    let scene = geometry::Geometry::parse(&root, &conditions, meshes, &mut notes)?;
    conditions.check_use()?;
    let settings = settings::settings(&root, &time, conditions.gravity, scene.shortest_edge, &mut notes)?;
    let description = Description {
        duration: Some(time.duration),
        settings,
        body: scene.bodies,
        half_space: scene.half_spaces,
        render: Rendering::default(),
    };
    Ok(Draft { description, notes })
}
