//! The first steps of the scenes in `examples/scenes` that need no other files, and the generated sphere.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;

use exact_ccd::{Separation, Thickness};
use exact_ccd_mesh::{
    Aabb, Audit, Bvh, IntersectionOptions, MinDistance, Point, TriangleMesh, intersections, step,
};
use exact_ccd_scene::Scene;
use exact_ccd_sim::{BodyKind, Settings, Simulation, State, Statistics, StepFilter, System, shapes};

fn exact(settings: &mut Settings, _: &System) -> Result<StepFilter, String> {
    assert_eq!(settings.ccd, "exact");
    Ok(StepFilter::default())
}

fn scene(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes");
    Scene::read(folder.join(name), None, &exact).unwrap()
}

/// Takes some steps of a scene. Checks that each increment is free of contact, and the final state free of
/// intersections.
fn run(name: &str, steps: usize) -> (Simulation, Vec<Statistics>) {
    let scene = scene(name);
    let surface = scene.simulation.system().surface().clone();
    let mut simulation = scene.simulation;
    let mut at = simulation.state().positions.clone();
    let mut all = Vec::new();
    for _ in 0..steps {
        let statistics = simulation.step_along(&mut |positions: &[Point]| {
            assert!(step(&surface, &at, positions).unwrap().is_free(), "{name}");
            at = positions.to_vec();
        });
        all.push(statistics.unwrap());
        assert!(all.last().unwrap().converged, "{name}: {all:?}");
        assert_eq!(at, simulation.state().positions);
    }
    let touching = IntersectionOptions::default();
    assert!(
        intersections(&surface, &at, &Bvh, &touching).unwrap().is_empty(),
        "{name}"
    );
    (simulation, all)
}

/// The positions of the vertices that do not belong to obstacles.
fn moving<'a>(simulation: &'a Simulation, state: &'a State) -> impl Iterator<Item = Point> + 'a {
    let masses = simulation.system().masses().iter();
    let vertices = masses.zip(&state.positions).filter(|(mass, _)| **mass > 0.0);
    vertices.map(|(_, position)| *position)
}

#[test]
fn the_small_mat_twists_without_intersection() {
    let (simulation, all) = run("small-mat-twist.toml", 55);
    assert!(all.iter().any(|statistics| statistics.contacts > 0));
    assert!(all.iter().all(|statistics| statistics.script_lag == 0.0));
    let bounds: Aabb = simulation.state().positions.iter().copied().collect();
    // The scripts rotate the ends, which are 0.5 m wide, by 2.8 rad.
    let height = 0.25 * (0.4_f64 * core::f64::consts::PI * 2.2).sin();
    assert!(bounds.upper[1] > height, "{bounds:?}");
}

/// The corners of the cloth follow their scripts, and the cloth swings without intersections.
#[test]
fn the_cloth_hangs_by_its_corners() {
    let (simulation, all) = run("pinned-cloth.toml", 20);
    assert!(all.iter().all(|statistics| statistics.script_lag == 0.0));
    let positions = &simulation.state().positions;
    assert_eq!(positions[0], [0.0; 3]);
    assert!((positions[16][0] - (1.0 - 0.4 * 0.4)).abs() < 1e-12 && positions[16][1] == 0.0);
    let lowest = positions.iter().map(|x| x[1]).fold(0.0, f64::min);
    assert!(lowest < -0.3, "{lowest}");
}

/// The ball stretches the cloth almost to its limit, which no edge exceeds in any increment.
#[test]
fn the_cloth_catches_the_ball() {
    let limit = 0.05;
    let scene = scene("caught-ball.toml");
    let rest = scene.simulation.system().start().to_vec();
    let cloth = scene.simulation.system().body_vertices()[0].clone();
    let edges = scene.simulation.system().surface().edges().iter();
    let edges: Vec<[u32; 2]> = edges.copied().filter(|edge| cloth.contains(&edge[0])).collect();
    let length = |points: &[Point], [a, b]: [u32; 2]| {
        let [a, b] = [a, b].map(|vertex| points[vertex as usize]);
        (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt()
    };
    let mut simulation = scene.simulation;
    let mut most = 0.0_f64;
    for _ in 0..20 {
        let statistics = simulation.step_along(&mut |positions| {
            let stretches = edges
                .iter()
                .map(|&edge| length(positions, edge) / length(&rest, edge));
            most = stretches.fold(most, f64::max);
        });
        assert!(statistics.unwrap().converged);
    }
    assert!(1.0 + 0.7 * limit < most && most < 1.0 + limit, "{most}");
}

#[test]
fn the_small_mat_is_the_same_on_any_number_of_threads() {
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let mut simulation = scene("small-mat-twist.toml").simulation;
        pool.install(|| {
            let contacts: usize = (0..55).map(|_| simulation.step().unwrap().contacts).sum();
            assert!(contacts > 0, "nothing came near");
        });
        // Compared as text, where −0.0 differs from 0.0.
        serde_json::to_string(simulation.state()).unwrap()
    };
    assert_eq!(on(1), on(2));
}

#[test]
fn blocks_slide_on_the_slope() {
    let (simulation, all) = run("blocks-on-slope.toml", 30);
    assert!(all.iter().any(|statistics| statistics.contacts > 0));
    // Friction dissipates less than the total loss, because the integrator dissipates too.
    let lost = all[0].energies.mechanical() - all[29].energies.mechanical();
    let friction: f64 = all[1..]
        .iter()
        .map(|statistics| statistics.energies.friction)
        .sum();
    assert!(
        friction > 0.01 * lost && friction < lost,
        "{friction} of {lost} J"
    );
    // The energy must not increase, which happens if a step counts as converged deep inside the barrier.
    for pair in all.windows(2) {
        let [before, after] = [&pair[0], &pair[1]].map(|statistics| statistics.energies.mechanical());
        assert!(after <= before + 1e-3 * lost, "{pair:?}");
    }
    // The slope starts at (−1, ½) and descends by tan 30°.
    let slope = 30_f64.to_radians().tan();
    for [x, y, _] in moving(&simulation, simulation.state()) {
        assert!(y > 0.5 - slope * (x + 1.0), "({x}, {y})");
    }
}

#[test]
fn the_cloth_stays_outside_of_the_sphere() {
    let (simulation, all) = run("cloth-on-sphere.toml", 20);
    assert!(all.iter().any(|statistics| statistics.contacts > 0));
    // The triangles of the sphere lie inside the radius.
    for [x, y, z] in moving(&simulation, simulation.state()) {
        assert!(x.hypot(y).hypot(z) > 0.29);
    }
}

/// The path keeps the sum of the offsets of both bodies, and so the least sum of two offsets, by audits
/// with a minimum distance.
#[test]
fn cloth_knot_and_particles_keep_their_thickness() {
    let scene = scene("cloth-knot-particles.toml");
    let system = scene.simulation.system().clone();
    let offsets = Thickness::new(&system.surface_offsets()).unwrap();
    let least = Separation::new(0.01).unwrap();
    let mut audits = [MinDistance::thickness(offsets), MinDistance::uniform(least)]
        .map(|distance| Audit::default().with_min_distance(distance));
    let mut simulation = scene.simulation;
    let mut examine = |positions: &[Point]| {
        let frame = system.surface_frame(positions).unwrap();
        for audit in &mut audits {
            assert_eq!(audit.examine(frame.clone()).unwrap(), None);
        }
    };
    examine(&simulation.state().positions);
    let mut contacts = 0;
    for _ in 0..9 {
        let statistics = simulation.step_along(&mut examine).unwrap();
        assert!(
            statistics.converged && statistics.script_lag == 0.0,
            "{statistics:?}"
        );
        contacts = statistics.contacts;
    }
    assert!(contacts > 100, "{contacts}");
    // A frame is examined for each increment, and a greater distance is not kept.
    assert!(audits[0].frames() > 20);
    let greater = Separation::new(0.0125).unwrap();
    let mut audit = Audit::default().with_min_distance(MinDistance::uniform(greater));
    let last = system.surface_frame(&simulation.state().positions).unwrap();
    assert!(audit.examine(last).unwrap().is_some());
}

#[test]
fn errors_name_the_missing_mesh_file() {
    for (name, mesh) in [
        ("octocats.toml", "32770_octocat.msh"),
        ("mat-twist.toml", "mat40x40.msh"),
    ] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes");
        let error = Scene::read(folder.join(name), Some(Path::new("nowhere")), &exact).unwrap_err();
        let message = error.to_string();
        assert!(message.contains(name) && message.contains(mesh), "{message}");
    }
}

#[test]
fn spheres_are_closed_and_round() {
    for subdivisions in 0..4 {
        let sphere = shapes::sphere(subdivisions, 2.0);
        let BodyKind::Obstacle { faces } = &sphere.kind else {
            panic!("{:?}", sphere.kind)
        };
        let mesh = TriangleMesh::new(sphere.points.len(), faces.clone()).unwrap();
        assert_eq!(faces.len(), 20 << (2 * subdivisions));
        assert_eq!(sphere.points.len() + faces.len(), mesh.edges().len() + 2);
        let volume: f64 = faces
            .iter()
            .map(|face| {
                let [a, b, c] = face.map(|vertex| nalgebra::Vector3::from(sphere.points[vertex as usize]));
                assert!((a.norm() - 2.0).abs() < 1e-14);
                a.cross(&b).dot(&c) / 6.0
            })
            .sum();
        let ball = 32.0 / 3.0 * core::f64::consts::PI;
        let missing = 0.6 / f64::from(1 << (2 * subdivisions));
        assert!(
            volume < ball && volume > (1.0 - missing) * ball,
            "{volume} of {ball}"
        );
    }
}

/// The balloon is blown up, and is pressed by the plate without a vertex in the ground.
#[test]
fn the_balloon_is_blown_up() {
    let (simulation, _) = run("pressed-balloon.toml", 6);
    let positions = &simulation.state().positions;
    assert_eq!(simulation.system().first_grounded(positions), None);
    let bounds: Aabb = moving(&simulation, simulation.state()).collect();
    let width = bounds.upper[0] - bounds.lower[0];
    // The strain of a sphere of membrane: p r (1 − ν) / (2 E t).
    let strain = 800.0 * 0.15 * 0.7 / (2.0 * 1e6 * 1e-3);
    assert!((width / (0.3 * (1.0 + strain)) - 1.0).abs() < 0.02, "{width}");
    // The key frames move the plate, which starts at a height of 0.36 m.
    let lowest = positions.iter().zip(simulation.system().masses());
    let lowest = lowest
        .filter(|(_, mass)| **mass == 0.0)
        .map(|(x, _)| x[1])
        .fold(1.0, f64::min);
    assert!((lowest - (0.36 - 0.1 * 0.12 / 0.4)).abs() < 1e-9, "{lowest}");
}
