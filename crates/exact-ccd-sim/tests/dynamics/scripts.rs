//! ScriptedVertices motion of vertices and obstacles.

use exact_ccd_mesh::{Audit, Point};
use exact_ccd_sim::{BodyKind, Length, Script, Settings, Simulation, StepFilter, System, shapes};

use crate::measure::{center, is_free_since};

fn settings() -> Settings {
    Settings {
        contact_distance: Length::Absolute(0.005),
        ..Settings::default()
    }
}

/// In each step, the floor rises by more than the contact distance.
#[test]
fn a_rising_floor_lifts_a_cube() {
    let cube = shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[x, y, z]| [x + 0.3, y + 0.02, z + 0.2]);
    let floor = shapes::floor([1, 1], [1.1, 1.2]);
    let rising = Script::Moving {
        velocity: [0.0, 3.0, 0.0],
        until: Some(0.1),
    };
    let vertices = (8..12).collect::<Vec<u32>>();
    let system = System::new(&[cube, floor], &[rising.on(vertices)]).unwrap();
    let mut simulation = Simulation::new(system, settings()).unwrap();
    let start = center(&simulation).y;
    for _ in 0..10 {
        let before = simulation.state().positions.clone();
        let statistics = simulation.step().unwrap();
        assert!(is_free_since(&simulation, &before));
        assert_eq!(statistics.script_lag, 0.0, "{statistics:?}");
    }
    assert!((simulation.state().positions[8][1] - 0.3).abs() < 1e-15);
    assert!(center(&simulation).y - start > 0.25);
}

/// A script cannot move a cloth through a wall. The statistics have the distance to the target.
#[test]
fn the_script_lag_is_the_distance_to_an_unreachable_target() {
    let ceiling = shapes::floor([2, 2], [2.0, 2.0]).placed(|[x, y, z]| [x - 0.5, y + 0.05, z - 0.5]);
    let cloth = shapes::cloth([4, 4], [1.0, 1.0]);
    let up = Script::Moving {
        velocity: [0.0, 10.0, 0.0],
        until: None,
    };
    let system = System::new(&[cloth, ceiling], &[up.on([0, 4])]).unwrap();
    let mut simulation = Simulation::new(system, settings()).unwrap();
    let statistics = simulation.step().unwrap();
    // The targets are 0.05 m behind the ceiling. The springs draw the vertices close to the ceiling.
    assert!((0.05..0.06).contains(&statistics.script_lag), "{statistics:?}");
    let pulled = [0, 4].map(|vertex: usize| simulation.state().positions[vertex][1]);
    assert!(pulled.iter().all(|&height| height > 0.04), "{pulled:?}");
    assert!(simulation.state().positions[..25].iter().all(|x| x[1] < 0.05));
}

/// A plate that presses a stiff block on a floor, faster than the block can yield.
fn press(steps: u32) -> Simulation {
    let block = shapes::solid_box([2, 2, 2], [0.4; 3]).placed(|[x, y, z]| [x + 0.3, y + 0.003, z + 0.3]);
    let plate = shapes::floor([3, 3], [1.0, 1.0]).placed(|[x, _, z]| [x, 0.41, z]);
    let floor = shapes::floor([1, 1], [1.0, 1.0]);
    let down = Script::Moving {
        velocity: [0.0, -0.5, 0.0],
        until: None,
    };
    let mut bodies = [block, floor, plate];
    if let BodyKind::Solid { material, .. } = &mut bodies[0].kind {
        material.young = 1e7;
    }
    let vertices = System::ranges(&bodies)[2].clone();
    let system = System::new(&bodies, &[down.on(vertices)]).unwrap();
    let settings = Settings {
        time_step: 0.02,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    let mut audit = Audit::default();
    let mut frame = |simulation: &Simulation, positions: &[Point]| {
        let frame = simulation.system().surface_frame(positions).unwrap();
        assert!(audit.examine(frame).unwrap().is_none());
    };
    frame(&simulation, &simulation.state().positions);
    for _ in 0..steps {
        let mut increments = Vec::new();
        simulation
            .step_along(&mut |positions| increments.push(positions.to_vec()))
            .unwrap();
        increments
            .iter()
            .for_each(|positions| frame(&simulation, positions));
        assert_rigid(&simulation);
    }
    simulation
}

/// The plate has its shape, up to rounding, wherever the block stops it.
fn assert_rigid(simulation: &Simulation) {
    let system = simulation.system();
    let plate = system.body_vertices()[2].clone();
    let moved = |vertex: u32| {
        let [from, to] = [system.start(), &simulation.state().positions].map(|at| at[vertex as usize]);
        [0, 1, 2].map(|axis: usize| to[axis] - from[axis])
    };
    let first = moved(plate.start);
    for vertex in plate {
        let apart = [0, 1, 2].map(|axis: usize| (moved(vertex)[axis] - first[axis]).abs());
        assert!(apart.iter().all(|&apart| apart < 1e-12), "{vertex}: {apart:?}");
    }
}

/// A plate that a block obstructs stays rigid. Its path is free of contact, and the run can be resumed.
#[test]
fn an_obstructed_plate_stays_rigid() {
    let simulation = press(60);
    let checkpoint = simulation.checkpoint();
    let settings = simulation.settings().clone();
    let mut resumed = checkpoint
        .resume(simulation.system().clone(), settings, StepFilter::default())
        .unwrap();
    resumed.step().unwrap();
    assert_rigid(&resumed);
}
