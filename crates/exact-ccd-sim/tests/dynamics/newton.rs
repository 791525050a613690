//! The convergence of Newton's method.

use std::sync::{Arc, Mutex};

use exact_ccd_mesh::Point;
use exact_ccd_sim::{
    BodyKind, Force, Friction, Iteration, Length, Load, Script, Settings, Simulation, SimulationError,
    Statistics, System, shapes,
};

/// A step counts as converged only if Newton converges for every friction lag.
#[test]
fn every_lag_must_converge() {
    let system = || {
        let cube = shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[x, y, z]| [x + 0.3, y + 0.004, z + 0.2]);
        System::new(&[cube, shapes::floor([1, 1], [1.1, 1.2])], &[]).unwrap()
    };
    let settings = |lags: usize, max_iterations: usize| Settings {
        gravity: [3.0, -9.81, 0.0],
        contact_distance: Length::Absolute(0.005),
        tolerance: Length::Absolute(1e-6),
        friction: Friction {
            coefficient: 0.3,
            lags,
            ..Friction::default()
        },
        max_iterations,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system(), settings(1, 100)).unwrap();
    for _ in 0..5 {
        simulation.step().unwrap();
    }
    let state = simulation.state().clone();
    let step = |lags, most| -> Statistics {
        let simulation = Simulation::resume(system(), settings(lags, most), state.clone());
        simulation.unwrap().step().unwrap()
    };
    let first = step(1, 100);
    assert!(
        first.converged && first.contacts > 0 && first.iterations > 2,
        "{first:?}"
    );
    for most in 1..first.iterations {
        let statistics = step(4, most);
        assert!(!statistics.converged, "{statistics:?}");
    }
    assert!(step(4, 100).converged);
}

/// Far from the origin, the tolerance is below the spacing of coordinates. The step ends without convergence,
/// and all of its increments move a vertex.
#[test]
fn increments_below_the_spacing_of_coordinates_are_not_taken() {
    let mut cube = shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[x, y, z]| [x + 1e6, y + 1e6, z + 1e6]);
    // The cube is so soft that its displacements in one step are below the spacing of coordinates.
    if let BodyKind::Solid { material, .. } = &mut cube.kind {
        material.young = 1e-3;
    }
    let settings = Settings {
        tolerance: Length::Absolute(1e-12),
        contact_distance: Length::Absolute(1e-3),
        ..Settings::default()
    };
    // One corner of the cube is fixed.
    let system = System::new(&[cube], &[Script::Fixed.on([0])]).unwrap();
    let mut simulation = Simulation::new(system, settings).unwrap();
    let mut at = simulation.state().positions.clone();
    let mut increments = 0;
    let mut visit = |positions: &[Point]| {
        assert_ne!(at, positions, "increment {increments}");
        increments += 1;
        at = positions.to_vec();
    };
    let statistics = simulation.step_along(&mut visit).unwrap();
    assert!(
        !statistics.converged && statistics.iterations < 100,
        "{statistics:?}"
    );
    assert!(increments > 0);
}

/// A time step that does not converge is repeated in parts, if the settings allow it. Two cubes that close at
/// 2e4 m/s bounce off each other, instead of one ending a step as if the other had no inertia.
#[test]
fn a_step_without_convergence_is_repeated_in_parts() {
    let cube = |x: f64, speed: f64| {
        let cube = shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[a, b, c]| [a + x, b, c]);
        exact_ccd_sim::Body {
            velocity: [speed, 0.0, 0.0],
            ..cube
        }
    };
    let run = |max_substeps: usize| {
        let system = System::new(&[cube(0.0, 1e4), cube(1.0, -1e4)], &[]).unwrap();
        let settings = Settings {
            max_substeps,
            gravity: [0.0; 3],
            ..Settings::default()
        };
        let mut simulation = Simulation::new(system, settings).unwrap();
        let mut at = simulation.state().positions.clone();
        let mut is_connected = true;
        let mut visit = |positions: &[Point]| {
            let surface = shapes_surface();
            is_connected &= exact_ccd_mesh::step(&surface, &at, positions).unwrap().is_free();
            at = positions.to_vec();
        };
        let statistics = simulation.step_along(&mut visit).unwrap();
        assert!(is_connected && at == simulation.state().positions);
        assert_eq!((statistics.step, simulation.state().step), (1, 1));
        (statistics, crate::measure::momentum(&simulation))
    };
    let (whole, _) = run(1);
    assert!(!whole.converged, "{whole:?}");
    let (parts, momentum) = run(1 << 12);
    assert!(parts.converged && momentum.norm() < 1.0, "{parts:?} {momentum}");
}

/// The surface of two cubes of one cell each.
fn shapes_surface() -> exact_ccd_mesh::TriangleMesh {
    let cube = || shapes::solid_box([1, 1, 1], [0.5; 3]);
    let other = cube().placed(|[x, y, z]| [x + 1.0, y, z]);
    System::new(&[cube(), other], &[]).unwrap().surface().clone()
}

/// The body on which the forces are not finite is named.
#[test]
fn a_failure_names_the_body() {
    let plank = |x: f64, name| {
        let plank = shapes::solid_box([1, 1, 1], [0.3; 3]);
        plank.placed(move |[a, y, z]| [a + x, y, z]).named(name)
    };
    let mut heavy = plank(2.0, "anvil");
    if let BodyKind::Solid { material, .. } = &mut heavy.kind {
        material.density = 1e9;
    }
    let bodies = [plank(0.0, "plank"), heavy, plank(4.0, "")];
    // The acceleration times the mass is beyond the largest number.
    let load = Load {
        vertices: (8..16).collect(),
        force: Force::Acceleration([0.0, 1e308, 0.0]),
        from: 0.0,
        until: None,
    };
    let system = System::new(&bodies, &[]).unwrap().with_loads(vec![load]).unwrap();
    let error = Simulation::new(system, Settings::default())
        .unwrap()
        .step()
        .unwrap_err();
    assert!(
        matches!(&error, SimulationError::Singular { body, .. } if body.name() == "anvil"),
        "{error}"
    );
}

/// Each iteration is reported, the last one of a time step that converges at a residual below the tolerance,
/// and no result depends on it.
#[test]
fn iterations_are_reported() {
    let simulation = || {
        let cube = shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[x, y, z]| [x + 0.3, y + 0.002, z + 0.2]);
        let system = System::new(&[cube, shapes::floor([1, 1], [1.1, 1.2])], &[]).unwrap();
        Simulation::new(system, Settings::default()).unwrap()
    };
    let seen = Arc::new(Mutex::new(Vec::<Iteration>::new()));
    let record = {
        let seen = Arc::clone(&seen);
        move |iteration: &Iteration| seen.lock().unwrap().push(*iteration)
    };
    let (mut plain, mut watched) = (simulation(), simulation().with_watch(record));
    let mut contacts = 0;
    for step in 1..=5 {
        let statistics = watched.step().unwrap();
        plain.step().unwrap();
        assert_eq!(plain.state(), watched.state());
        let iterations = std::mem::take(&mut *seen.lock().unwrap());
        let numbers: Vec<usize> = iterations.iter().map(|iteration| iteration.iteration).collect();
        assert_eq!(numbers, (1..=statistics.iterations).collect::<Vec<_>>());
        assert!(
            iterations
                .iter()
                .all(|iteration| (iteration.step, iteration.part) == (step, [1, 1]))
        );
        let last = iterations.last().unwrap();
        assert!(
            statistics.converged && last.residual <= last.tolerance,
            "{last:?}"
        );
        contacts += last.contacts;
    }
    assert!(contacts > 0);
}
