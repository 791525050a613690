//! Affine bodies and springs in scene files.

use exact_ccd_sim::Simulation;

use crate::parse;

const RING: &str = r#"
duration = 0.1

[settings]
contact-distance = { absolute = 1e-3 }

[[body]]
name = "ring"
shape = { torus = { segments = [8, 4], radius = 0.1, tube = 0.02 } }
affine = { density = 1000.0, stiffness = 1e8 }
translate = [0.0, 1.0, 0.0]

[[body]]
name = "cube"
shape = { box = { cells = [1, 1, 1], size = [0.1, 0.1, 0.1] } }
affine = { density = 1000.0, stiffness = 1e8 }

[[body.load]]
force = { acceleration = [0.0, 0.0, 1.0] }

[[spring]]
between = ["ring"]
at = [[0.0, 1.0, 0.0]]
stiffness = 1e5
length = 0.0

[[spring]]
between = ["ring", "cube"]
at = [[0.0, 1.0, 0.0], [0.05, 0.05, 0.05]]
stiffness = 10.0
"#;

#[test]
fn affine_bodies_and_springs_are_read() {
    let scene = parse(RING).unwrap();
    let mut simulation = scene.simulation;
    let system = simulation.system();
    // 32 vertices and 4 nodes, 8 vertices and 4 nodes.
    assert_eq!(system.start().len(), 48);
    assert_eq!(system.body_kinds(), ["affine", "affine"]);
    assert_eq!(system.surface_vertices().len(), 40);
    let mass: f64 = system.masses()[36..].iter().sum();
    assert!((mass - 1.0).abs() < 1e-12);
    assert!((0..40).all(|vertex| system.has_mass(vertex)));
    let speed = |simulation: &Simulation, axis: usize| simulation.state().velocities[47][axis];
    for _ in 0..10 {
        assert!(simulation.step().unwrap().converged);
    }
    // The joint holds the ring, the spring only brakes the cube. The load accelerates the cube.
    assert!((simulation.state().positions[0][1] - 1.0).abs() < 0.01);
    assert!(speed(&simulation, 1) < -0.01);
    assert!(speed(&simulation, 2) > 0.01);
}

#[test]
fn errors_are_at_their_fields() {
    let cases = [
        (
            "stiffness = 1e8 }\ntranslate",
            "stiffness = 0.0 }\ntranslate",
            "body `ring`, affine.stiffness: `stiffness` is 0, expected a positive number",
        ),
        (
            "shape = { box = { cells = [1, 1, 1], size = [0.1, 0.1, 0.1] } }",
            "shape = { grid = { cells = [1, 1], size = [0.1, 0.1] } }",
            "body `cube`, shape: the surface of the affine body is not closed",
        ),
        (
            "[[body.load]]",
            "[[body.script]]\nvertices = { vertices = [0] }\nmotion = \"fixed\"\n\n[[body.load]]",
            "body `cube`, script[0].vertices: 1 of the 8 vertices are selected, expected none or all",
        ),
        (
            "[[body.load]]",
            "[[body.load]]\nvertices = { vertices = [0, 1] }",
            "body `cube`, load[0].vertices: 2 of the 8 vertices are selected, expected none or all",
        ),
        (
            "between = [\"ring\"]",
            "between = [\"rung\"]",
            "spring[0].between: no body has the name `rung`",
        ),
        (
            "name = \"cube\"",
            "name = \"ring\"",
            "spring[0].between: several bodies have the name `ring`",
        ),
        (
            "between = [\"ring\", \"cube\"]",
            "between = []",
            "spring[1].between: found 0 names, expected those of one or two bodies",
        ),
        (
            "at = [[0.0, 1.0, 0.0]]",
            "at = []",
            "spring[0].at: found 0 positions, expected one or two",
        ),
        (
            "stiffness = 10.0",
            "stiffness = -1.0",
            "spring[1].stiffness: `stiffness` is -1, expected a positive number",
        ),
        (
            "affine = { density = 1000.0, stiffness = 1e8 }",
            "shell = { density = 1000.0, young = 1e5, poisson = 0.3, thickness = 1e-3 }",
            "spring[0].at: [0.0, 1.0, 0.0] is no vertex of body `ring`, which is not affine, expected one as [",
        ),
        (
            "segments = [8, 4]",
            "segments = [8, 2]",
            "body `ring`, shape: the torus has [8, 2] segments, expected at least 3 each",
        ),
    ];
    for (from, to, expected) in cases {
        assert!(RING.contains(from));
        let error = parse(&RING.replacen(from, to, 1)).unwrap_err();
        assert!(error.contains(expected), "{error}\nexpected {expected}");
    }
}
