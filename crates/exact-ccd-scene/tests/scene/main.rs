//! Scene files and their errors.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod affine;
mod bodies;
mod errors;
mod groups;

use std::path::Path;
use std::sync::Arc;

use exact_ccd_methods::parity::RootParity;
use exact_ccd_scene::Scene;
use exact_ccd_sim::{Settings, StepFilter, System};

const SCENE: &str = r#"
duration = 0.1

[settings]
time-step = 0.02
gravity = [0.0, 0.0, -9.81]
integrator = "bdf2"
contact-distance = { absolute = 1e-3 }
tolerance = { relative = 1e-3 }
max-iterations = 50
ccd = "parity"

[settings.friction]
coefficient = 0.2
static-velocity = { absolute = 1e-3 }
lags = 2

[[body]]
shape = { box = { cells = [1, 2, 1], size = [1.0, 2.0, 1.0] } }
solid = { density = 1000.0, young = 1e6, poisson = 0.4, energy = "stable-neo-hookean" }
scale = 0.5
rotate = { axis = [1.0, 0.0, 0.0], degrees = 90.0 }
translate = [0.0, 0.0, 3.0]
velocity = [0.0, 1.0, 0.0]

[[body]]
shape = { grid = { cells = [2, 1], size = [2.0, 1.0] } }
shell = { density = 300.0, young = 1e5, poisson = 0.3, thickness = 1e-3 }

[[body.script]]
vertices = { box = { lower = [-0.1, -0.1, -0.1], upper = [0.1, 0.1, 2.0] } }
motion = { twisting = { center = [0.0, 0.0, 0.5], axis = [1.0, 0.0, 0.0], rate = 2.0 } }

[[body.script]]
vertices = { box = { lower = [1.9, -0.1, -0.1], upper = [2.1, 0.1, 2.0] } }
motion = "fixed"

[[body]]
shape = { grid = { cells = [1, 1], size = [9.0, 9.0] } }
translate = [0.0, -1.0, 0.0]
"#;

fn filter(settings: &mut Settings, _: &System) -> Result<StepFilter, String> {
    match &settings.ccd[..] {
        "exact" => Ok(StepFilter::default()),
        name @ "parity" => Ok(StepFilter::new(name, Arc::new(RootParity::default()))),
        name => Err(format!("there is no method `{name}`")),
    }
}

fn parse(text: &str) -> Result<Scene, String> {
    Scene::parse(text, Path::new("scene.toml"), None, &filter).map_err(|error| error.to_string())
}

#[test]
fn a_scene_file_determines_system_settings_and_steps() {
    let scene = parse(SCENE).unwrap();
    assert_eq!(scene.steps, 5);
    let mut simulation = scene.simulation;
    let start = simulation.system().start().to_vec();
    assert_eq!(start.len(), 12 + 6 + 4);
    // The scale gives (0.5, 1, 0.5), the rotation (0.5, −0.5, 1).
    let corner = start[11];
    assert!(
        (0..3).all(|axis| (corner[axis] - [0.5, -0.5, 4.0][axis]).abs() < 1e-12),
        "{corner:?}"
    );
    assert!((simulation.system().masses()[..12].iter().sum::<f64>() - 250.0).abs() < 1e-9);
    let free: Vec<usize> = (12..22)
        .filter(|&vertex| simulation.system().is_free(vertex))
        .collect();
    assert_eq!(free, [13, 16]);

    let statistics = simulation.step().unwrap();
    assert_eq!(statistics.script_lag, 0.0);
    let turned = simulation.state().positions[12];
    assert!((turned[1] - 0.5 * 0.04_f64.sin()).abs() < 1e-12, "{turned:?}");
    assert_eq!(simulation.state().positions[14], start[14]);
}

/// A script along x leaves y and z free, and the last script of each axis counts.
#[test]
fn scripts_act_along_the_axes_of_the_scene_file() {
    let with = |keys: &str| parse(&SCENE.replace("motion = \"fixed\"", keys)).unwrap();
    let moving = "motion = { moving = { velocity = [0.5, 0.0, 0.0] } }\naxes = [\"x\"]";
    let scene = with(moving);
    assert!(scene.simulation.system().is_free(14));
    let mut simulation = scene.simulation;
    simulation.step().unwrap();
    let (now, start) = (simulation.state().positions[14], simulation.system().start()[14]);
    assert!((now[0] - start[0] - 0.01).abs() < 1e-12, "{now:?}");
    assert!(now[2] < start[2] - 1e-3, "{now:?}");
    // Released at once, the vertices move as without scripts.
    let scene = with("motion = \"fixed\"\nrelease = 0.0");
    assert!(scene.simulation.system().is_free(14));
}

/// The scene of the documentation has every key.
#[test]
fn the_scene_of_the_documentation_is_valid() {
    let documentation = include_str!("../../../../docs/scenes.md");
    let (_, rest) = documentation.split_once("```toml\n").unwrap();
    let (text, _) = rest.split_once("```").unwrap();
    let mut scene = parse(text).unwrap();
    assert_eq!(scene.steps, 50);
    // Its settings are the default values, but for a pair of bodies with friction.
    let mut settings = scene.simulation.settings().clone();
    assert_eq!(settings.friction.pairs.len(), 1);
    settings.friction.pairs.clear();
    assert_eq!(settings, Settings::default());
    assert_eq!(
        scene.simulation.system().names(),
        ["block", "", "", "", "ring", "", "ground"]
    );
    scene.simulation.step().unwrap();
}
