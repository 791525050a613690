//! When Newton's method has converged, and when it goes nowhere.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{BodyKind, Friction, Length, Script, Settings, Simulation, Statistics, System, shapes};

/// A step has converged only if it has for each lag of friction: not if the first one takes more iterations than are allowed.
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

/// Far from the origin, positions cannot be told as exactly as the tolerance asks: the step ends where they are the best.
#[test]
fn steps_that_rounding_takes_back_are_none() {
    let mut cube = shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[x, y, z]| [x + 1e6, y + 1e6, z + 1e6]);
    // So soft that in one step it shifts vertices by less than can be told.
    if let BodyKind::Solid { material, .. } = &mut cube.kind {
        material.young = 1e-3;
    }
    let settings = Settings {
        tolerance: Length::Absolute(1e-12),
        contact_distance: Length::Absolute(1e-3),
        ..Settings::default()
    };
    // It hangs by a corner.
    let system = System::new(&[cube], &[(vec![0], Script::Fixed)]).unwrap();
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
