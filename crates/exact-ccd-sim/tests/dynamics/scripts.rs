//! Obstacles that move.

use exact_ccd_sim::{Length, Script, Settings, Simulation, System, shapes};

use crate::measure::{center, is_free_since};

fn settings() -> Settings {
    Settings {
        contact_distance: Length::Absolute(0.005),
        ..Settings::default()
    }
}

/// A floor lifts a cube from below, faster than the contact distance in each step.
#[test]
fn a_floor_that_rises_lifts_what_lies_on_it() {
    let cube = shapes::solid_box([1, 1, 1], [0.5; 3]).placed(|[x, y, z]| [x + 0.3, y + 0.02, z + 0.2]);
    let floor = shapes::floor([1, 1], [1.1, 1.2]);
    let rising = Script::Moving {
        velocity: [0.0, 3.0, 0.0],
        until: Some(0.1),
    };
    let vertices = (8..12).collect::<Vec<u32>>();
    let system = System::new(&[cube, floor], &[(vertices, rising)]).unwrap();
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

/// A cloth cannot be pulled through a wall: the script is not kept, and says by how much.
#[test]
fn what_cannot_be_reached_is_told() {
    let ceiling = shapes::floor([2, 2], [2.0, 2.0]).placed(|[x, y, z]| [x - 0.5, y + 0.05, z - 0.5]);
    let cloth = shapes::cloth([4, 4], [1.0, 1.0]);
    let up = Script::Moving {
        velocity: [0.0, 10.0, 0.0],
        until: None,
    };
    let system = System::new(&[cloth, ceiling], &[(vec![0, 4], up)]).unwrap();
    let mut simulation = Simulation::new(system, settings()).unwrap();
    let statistics = simulation.step().unwrap();
    // Their targets are 0.05 m behind the ceiling, and the springs pull them up to it.
    assert!((0.05..0.06).contains(&statistics.script_lag), "{statistics:?}");
    let pulled = [0, 4].map(|vertex: usize| simulation.state().positions[vertex][1]);
    assert!(pulled.iter().all(|&height| height > 0.04), "{pulled:?}");
    assert!(simulation.state().positions[..25].iter().all(|x| x[1] < 0.05));
}
