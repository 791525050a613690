//! Scene files, and what is wrong with them.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;

use exact_ccd_sim::scene::Scene;

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

fn parse(text: &str) -> Result<Scene, String> {
    Scene::parse(text, Path::new("scene.toml"), None).map_err(|error| error.to_string())
}

/// The error of the scene with a line replaced.
fn error_with(from: &str, to: &str) -> String {
    assert!(SCENE.contains(from), "{from}");
    parse(&SCENE.replace(from, to)).err().unwrap()
}

#[test]
fn a_scene_is_what_it_says() {
    let scene = parse(SCENE).unwrap();
    assert_eq!(scene.steps, 5);
    let start = scene.system.start();
    assert_eq!(start.len(), 12 + 6 + 4);
    // (0.5, 1, 0.5) after the scale, turned to (0.5, −0.5, 1).
    let corner = start[11];
    assert!(
        (0..3).all(|axis| (corner[axis] - [0.5, -0.5, 4.0][axis]).abs() < 1e-12),
        "{corner:?}"
    );
    assert!((scene.system.masses()[..12].iter().sum::<f64>() - 250.0).abs() < 1e-9);
    let free: Vec<usize> = (12..22).filter(|&vertex| scene.system.is_free(vertex)).collect();
    assert_eq!(free, [13, 16]);

    let mut simulation = scene.simulation().unwrap();
    let statistics = simulation.step().unwrap();
    assert_eq!(statistics.script_lag, 0.0);
    let turned = simulation.state().positions[12];
    assert!((turned[1] - 0.5 * 0.04_f64.sin()).abs() < 1e-12, "{turned:?}");
    assert_eq!(simulation.state().positions[14], start[14]);
}

#[test]
fn errors_name_file_line_and_field() {
    let cases = [
        (
            "duration = 0.1",
            "",
            "scene.toml, line 1, the file: missing field `duration`",
        ),
        (
            "time-step = 0.02",
            "time-step = -1.0",
            "scene.toml, line 5, settings.time-step: `time-step` is -1, expected a positive number",
        ),
        (
            "max-iterations = 50",
            "max-iterations = \"many\"",
            "scene.toml, line 10, settings.max-iterations: invalid type: string \"many\", expected usize",
        ),
        (
            "coefficient = 0.2",
            "coefficient = -0.2",
            "scene.toml, line 14, settings.friction.coefficient: `friction.coefficient` is -0.2, expected a number not below 0",
        ),
        (
            "young = 1e6, poisson = 0.4",
            "young = 1e6, poisson = 0.5",
            "scene.toml, line 20, body[0].solid.poisson: Poisson's ratio is 0.5, expected a number in [0, 0.5)",
        ),
        (
            "density = 300.0",
            "density = 0.0",
            "scene.toml, line 28, body[1].shell.density: the density is 0, expected a positive number",
        ),
        (
            "shape = { grid = { cells = [1, 1], size = [9.0, 9.0] } }",
            "mesh = \"missing.obj\"",
            "scene.toml, line 39, body[2].mesh: ",
        ),
        (
            "shape = { grid = { cells = [1, 1], size = [9.0, 9.0] } }",
            "shape = { sphere = { subdivisions = 7, radius = 1.0 } }",
            "scene.toml, line 39, body[2].shape: 7 subdivisions, expected at most 6",
        ),
        (
            "lower = [1.9,",
            "lower = [2.05,",
            "scene.toml, line 35, body[1].script[1].vertices: no vertex of the body is there: placed, it goes from \
             [0.0, 0.0, 0.0] to [2.0, 0.0, 1.0]",
        ),
    ];
    assert_errors(&cases);
}

#[test]
fn numbers_out_of_range_are_told_at_their_field() {
    let cases = [
        (
            "time-step = 0.02",
            "time-step = 0.0",
            "scene.toml, line 5, settings.time-step: `time-step` is 0, expected a positive number",
        ),
        (
            "time-step = 0.02",
            "time-step = nan",
            "scene.toml, line 5, settings.time-step: `time-step` is NaN, expected a positive number",
        ),
        (
            "contact-distance = { absolute = 1e-3 }",
            "contact-distance = { absolute = 1e160 }",
            "scene.toml, line 8, settings.contact-distance: `contact-distance` is 1000",
        ),
        (
            "contact-distance = { absolute = 1e-3 }",
            "contact-distance = { absolute = 1e-160 }",
            "scene.toml, line 8, settings.contact-distance: `contact-distance` is 0.000",
        ),
        (
            "max-iterations = 50",
            "max-iterations = 0",
            "scene.toml, line 10, settings.max-iterations: `max-iterations` is 0, expected 1 at least",
        ),
        // So heavy that the barrier would have to be infinitely stiff.
        (
            "density = 1000.0",
            "density = 1e308",
            "scene.toml, line 8, settings.contact-distance: `contact-distance` is 0.001, expected a length with which",
        ),
        (
            "density = 300.0",
            "density = 1e-320",
            "scene.toml, line 28, body[1].shell.density: element 0 has a mass of 0",
        ),
        (
            "axis = [1.0, 0.0, 0.0], degrees",
            "axis = [0.0, 0.0, 0.0], degrees",
            "scene.toml, line 22, body[0].rotate: the axis has no direction",
        ),
        (
            "velocity = [0.0, 1.0, 0.0]",
            "velocity = [0.0, nan, 0.0]",
            "scene.toml, line 24, body[0].velocity: the velocity is [0.0, NaN, 0.0], expected finite numbers",
        ),
        (
            "translate = [0.0, -1.0, 0.0]",
            "translate = [0.0, -1.0, 0.0]\nvelocity = [1.0, 0.0, 0.0]",
            "scene.toml, line 41, body[2].velocity: the velocity is [1.0, 0.0, 0.0], expected none",
        ),
        (
            "axis = [1.0, 0.0, 0.0], rate",
            "axis = [0.0, 0.0, 0.0], rate",
            "scene.toml, line 32, body[1].script[0].motion.twisting.axis: ",
        ),
        (
            "rate = 2.0",
            "rate = inf",
            "scene.toml, line 32, body[1].script[0].motion.twisting.rate: ",
        ),
        (
            "rate = 2.0",
            "rate = 2.0, until = -1.0",
            "scene.toml, line 32, body[1].script[0].motion.twisting.until: ",
        ),
        (
            "motion = \"fixed\"",
            "motion = { moving = { velocity = [nan, 0.0, 0.0] } }",
            "scene.toml, line 36, body[1].script[1].motion.moving.velocity: ",
        ),
        (
            "grid = { cells = [1, 1], size = [9.0, 9.0] }",
            "grid = { cells = [2000, 2000], size = [9.0, 9.0] }",
            "scene.toml, line 39, body[2].shape: 4000000 cells, expected 1 at least and 1048576 at most",
        ),
        (
            "grid = { cells = [1, 1], size = [9.0, 9.0] }",
            "grid = { cells = [0, 4], size = [9.0, 9.0] }",
            "scene.toml, line 39, body[2].shape: 0 cells, expected 1 at least",
        ),
        // An obstacle without volume has no surface.
        (
            "grid = { cells = [1, 1], size = [9.0, 9.0] }",
            "box = { cells = [1, 1, 1], size = [9.0, 0.0, 9.0] }",
            "scene.toml, line 39, body[2].shape: a length of 0 m, expected a positive number",
        ),
        (
            "grid = { cells = [1, 1], size = [9.0, 9.0] }",
            "sphere = { subdivisions = 1, radius = -2.0 }",
            "scene.toml, line 39, body[2].shape: a length of -2 m, expected a positive number",
        ),
        (
            "contact-distance = { absolute = 1e-3 }",
            "contact-distance = { absolute = 1000.0 }",
            "scene.toml, line 8, settings.contact-distance: `contact-distance` is 1000, expected a length not above",
        ),
        (
            "lower = [1.9,",
            "lower = [2.9,",
            "scene.toml, line 35, body[1].script[1].vertices: the box from [2.9, -0.1, -0.1] to [2.1, 0.1, 2.0] is empty",
        ),
        (
            "duration = 0.1",
            "duration = -1.0",
            "scene.toml, line 2, duration: -1, expected a number of seconds, not below 0",
        ),
        (
            "lags = 2",
            "lags = 0",
            "scene.toml, line 16, settings.friction.lags: `friction.lags` is 0, expected 1 at least",
        ),
        (
            "scale = 0.5",
            "scale = [1.0, 0.0, 1.0]",
            "scene.toml, line 21, body[0].scale: expected finite factors that are not zero",
        ),
        (
            "contact-distance = { absolute = 1e-3 }",
            "contact-distance = 1e-3",
            "scene.toml, line 8, settings.contact-distance: wanted string or table",
        ),
        // Right through the cloth, which is body 1.
        (
            "translate = [0.0, 0.0, 3.0]",
            "translate = [0.2, 0.1, 0.6]",
            "scene.toml, line 26, body[1]: ",
        ),
    ];
    assert_errors(&cases);
    let meeting = error_with("translate = [0.0, 0.0, 3.0]", "translate = [0.2, 0.1, 0.6]");
    assert!(
        meeting.contains("of body[1] and ")
            && meeting.contains("of body[0], near [")
            && meeting.contains("meet at"),
        "{meeting}"
    );
    let empty = parse("duration = 1.0").err().unwrap();
    assert_eq!(
        empty,
        "scene.toml, line 1, body: there is none, expected at least one `[[body]]`"
    );
}

#[track_caller]
fn assert_errors(cases: &[(&str, &str, &str)]) {
    for (from, to, expected) in cases {
        let error = error_with(from, to);
        assert!(error.starts_with(expected), "{error}\nexpected {expected}");
    }
}

#[test]
fn unknown_fields_and_methods_are_told() {
    let error = error_with("velocity = [0.0, 1.0, 0.0]", "speed = [0.0, 1.0, 0.0]");
    assert!(
        error.starts_with("scene.toml, line 24, body[0].speed: unknown field `speed`"),
        "{error}"
    );
    let error = error_with("ccd = \"parity\"", "ccd = \"luck\"");
    assert!(
        error.starts_with("scene.toml, line 11, settings.ccd: there is no method `luck`"),
        "{error}"
    );
    let error = error_with("\"fixed\"", "\"dancing\"");
    assert!(
        error.starts_with("scene.toml, line 36, body[1].script[1].motion: unknown variant `dancing`"),
        "{error}"
    );
    let error = parse("duration = 1.0\nbody = 3 4").err().unwrap();
    assert!(error.starts_with("scene.toml, line 2, "), "{error}");
}

/// The documentation shows a scene with everything in it.
#[test]
fn the_scene_of_the_documentation_is_one() {
    let documentation = include_str!("../../../docs/scenes.md");
    let (_, rest) = documentation.split_once("```toml\n").unwrap();
    let (text, _) = rest.split_once("```").unwrap();
    let scene = parse(text).unwrap();
    assert_eq!(scene.steps, 50);
    // What it says of settings is what they are if it says nothing.
    assert_eq!(scene.settings, exact_ccd_sim::Settings::default());
    scene.simulation().unwrap().step().unwrap();
}
