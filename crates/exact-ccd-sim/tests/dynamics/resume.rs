//! Resumed simulations.

use std::sync::Arc;

use exact_ccd::Exact;
use exact_ccd_sim::{
    Body, BodyKind, Checkpoint, Friction, Integrator, Length, Script, ScriptedVertices, Settings, Simulation,
    SimulationError, State, StepFilter, System, shapes,
};
use serde_json::Value;

fn system() -> System {
    let cube = shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[x, y, z]| [x + 0.3, y + 0.02, z + 0.2]);
    let floor = shapes::floor([1, 1], [1.1, 1.2]);
    System::new(&[cube, floor], &[]).unwrap()
}

fn settings() -> Settings {
    Settings {
        integrator: Integrator::Bdf2,
        gravity: [2.0, -9.81, 0.5],
        contact_distance: Length::Absolute(0.01),
        friction: Friction {
            coefficient: 0.3,
            lags: 2,
            ..Friction::default()
        },
        ..Settings::default()
    }
}

#[test]
fn a_resumed_simulation_has_the_same_bits() {
    let mut whole = Simulation::new(system(), settings()).unwrap();
    let mut contacts = 0;
    let mut saved = Vec::new();
    for _ in 0..16 {
        saved.push(serde_json::to_string(whole.state()).unwrap());
        contacts += whole.step().unwrap().contacts;
    }
    assert!(contacts > 0, "nothing touched");

    for step in [0, 1, 7, 12] {
        let state: State = serde_json::from_str(&saved[step]).unwrap();
        let mut resumed = Simulation::resume(system(), settings(), state).unwrap();
        for _ in step..16 {
            resumed.step().unwrap();
        }
        // Compared as text, where −0.0 differs from 0.0.
        let states = [&whole, &resumed].map(|simulation| serde_json::to_string(simulation.state()).unwrap());
        assert_eq!(states[0], states[1], "from step {step}");
    }
}

/// The energy of the barrier keeps its stiffness between the first step of BDF2, which is one of implicit
/// Euler, and the next step, although their effective time steps differ.
#[test]
fn the_stiffness_of_the_barrier_is_kept_after_the_first_step_of_bdf2() {
    let mut simulation = Simulation::new(system(), settings()).unwrap();
    // The cube has come to rest: a change of contacts would be another step of implicit Euler.
    let mut touching = 0;
    while touching < 20 {
        let contacts = simulation.step().unwrap().contacts;
        touching = if contacts > 0 { touching + 1 } else { 0 };
    }
    // Without an earlier state, the next step is the first of BDF2.
    let mut state = simulation.state().clone();
    state.earlier = None;
    // A stiffness inside the range is kept.
    state.stiffness = state.stiffness.map(|stiffness| 1.5 * stiffness);
    let expected = state.stiffness.unwrap();
    let mut simulation = Simulation::resume(system(), settings(), state).unwrap();
    for duration in [0.01, 0.02 / 3.0] {
        let stiffness = simulation.step().unwrap().stiffness.unwrap();
        let energy = stiffness / (duration * duration);
        assert!(
            (energy / expected - 1.0).abs() < 1e-12,
            "{energy}, expected {expected}"
        );
    }
}

#[test]
fn a_state_of_another_system_is_an_error() {
    let simulation = Simulation::new(system(), settings()).unwrap();
    let mut state = simulation.state().clone();
    state.velocities.pop();
    let error = Simulation::resume(system(), settings(), state).err().unwrap();
    assert!(
        matches!(
            error,
            SimulationError::State {
                what: "velocities",
                found: 11,
                expected: 12
            }
        ),
        "{error}"
    );
}

/// A checkpoint can only be resumed with its settings and its system.
#[test]
fn a_checkpoint_of_another_simulation_is_an_error() {
    type Change = fn(&mut Settings);
    let mut simulation = Simulation::new(system(), settings()).unwrap();
    simulation.step().unwrap();
    let text = serde_json::to_string(&simulation.checkpoint()).unwrap();
    let filter = StepFilter::default();
    let other = |system: System, change: &dyn Fn(&mut Settings)| {
        let checkpoint: Checkpoint = serde_json::from_str(&text).unwrap();
        let mut settings = settings();
        change(&mut settings);
        match checkpoint.resume(system, settings, filter.clone()).err() {
            None => "none".to_owned(),
            Some(SimulationError::OtherSetting { what, there, here }) => {
                assert_ne!(there, here);
                what.to_owned()
            }
            Some(SimulationError::OtherSystem { what }) => what.to_owned(),
            Some(other) => panic!("{other}"),
        }
    };
    assert_eq!(other(system(), &|_| ()), "none");
    let changes: [(&str, Change); 3] = [
        ("time-step", |settings| settings.time_step *= 0.5),
        ("integrator", |settings| {
            settings.integrator = Integrator::ImplicitEuler;
        }),
        ("friction.lags", |settings| settings.friction.lags = 1),
    ];
    for (what, change) in changes {
        assert_eq!(other(system(), &change), what);
    }
    let cube = || shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[x, y, z]| [x + 0.3, y + 0.02, z + 0.2]);
    let floor = || shapes::floor([1, 1], [1.1, 1.2]);
    let changed = |change: &dyn Fn(&mut Body), scripts: &[ScriptedVertices]| {
        let mut cube = cube();
        change(&mut cube);
        other(System::new(&[cube, floor()], scripts).unwrap(), &|_| ())
    };
    assert_eq!(changed(&|_| (), &[]), "none");
    assert_eq!(changed(&|cube| cube.points[0][0] -= 1e-9, &[]), "positions");
    assert_eq!(changed(&|cube| cube.velocity[0] = 1e-9, &[]), "velocities");
    assert_eq!(changed(&|_| (), &[Script::Fixed.on([0])]), "scripts");
    let denser = |cube: &mut Body| {
        if let BodyKind::Solid { material, .. } = &mut cube.kind {
            material.density *= 1.01;
        }
    };
    assert_eq!(changed(&denser, &[]), "materials");
    assert_eq!(changed(&|cube| cube.name = "cube".to_owned(), &[]), "bodies");
    let fewer = |cube: &mut Body| {
        if let BodyKind::Solid { tetrahedra, .. } = &mut cube.kind {
            tetrahedra.pop();
        }
    };
    assert_eq!(changed(&fewer, &[]), "elements");
}

/// A checkpoint of another version is an error, even if its system is the same.
#[test]
fn a_checkpoint_of_another_version_is_an_error() {
    let simulation = Simulation::new(system(), settings()).unwrap();
    let current = serde_json::to_value(simulation.checkpoint()).unwrap();
    let resume = |checkpoint: Value| {
        let checkpoint: Checkpoint = serde_json::from_value(checkpoint).unwrap();
        checkpoint
            .resume(system(), settings(), StepFilter::default())
            .err()
    };
    assert_eq!(resume(current.clone()), None);
    let mut earlier = current.clone();
    earlier["system"]
        .as_object_mut()
        .unwrap()
        .remove("version")
        .unwrap();
    let mut later = current;
    later["system"]["version"] = 1_000_000.into();
    for other in [earlier, later] {
        assert_eq!(resume(other), Some(SimulationError::OtherVersion));
    }
}

#[test]
fn settings_out_of_range_are_errors() {
    let with = |change: fn(&mut Settings)| {
        let mut settings = settings();
        change(&mut settings);
        Simulation::new(system(), settings).err().unwrap().to_string()
    };
    let error = with(|settings| settings.time_step = 0.0);
    assert_eq!(error, "`time-step` is 0, expected a positive number");
    let error = with(|settings| settings.friction.coefficient = f64::NAN);
    assert_eq!(
        error,
        "`friction.coefficient` is NaN, expected a number not below 0"
    );
    let error = with(|settings| settings.ccd = "guess".to_owned());
    assert_eq!(
        error,
        "the settings name the CCD method `guess`, expected `exact`: pass other methods to `with_filter`"
    );
}

/// A checkpoint has the name of a replaced filter, so that it cannot be resumed with another filter.
#[test]
fn a_checkpoint_has_the_name_of_a_replaced_filter() {
    let simulation = Simulation::new(system(), settings()).unwrap();
    let checkpoint = simulation
        .with_filter(StepFilter::by_bisection("bisection", Arc::new(Exact)))
        .unwrap()
        .checkpoint();
    assert_eq!(checkpoint.settings.ccd, "bisection");
    assert!(matches!(
        checkpoint.resume(system(), settings(), StepFilter::default()).err(),
        Some(SimulationError::OtherSetting { what, .. }) if what == "ccd"
    ));
}
