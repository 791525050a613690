//! Contact that carries loads, whatever the time step.

use exact_ccd_sim::{Body, BodyKind, Integrator, Length, Script, Settings, Simulation, System, shapes};

/// The least distance of a block from the floor on which it rests.
fn gap(integrator: Integrator, time_step: f64, steps: u32) -> f64 {
    let block = shapes::solid_box([2, 2, 2], [0.4; 3]).placed(|[x, y, z]| [x + 0.3, y + 5e-4, z + 0.3]);
    let system = System::new(&[block, shapes::floor([1, 1], [1.0, 1.0])], &[]).unwrap();
    let settings = Settings {
        integrator,
        time_step,
        tolerance: Length::Absolute(1e-7 / time_step),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    let all = (0..steps).map(|_| simulation.step().unwrap());
    let last = all.last().unwrap();
    assert!(last.converged, "{time_step} s: {last:?}");
    last.minimal_distance.unwrap()
}

/// The stiffness of the barrier follows the forces that act in a time step: inertia in a short one,
/// elasticity and weight in a long one.
#[test]
fn the_gap_at_rest_does_not_depend_on_the_time_step() {
    let equilibria = [0.01, 1.0, 100.0].map(|time_step| gap(Integrator::QuasiStatic, time_step, 2));
    for found in equilibria {
        assert!((found / equilibria[0] - 1.0).abs() < 0.01, "{equilibria:?}");
    }
    let long = [1.0, 100.0].map(|time_step| gap(Integrator::ImplicitEuler, time_step, 4));
    for found in long {
        assert!(
            (0.5..2.0).contains(&(found / equilibria[0])),
            "{long:?}, {equilibria:?}"
        );
    }
}

/// A soft block on which a sphere is pressed by 8 mm in each of some quasi-static steps.
fn pressed(time_step: f64, ceiling: Option<Body>) -> Simulation {
    let mut block = shapes::solid_box([4, 3, 4], [0.4, 0.3, 0.4]);
    if let BodyKind::Solid { material, .. } = &mut block.kind {
        material.poisson = 0.3;
    }
    let bottom: Vec<u32> = (0..block.points.len() as u32)
        .filter(|&vertex| block.points[vertex as usize][1] == 0.0)
        .collect();
    let sphere = shapes::sphere(2, 0.15).placed(|[x, y, z]| [x + 0.213, y + 0.4502, z + 0.207]);
    let bodies: Vec<Body> = [block, sphere].into_iter().chain(ceiling).collect();
    let down = Script::Moving {
        velocity: [0.0, -8e-3 / time_step, 0.0],
        until: None,
    };
    let moved = System::ranges(&bodies)[1].clone();
    let system = System::new(&bodies, &[Script::Fixed.on(bottom), down.on(moved)]).unwrap();
    let settings = Settings {
        time_step,
        gravity: [0.0; 3],
        integrator: Integrator::QuasiStatic,
        contact_distance: Length::Absolute(1e-4),
        tolerance: Length::Absolute(1e-6 / time_step),
        ..Settings::default()
    };
    Simulation::new(system, settings).unwrap()
}

/// A sphere that a script presses into a soft block arrives in each step, and the elastic energy does not
/// depend on the time step.
#[test]
fn a_pressed_sphere_arrives() {
    let energies = [0.1, 1.0].map(|time_step| {
        let mut simulation = pressed(time_step, None);
        let all = (0..3).map(|_| simulation.step().unwrap());
        all.inspect(|statistics| {
            assert!(
                statistics.converged && statistics.script_lag == 0.0,
                "{statistics:?}"
            );
        })
        .last()
        .unwrap()
        .energies
        .elastic
    });
    assert!((energies[1] / energies[0] - 1.0).abs() < 1e-3, "{energies:?}");
}

/// A step in which an obstacle stops a script does not converge, however exact Newton's method is.
#[test]
fn a_script_that_stays_behind_is_not_converged() {
    let wall = shapes::floor([1, 1], [1.0, 1.0]).placed(|[x, _, z]| [x - 0.3, 0.3001, z - 0.3]);
    let mut simulation = pressed(1.0, Some(wall));
    let statistics = simulation.step().unwrap();
    assert!(
        !statistics.converged && statistics.script_lag > 1e-3,
        "{statistics:?}"
    );
}

/// With a tolerance below rounding errors, Newton's method stops where it makes no progress, and the time
/// step is not repeated in parts.
#[test]
fn newton_stops_at_rounding_errors() {
    let block = shapes::solid_box([2, 2, 2], [0.4; 3]).placed(|[x, y, z]| [x + 0.3, y + 5e-4, z + 0.3]);
    let system = System::new(&[block, shapes::floor([1, 1], [1.0, 1.0])], &[]).unwrap();
    let settings = Settings {
        tolerance: Length::Absolute(1e-25),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for _ in 0..3 {
        let statistics = simulation.step().unwrap();
        assert!(statistics.stagnated && !statistics.converged, "{statistics:?}");
        assert!(statistics.iterations < 90, "{statistics:?}");
    }
}
