//! Bodies of `exact-ccd simulate` that are not the usual ones: affine, scripted, particles.

use crate::folder::Folder;

/// The unknowns of an affine body are four nodes, which no file has but the checkpoint.
#[test]
fn nodes_of_affine_bodies_are_in_no_grid() {
    let folder = Folder::new();
    let body = |height: f64| {
        format!(
            "[[body]]\nshape = {{ box = {{ cells = [1, 1, 1], size = [0.5, 0.5, 0.5] }} }}\n\
             affine = {{ density = 1000.0, stiffness = 1e8 }}\ntranslate = [0.0, {height:?}, 0.0]\n"
        )
    };
    folder.write(
        "scene.toml",
        format!("duration = 0.02\n{}{}", body(0.0), body(1.0)),
    );
    let run = folder.run(&["simulate", "scene.toml", "--output", "out"]);
    assert!(
        run.status == 0 && run.stdout.starts_with("16 vertices, 24 faces, "),
        "{run:?}"
    );
    assert_eq!(
        folder.read("out/bodies.csv"),
        "body,name,kind,first_vertex,vertex_count\n0,body-0,affine,0,8\n1,body-1,affine,8,8\n"
    );
    let grid = folder.read("out/vtu/000002.vtu");
    assert!(
        grid.contains("NumberOfPoints=\"16\" NumberOfCells=\"24\""),
        "{}",
        &grid[..400]
    );
    let checkpoint = folder.read("out/checkpoint.json");
    let checkpoint: serde_json::Value = serde_json::from_str(&checkpoint).unwrap();
    assert_eq!(checkpoint["state"]["positions"].as_array().unwrap().len(), 24);
}

/// A plate stops a scripted sphere: the steps did not converge, and the warning says why.
#[test]
fn a_script_that_stays_behind_is_a_warning() {
    let folder = Folder::new();
    let scene = "
duration = 2.0
[settings]
time-step = 1.0
integrator = \"quasi-static\"
gravity = [0.0, 0.0, 0.0]
contact-distance = { absolute = 1e-3 }
[[body]]
shape = { box = { cells = [1, 1, 1], size = [0.5, 0.1, 0.5] } }
solid = { density = 1000.0, young = 1e6, poisson = 0.3 }
[[body]]
shape = { grid = { cells = [1, 1], size = [0.5, 0.5] } }
translate = [0.0, -0.01, 0.0]
[[body]]
shape = { grid = { cells = [1, 1], size = [0.5, 0.5] } }
translate = [0.0, 0.11, 0.0]
script = [{ motion = { moving = { velocity = [0.0, -0.1, 0.0] } } }]
";
    folder.write("scene.toml", scene);
    let run = folder.run(&["simulate", "scene.toml"]);
    assert_eq!(run.status, 0, "{run:?}");
    let warning = "2 of 2 time steps did not converge, the first is 1: there, the motion is not accurate; scripted \
                   vertices stayed up to 0.18 m behind their targets, because something is in their way: ";
    assert!(run.stderr.contains(warning), "{run:?}");
    let run = folder.run(&["simulate", "scene.toml", "--strict"]);
    assert_eq!(run.status, 2, "{run:?}");
}

/// Particles have no faces: their path is one of points, which an audit takes only if it is told so.
#[test]
fn a_path_of_particles_is_one_of_points() {
    let folder = Folder::new();
    let scene = "
duration = 0.05
[[body]]
shape = { points = { counts = [2, 2, 2], size = [1.0, 1.0, 1.0] } }
particles = { density = 1000.0, radius = 0.01 }
";
    folder.write("scene.toml", scene);
    let run = folder.run(&["simulate", "scene.toml", "--output", "out", "--path"]);
    assert_eq!(run.status, 0, "{run:?}");
    assert!(folder.run(&["audit", "out/path"]).error().contains("--points"));
    assert_eq!(folder.run(&["audit", "out/path", "--points"]).status, 0);
}
