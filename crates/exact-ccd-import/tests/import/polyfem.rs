//! PolyFEM's JSON: keys and their meaning.

use exact_ccd_mesh::Point;
use serde_json::{Value, json};

use crate::Folder;
use crate::imported::{assert_lines, assert_placed, has};

/// A scene with one body, changed by a merge patch.
pub(crate) fn scene(patch: &Value) -> String {
    let mut scene = json!({
        "geometry": { "mesh": "box.msh", "transformation": { "translation": [0, 1, 0] }, "volume_selection": 1 },
        "materials": [{ "type": "NeoHookean", "id": 1, "E": 1e5, "nu": 0.4, "rho": 1000 }],
        "contact": { "enabled": true },
        "time": { "tend": 1, "dt": 0.1 },
        "boundary_conditions": { "rhs": [0, 9.81, 0] },
    });
    merge(&mut scene, patch);
    scene.to_string()
}

fn merge(target: &mut Value, patch: &Value) {
    match (target, patch) {
        (Value::Object(target), Value::Object(patch)) => {
            for (key, value) in patch {
                merge(target.entry(key).or_insert(Value::Null), value);
            }
        }
        (target, patch) => patch.clone_into(target),
    }
}

#[test]
fn a_scene_has_the_defaults_of_polyfem() {
    let folder = Folder::new("polyfem-defaults");
    let imported = folder.import("scene.json", &scene(&json!({}))).unwrap();
    let expected = r#"# Imported from scene.json, a scene of PolyFEM.
duration = 1.0

[settings]
time-step = 0.1
gravity = [0.0, -9.81, 0.0]
integrator = "implicit-euler"
damping = 0.0
formulation = "sum"
line-search = "common"
max-iterations = 500
max-substeps = 8
ccd = "exact"

[settings.contact-distance]
absolute = 0.001

[settings.friction]
coefficient = 0.0
lags = 1

[settings.friction.static-velocity]
absolute = 0.001

[settings.tolerance]
relative = 0.01

[[body]]
mesh = "box.msh"
translate = [0.0, 1.0, 0.0]

[body.solid]
density = 1000.0
young = 100000.0
poisson = 0.4
energy = "neo-hookean"
"#;
    assert_eq!(imported.toml, expected);
    assert!(imported.notes.is_empty(), "{:?}", imported.notes);
}

#[test]
fn each_key_changes_its_setting() {
    let folder = Folder::new("polyfem-keys");
    let cases = [
        (
            json!({ "time": { "time_steps": 20, "dt": null } }),
            "duration = 1.0\n[settings]\ntime-step = 0.05",
        ),
        (
            json!({ "time": { "time_steps": 20, "tend": null } }),
            "duration = 2.0\n[settings]\ntime-step = 0.1",
        ),
        (
            json!({ "time": { "integrator": "BDF2" } }),
            "integrator = \"bdf2\"",
        ),
        (
            json!({ "time": { "integrator": { "type": "BDF", "steps": 2 } } }),
            "integrator = \"bdf2\"",
        ),
        (
            json!({ "time": { "quasistatic": true } }),
            "integrator = \"quasi-static\"",
        ),
        (
            json!({ "contact": { "dhat": 0.01 } }),
            "[settings.contact-distance]\nabsolute = 0.01",
        ),
        (
            json!({ "contact": { "epsv": 0.25 } }),
            "[settings.friction.static-velocity]\nabsolute = 0.25",
        ),
        (
            json!({ "contact": { "friction_coefficient": 0.5 } }),
            "coefficient = 0.5",
        ),
        (
            json!({ "contact": { "use_convergent_formulation": true } }),
            "formulation = \"convergent\"",
        ),
        (
            json!({ "solver": { "contact": { "friction_iterations": 3 } } }),
            "lags = 3",
        ),
        (
            json!({ "contact": { "adhesion": { "adhesion_enabled": false } } }),
            "formulation = \"sum\"",
        ),
        (
            json!({ "boundary_conditions": { "periodic_boundary": { "enabled": false } } }),
            "formulation = \"sum\"",
        ),
        (
            json!({ "boundary_conditions": { "rhs": [1, 0, "2"] } }),
            "gravity = [-1.0, 0.0, -2.0]",
        ),
        (
            json!({ "materials": { "type": "NeoHookean", "lambda": 1, "mu": 1 } }),
            "density = 1.0\nyoung = 2.5\npoisson = 0.25",
        ),
        (
            json!({ "initial_conditions": { "velocity": [{ "id": 1, "value": [1, 2, 3] }] } }),
            "velocity = [1.0, 2.0, 3.0]",
        ),
        (
            json!({ "geometry": { "transformation": { "scale": 0.5, "rotation": [0, 90, 0] } } }),
            "scale = 0.5\ntranslate = [0.0, 1.0, 0.0]",
        ),
        (
            json!({ "geometry": { "transformation": { "dimensions": [1, 1, 3] } } }),
            "scale = [2.0, 1.0, 2.0]",
        ),
        (
            json!({ "geometry": { "transformation": { "rotation": [30, 0, 0, 2], "rotation_mode": "axis_angle" } } }),
            "[body.rotate]\naxis = [0.0, 0.0, 2.0]\ndegrees = 30.0",
        ),
        (
            json!({ "geometry": { "transformation": { "rotation": 30, "rotation_mode": "z" } } }),
            "[body.rotate]\naxis = [0.0, 0.0, 1.0]\ndegrees = 30.0",
        ),
    ];
    let cases = cases.map(|(patch, lines)| (scene(&patch), lines));
    assert_lines(&folder, "json", cases);
}

/// `xyz` is a rotation about x, then about y, then about z.
#[test]
fn angles_are_in_the_order_of_their_mode() {
    let folder = Folder::new("polyfem-angles");
    let patch = json!({ "geometry": { "transformation": { "rotation": [90, 0, 90] } } });
    let scene = folder.scene("scene.json", &scene(&patch)).unwrap();
    // About x: (x, −z, y); then about z: (z, x, y).
    assert_placed(&scene, |[x, y, z]| [z, x + 1.0, y]);
}

#[test]
fn obstacles_planes_and_arrays_are_imported() {
    let folder = Folder::new("polyfem-geometry");
    let geometry = json!([
        { "mesh": "box.msh", "volume_selection": 1 },
        { "type": "mesh_array", "mesh": "box.msh", "volume_selection": 1,
          "transformation": { "translation": [0, 3, 0] },
          "array": { "offset": 2, "size": [1, 2, 1], "relative": true } },
        { "mesh": "floor.obj", "is_obstacle": true, "surface_selection": 7 },
        { "mesh": "floor.obj", "is_obstacle": true, "enabled": false },
        { "type": "plane", "is_obstacle": true, "point": [0, -2, 0], "normal": [1, 2, 0] },
        { "type": "ground", "is_obstacle": true, "height": -3 },
    ]);
    let conditions = json!({ "obstacle_displacements": [{ "id": 7, "value": [0, "-0.5*t", 0] }] });
    let patch = json!({ "geometry": geometry, "boundary_conditions": conditions });
    let imported = folder.import("scene.json", &scene(&patch)).unwrap();
    for lines in [
        "[[body]]\nmesh = \"box.msh\"\ntranslate = [0.0, 3.0, 0.0]",
        // The box is 1 m high.
        "[[body]]\nmesh = \"box.msh\"\ntranslate = [0.0, 5.0, 0.0]",
        "[[body]]\nmesh = \"floor.obj\"\n[[body.script]]\n[body.script.motion.key-frames]",
        "[[half-space]]\npoint = [0.0, -2.0, 0.0]\nnormal = [1.0, 2.0, 0.0]",
        "[[half-space]]\npoint = [0.0, -3.0, 0.0]\nnormal = [0.0, 1.0, 0.0]",
    ] {
        assert!(has(&imported, lines), "{lines}: {}", imported.toml);
    }
    assert_eq!(imported.toml.matches("[[body]]").count(), 4);
}

/// The faces whose centers are in a region, with all their corners.
#[test]
fn regions_select_faces() {
    let folder = Folder::new("polyfem-regions");
    let all = [
        json!({ "id": 5, "axis": "-x", "position": 0.01 }),
        json!({ "id": 5, "axis": -1, "position": 0.01, "relative": true }),
        json!({ "id": 5, "box": [[-0.1, 0, 0], [0.01, 3, 3]] }),
        json!({ "id": 5, "box": [[-0.1, 0, 0], [0.1, 1, 1]], "relative": true }),
        json!({ "id": 5, "point": [0, 0, 0], "normal": [-1, 0, 0] }),
        json!({ "id": 5, "p1": [-1, 1.5, 0.75], "p2": [0.01, 1.5, 0.75], "radius": 2 }),
        json!([{ "id": 4, "axis": 1, "position": 0.01 }, 5]),
        json!({ "threshold": 1e-3, "id_offset": 4 }),
    ];
    for (index, selection) in all.into_iter().enumerate() {
        let conditions = json!({ "dirichlet_boundary": [{ "id": 5, "value": [0, 0, 0] }] });
        let patch =
            json!({ "geometry": { "surface_selection": selection }, "boundary_conditions": conditions });
        let imported = folder.import(&format!("{index}.json"), &scene(&patch)).unwrap();
        let lines = "[[body.script]]\nmotion = \"fixed\"\n[body.script.vertices.box]\n\
                     lower = [0.0, 1.0, 0.0]\nupper = [0.0, 2.0, 1.5]";
        assert!(has(&imported, lines), "{selection}: {}", imported.toml);
    }
}

/// A prescribed displacement is the value of the function at the end of each time step.
#[test]
fn displacements_are_functions_of_time() {
    let folder = Folder::new("polyfem-motion");
    let selection = json!({ "id": 5, "axis": "-x", "position": 0.01 });
    let value = json!([
        "min(0.5*t, 0.1)",
        "0.1 * sin(pi * t / 2)",
        "-(t - 2) * t / 10 + 0"
    ]);
    let conditions = json!({ "rhs": [0, 0, 0], "dirichlet_boundary": [{ "id": 5, "value": value }] });
    let patch = json!({ "geometry": { "surface_selection": selection }, "boundary_conditions": conditions });
    let scene = folder.scene("scene.json", &scene(&patch)).unwrap();
    let start: Point = scene.simulation.system().start()[0];
    assert!(!scene.simulation.system().is_free(0));
    let mut simulation = scene.simulation;
    for step in 1..=10 {
        assert_eq!(simulation.step().unwrap().script_lag, 0.0);
        let t = f64::from(step) * 0.1;
        let displacement = [
            f64::min(0.5 * t, 0.1),
            0.1 * (core::f64::consts::FRAC_PI_2 * t).sin(),
            (2.0 - t) * t / 10.0,
        ];
        let position = simulation.state().positions[0];
        let error = (0..3).map(|axis| (position[axis] - start[axis] - displacement[axis]).abs());
        assert!(error.fold(0.0, f64::max) < 1e-12, "{position:?}");
    }
}

/// Functions of the place move each vertex in its own way, and `if` chooses by the sign of its first
/// argument. Two conditions can hold common vertices along different axes, or by the same motion.
#[test]
fn displacements_are_functions_of_place() {
    let folder = Folder::new("polyfem-places");
    let selection =
        json!([{ "id": 5, "axis": "-x", "position": 0.01 }, { "id": 6, "axis": "x", "position": 0.01 }]);
    let moved = json!({ "id": 5, "value": ["if(t - 0.3, 0.2 * y * t, 0)", 0, "0"], "dimension": [true, false, false] });
    let held = json!({ "id": "all", "value": ["x", "x * 0", 0], "dimension": [false, true, false] });
    let conditions = json!({ "rhs": [0, 0, 0], "dirichlet_boundary": [moved, held] });
    let patch = json!({ "geometry": { "surface_selection": selection }, "boundary_conditions": conditions });
    let scene = folder.scene("scene.json", &scene(&patch)).unwrap();
    let start = scene.simulation.system().start().to_vec();
    let left: Vec<usize> = (0..start.len())
        .filter(|&vertex| start[vertex][0] < 0.01)
        .collect();
    assert!(left.len() > 2);
    let mut simulation = scene.simulation;
    for step in 1..=5 {
        simulation.step().unwrap();
        let t = f64::from(step) * 0.1;
        for &vertex in &left {
            let [x, y, _] = start[vertex];
            let expected = if step >= 3 { x + 0.2 * y * t } else { x };
            let found = simulation.state().positions[vertex];
            assert!(
                (found[0] - expected).abs() < 1e-12,
                "{step}: {found:?}, expected {expected}"
            );
            assert!((found[1] - y).abs() < 1e-15);
        }
    }
}

#[test]
fn materials_are_imported() {
    let folder = Folder::new("polyfem-materials");
    for (name, energy) in [
        ("SaintVenant", "saint-venant-kirchhoff"),
        ("FixedCorotational", "fixed-corotated"),
    ] {
        let patch = json!({ "materials": [{ "type": name, "id": 1, "E": 1e5, "nu": 0.4, "rho": 1000 }] });
        let imported = folder.import("scene.json", &scene(&patch)).unwrap();
        assert!(
            has(&imported, &format!("energy = \"{energy}\"")),
            "{}",
            imported.toml
        );
    }
}

#[test]
fn dimensions_and_forces_are_imported() {
    let folder = Folder::new("polyfem-conditions");
    let selection = json!({ "threshold": 1e-3 });
    let conditions = json!({
        "dirichlet_boundary": { "id": 1, "value": [0, 0, 0], "dimension": [true, false, true] },
        "neumann_boundary": [{ "id": 4, "value": [0, 10, 0] }],
        "pressure_boundary": [{ "id": 3, "value": -20 }],
    });
    let patch = json!({ "geometry": { "surface_selection": selection }, "boundary_conditions": conditions });
    let imported = folder.import("scene.json", &scene(&patch)).unwrap();
    for lines in [
        "[[body.script]]\nmotion = \"fixed\"\naxes = [\"x\", \"z\"]\n[body.script.vertices.box]",
        "[body.load.force]\ntraction = [0.0, 10.0, 0.0]",
        "[body.load.force]\npressure = 20.0",
    ] {
        assert!(has(&imported, lines), "{lines}: {}", imported.toml);
    }
}

/// Without `dhat`, the contact distance is at most 0.8 of the shortest edge.
#[test]
fn the_contact_distance_depends_on_the_shortest_edge() {
    let folder = Folder::new("polyfem-dhat");
    // Cells have edges of 0.25, 0.5 and 0.75 m.
    let patch = json!({ "geometry": { "transformation": { "scale": 1e-3 } } });
    let imported = folder.import("scene.json", &scene(&patch)).unwrap();
    assert!(
        has(&imported, "[settings.contact-distance]\nabsolute = 0.0002"),
        "{}",
        imported.toml
    );
}

#[test]
fn common_files_are_merged() {
    let folder = Folder::new("polyfem-common");
    folder.write(
        "base.json",
        &json!({ "time": { "tend": 3, "dt": 0.5 }, "contact": { "dhat": 0.02 } }).to_string(),
    );
    folder.write(
        "common.json",
        &json!({ "common": "base.json", "contact": { "epsv": 0.3 } }).to_string(),
    );
    let imported = folder
        .import("scene.json", &scene(&json!({ "common": "common.json" })))
        .unwrap();
    assert!(
        has(&imported, "duration = 1.0\n[settings]\ntime-step = 0.1"),
        "{}",
        imported.toml
    );
    assert!(
        has(&imported, "[settings.contact-distance]\nabsolute = 0.02"),
        "{}",
        imported.toml
    );
    assert!(
        has(&imported, "[settings.friction.static-velocity]\nabsolute = 0.3"),
        "{}",
        imported.toml
    );
}

#[test]
fn what_concerns_output_or_methods_is_a_note() {
    let folder = Folder::new("polyfem-notes");
    let patch = json!({
        "output": { "json": "sim.json" },
        "solver": { "linear": { "solver": "x" }, "nonlinear": { "max_iterations": 7 } },
    });
    let imported = folder.import("scene.json", &scene(&patch)).unwrap();
    let notes: Vec<String> = imported
        .notes
        .iter()
        .map(|note| format!("{}: {}", note.place, note.message))
        .collect();
    assert_eq!(
        notes,
        [
            "/output: ignored: it concerns the output of PolyFEM",
            "/solver/linear: ignored: it concerns the method by which PolyFEM solves a time step",
            "/solver/nonlinear: ignored but for `max_iterations`: the tolerance of Newton's method is a velocity here",
        ]
    );
    assert!(has(&imported, "max-iterations = 7"), "{}", imported.toml);
}
