//! Scripted motion of vertices and obstacles.

use exact_ccd_sim::{Length, Script, Settings, Simulation, System, shapes};

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
