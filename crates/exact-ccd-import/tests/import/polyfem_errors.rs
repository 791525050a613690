//! PolyFEM's JSON: errors name the file and the JSON pointer.

use serde_json::json;

use crate::Folder;
use crate::polyfem::scene;

#[test]
fn errors_name_the_pointer() {
    let folder = Folder::new("polyfem-errors");
    let x = json!({ "id": 5, "axis": "-x", "position": 0.01 });
    let held = |value: serde_json::Value| json!({ "dirichlet_boundary": [{ "id": 5, "value": value }] });
    let cases = [
        (
            json!({ "colour": 1 }),
            "/colour: the keyword is unknown to PolyFEM",
        ),
        (
            json!({ "a/b~c": 1 }),
            "/a~1b~0c: the keyword is unknown to PolyFEM",
        ),
        (
            json!({ "geometry": null }),
            "the file: found no key `geometry`, expected this key",
        ),
        (
            json!({ "geometry": { "mesh": "floor.obj", "volume_selection": null } }),
            "/geometry/mesh: found \"floor.obj\", expected a mesh of tetrahedra, or `\"is_obstacle\": true`",
        ),
        (
            json!({
                "geometry": [
                    { "mesh": "box.msh", "volume_selection": 1 },
                    { "mesh": "floor.obj", "is_obstacle": true, "surface_selection": 7 },
                ],
                "boundary_conditions": { "dirichlet_boundary": [{ "id": 7, "value": ["0.1*x*t", 0, 0] }] },
            }),
            "/boundary_conditions/dirichlet_boundary/0/value: exact-ccd has no counterpart of a displacement of an \
             obstacle that depends on the place",
        ),
        (
            json!({ "contact": { "enabled": false } }),
            "the file: exact-ccd has no counterpart of bodies that pass through each other",
        ),
        (
            json!({ "contact": { "use_gcp_formulation": true } }),
            "/contact/use_gcp_formulation: exact-ccd has no counterpart of this value",
        ),
        (
            json!({ "contact": { "dhat": "1 mm" } }),
            "/contact/dhat: found \"1 mm\", expected a number, without a unit",
        ),
        (
            json!({ "time": null }),
            "the file: exact-ccd has no counterpart of a static problem",
        ),
        (json!({ "time": { "dt": null } }), "/time: found {"),
        (
            json!({ "time": { "t0": 1 } }),
            "/time/t0: exact-ccd has no counterpart of this value",
        ),
        (
            json!({ "time": { "integrator": "ImplicitNewmark" } }),
            "/time/integrator: exact-ccd has no counterpart of this time integration",
        ),
        (
            json!({ "units": { "length": "mm" } }),
            "/units/length: exact-ccd has no counterpart of this value",
        ),
        (
            json!({ "space": { "discr_order": 2 } }),
            "/space/discr_order: exact-ccd has no counterpart of this value",
        ),
        (
            json!({ "space": { "remesh": { "enabled": true } } }),
            "/space/remesh: exact-ccd has no counterpart of meshes that change",
        ),
        (
            json!({ "materials": [{ "type": "MooneyRivlin" }] }),
            "/materials/0/type: exact-ccd has no counterpart of this material",
        ),
        (
            json!({ "materials": [{ "type": "NeoHookean", "id": 2, "E": 1, "nu": 0 }] }),
            "/geometry: found tetrahedra with the id 1, which no material has, expected one of the ids of materials (2): ",
        ),
        (
            json!({ "materials": { "type": "NeoHookean", "E": "x", "nu": 0 } }),
            "/materials/E: found \"x\", expected a number",
        ),
        (
            json!({ "solver": { "contact": { "barrier_stiffness": 1e9 } } }),
            "/solver/contact/barrier_stiffness: exact-ccd has no counterpart of this value",
        ),
        (
            json!({ "solver": { "contact": { "friction_iterations": -1 } } }),
            "/solver/contact/friction_iterations: found -1",
        ),
        (
            json!({ "geometry": { "n_refs": 1 } }),
            "/geometry/n_refs: exact-ccd has no counterpart of this value",
        ),
        (
            json!({ "geometry": { "extract": "edges" } }),
            "/geometry/extract: exact-ccd has no counterpart of a part of a mesh",
        ),
        (
            json!({ "geometry": { "mesh": "none.msh" } }),
            "/geometry/mesh: there is no file none.msh in the folder",
        ),
        (
            json!({ "geometry": { "volume_selection": [{ "id": 1, "box": [] }] } }),
            "/geometry/volume_selection: exact-ccd has no counterpart of ids of cells by regions of space",
        ),
        (
            json!({ "geometry": { "transformation": { "rotation": [1, 2] } } }),
            "/geometry/transformation/rotation: found [1,2]",
        ),
        (
            json!({ "geometry": { "surface_selection": { "id": 5, "normal": [0, 0, 0] } } }),
            "/geometry/surface_selection/normal: found [0,0,0], expected a vector of positive length",
        ),
        (
            json!({ "geometry": { "surface_selection": { "id": 5, "radius": 1, "p1": [1, 2, 3], "p2": [1, 2, 3] } } }),
            "/geometry/surface_selection: found {",
        ),
        (
            json!({ "geometry": { "surface_selection": "ids.txt" } }),
            "/geometry/surface_selection: exact-ccd has no counterpart of a selection by a file",
        ),
        (
            json!({ "geometry": { "type": "mesh_sequence" } }),
            "/geometry: exact-ccd has no counterpart of a sequence of meshes",
        ),
        (
            json!({ "boundary_conditions": held(json!([0, 0, 0])) }),
            "/boundary_conditions/dirichlet_boundary/0: exact-ccd has no counterpart of an id that no selection of the file gives",
        ),
        (
            json!({ "geometry": { "surface_selection": x }, "boundary_conditions": held(json!([0, "tan(t)", 0])) }),
            "/boundary_conditions/dirichlet_boundary/0/value/1: exact-ccd has no counterpart of this function",
        ),
        (
            json!({ "geometry": { "surface_selection": x }, "boundary_conditions": held(json!([0, 0])) }),
            "/boundary_conditions/dirichlet_boundary/0/value: found [0,0], expected three numbers or functions of x, y, z, t",
        ),
        (
            json!({ "boundary_conditions": { "periodic_boundary": { "enabled": true } } }),
            "/boundary_conditions/periodic_boundary: exact-ccd has no counterpart of this value",
        ),
        (
            json!({ "initial_conditions": { "solution": [{}] } }),
            "/initial_conditions/solution: exact-ccd has no counterpart of this value",
        ),
        (json!({ "common": "none.json" }), "/common: "),
    ];
    for (index, (patch, expected)) in cases.into_iter().enumerate() {
        let file = format!("{index}.json");
        let error = folder.import(&file, &scene(&patch)).unwrap_err();
        assert!(
            error.starts_with(&format!("{file}, {expected}")),
            "{error}\n{expected}"
        );
    }
}

#[test]
fn a_file_that_is_not_json_is_an_error() {
    let folder = Folder::new("polyfem-text");
    let error = folder.import("scene.json", "{ \"time\": ").unwrap_err();
    assert!(
        error.starts_with("scene.json, the file: EOF while parsing"),
        "{error}"
    );
    folder.write("loop.json", "{ \"common\": \"loop.json\" }");
    let error = folder
        .import("scene.json", "{ \"common\": \"loop.json\" }")
        .unwrap_err();
    assert!(
        error.ends_with("/common: found more files, expected at most 16 files that name each other"),
        "{error}"
    );
}

/// All keys without a counterpart are in one error, up to the first entry without which nothing can be read.
#[test]
fn all_errors_are_reported_at_once() {
    let folder = Folder::new("polyfem-all-errors");
    let patch = json!({ "colour": 1, "constraints": [2], "space": { "discr_order": 2 }, "geometry": { "mesh": "none.msh" } });
    let error = folder.import("scene.json", &scene(&patch)).unwrap_err();
    let lines: Vec<&str> = error.lines().collect();
    let places = ["/colour", "/constraints", "/space/discr_order", "/geometry/mesh"];
    assert_eq!(lines.len(), places.len(), "{error}");
    for place in places {
        let line = format!("scene.json, {place}: ");
        assert!(
            lines.iter().any(|found| found.starts_with(&line)),
            "{place}: {error}"
        );
    }
}
