//! Imported scenes of tutorial size run, and are free of contact.

use exact_ccd_mesh::{Aabb, Bvh, IntersectionOptions, Point, intersections, step};
use exact_ccd_scene::Scene;
use serde_json::json;

use crate::Folder;

/// Takes some steps of a scene. Checks that each increment is free of contact. The result is the final
/// positions.
fn run(scene: Scene, steps: usize) -> Vec<Point> {
    let surface = scene.simulation.system().surface().clone();
    let mut simulation = scene.simulation;
    let mut at = simulation.state().positions.clone();
    let mut contacts = 0;
    for _ in 0..steps {
        let statistics = simulation.step_along(&mut |positions: &[Point]| {
            assert!(step(&surface, &at, positions).unwrap().is_free());
            at = positions.to_vec();
        });
        let statistics = statistics.unwrap();
        assert!(statistics.converged, "{statistics:?}");
        contacts += statistics.contacts;
    }
    let touching = IntersectionOptions::default();
    assert!(intersections(&surface, &at, &Bvh, &touching).unwrap().is_empty());
    assert!(contacts > 0);
    at
}

/// A box falls on another one, which is held at one side above the ground, until it is released.
#[test]
fn a_text_scene_of_ipc() {
    let folder = Folder::new("run");
    let text = "shapes input 3\n\
                box.msh 0 1.2 0  0 0 0  1 1 1  initVel 0 -2 0  0 0 0\n\
                box.msh 0 0.1 0  0 0 0  1 1 1 \\\n\
                DBC 0 0 0  0 1 1  0 0 0  0 0 0  0 0.1\n\
                floor.obj -0.5 2.5 0.5  0 0 0  0.6 1 0.6  linearVelocity 0 -1 0  # comes down\n\
                selfFric 0.1\nground 0.1 0\ntime 0.3 0.02\nview perspective\n";
    let (scene, notes) = folder.scene_with_notes("scene.txt", text).unwrap();
    assert_eq!(scene.steps, 15);
    assert_eq!(notes.len(), 1);
    let end = run(scene, 15);
    let bounds: Aabb = end[..54].iter().copied().collect();
    assert!(bounds.lower[1] > 0.0, "{bounds:?}");
    // The box that was held has fallen.
    assert!(end[27][1] < 0.09, "{:?}", end[27]);
}

/// A box falls on another one, whose lowest face is held along x and y.
#[test]
fn a_scene_of_polyfem() {
    let folder = Folder::new("run-polyfem");
    let bottom = json!({ "id": 3, "axis": "-y", "position": 0.01 });
    let scene = json!({
        "geometry": [
            { "mesh": "box.msh", "volume_selection": 1, "surface_selection": bottom },
            { "mesh": "box.msh", "volume_selection": 2, "transformation": { "translation": [0.1, 1.01, 0.1] } },
            { "mesh": "floor.obj", "is_obstacle": true, "transformation": { "translation": [0, -0.5, 0] } },
        ],
        "materials": [{ "type": "NeoHookean", "id": [1, 2], "E": 1e5, "nu": 0.4, "rho": 1000 }],
        "contact": { "enabled": true, "friction_coefficient": 0.2 },
        "time": { "tend": 0.2, "dt": 0.02 },
        "boundary_conditions": {
            "rhs": [0, 9.81, 0],
            "dirichlet_boundary": [{ "id": 3, "value": [0, 0, 0], "dimension": [true, true, false] }],
        },
        "initial_conditions": { "velocity": [{ "id": 2, "value": [0, -1, 0] }] },
    });
    let scene = folder.scene("scene.json", &scene.to_string()).unwrap();
    assert_eq!(scene.steps, 10);
    let start = scene.simulation.system().start().to_vec();
    let end = run(scene, 10);
    for vertex in (0..27).filter(|&vertex| start[vertex][1] == 0.0) {
        assert_eq!(end[vertex][..2], start[vertex][..2]);
    }
}
