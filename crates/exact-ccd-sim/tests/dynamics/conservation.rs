//! Conservation of momentum without external forces.

use exact_ccd_sim::{Body, Integrator, Length, Settings, Simulation, System, shapes};
use nalgebra::Vector3;

use crate::measure::{angular_momentum, center, momentum};

fn settings(integrator: Integrator) -> Settings {
    Settings {
        gravity: [0.0; 3],
        tolerance: Length::Absolute(1e-9),
        contact_distance: Length::Absolute(0.01),
        integrator,
        ..Settings::default()
    }
}

fn cube(corner: [f64; 3], velocity: [f64; 3]) -> Body {
    let cube = shapes::solid_box([2, 2, 2], [0.5; 3]);
    let mut cube = cube.placed(|x| core::array::from_fn(|axis| x[axis] + corner[axis]));
    cube.velocity = velocity;
    cube
}

/// An oblique collision of two cubes conserves the total momentum.
///
/// Both integrators conserve Σ m v for forces that sum to zero. They conserve Σ m x × v only up to the
/// error of the time step.
#[test]
fn a_collision_conserves_momentum() {
    for integrator in [Integrator::ImplicitEuler, Integrator::Bdf2] {
        let bodies = [
            cube([0.0; 3], [1.0, 0.0, 0.0]),
            cube([0.52, 0.2, 0.1], [-1.0, 0.0, 0.0]),
        ];
        let system = System::new(&bodies, &[]).unwrap();
        let mut simulation = Simulation::new(system, settings(integrator)).unwrap();
        let before = momentum(&simulation);
        let mut contacts = 0;
        for _ in 0..10 {
            let statistics = simulation.step().unwrap();
            assert!(statistics.converged, "{statistics:?}");
            contacts += statistics.contacts;
        }
        assert!(contacts > 0);
        let change = (momentum(&simulation) - before).norm();
        // Each cube has a momentum of 125 kg m/s.
        assert!(change < 1e-5, "{integrator:?}: momentum changed by {change}");
        let first = simulation.state().velocities[0][0];
        assert!(first < 0.9, "nothing bounced: {first}");
    }
}

/// The loss of angular momentum of a spinning cube decreases with the time step: to first order for implicit
/// Euler, and faster for BDF2.
#[test]
fn spin_is_lost_with_the_order_of_the_integrator() {
    let loss = |integrator: Integrator, steps: u32| {
        let system = System::new(&[cube([-0.25; 3], [0.0; 3])], &[]).unwrap();
        let mut settings = settings(integrator);
        settings.time_step = 0.2 / f64::from(steps);
        let mut state = Simulation::new(system.clone(), settings.clone())
            .unwrap()
            .state()
            .clone();
        let spin = Vector3::new(0.0, 0.0, 2.0);
        state.velocities = state
            .positions
            .iter()
            .map(|x| spin.cross(&Vector3::from(*x)).into())
            .collect();
        let mut simulation = Simulation::resume(system, settings, state).unwrap();
        let before = angular_momentum(&simulation);
        for _ in 0..steps {
            assert!(simulation.step().unwrap().converged);
        }
        assert!(center(&simulation).norm() < 1e-9);
        (angular_momentum(&simulation) - before).norm() / before.norm()
    };
    let euler = [20, 40].map(|steps| loss(Integrator::ImplicitEuler, steps));
    assert!(
        euler[0] < 0.05 && (1.7..2.3).contains(&(euler[0] / euler[1])),
        "{euler:?}"
    );
    let bdf2 = [20, 40].map(|steps| loss(Integrator::Bdf2, steps));
    assert!(
        bdf2[0] < 0.2 * euler[0] && bdf2[0] / bdf2[1] > 2.8,
        "{bdf2:?} against {euler:?}"
    );
}

/// With implicit Euler, the positions of free fall from rest are x = −g (h t + t²) / 2.
#[test]
fn free_fall_follows_the_formula_of_implicit_euler() {
    let system = System::new(&[cube([0.0; 3], [0.0; 3])], &[]).unwrap();
    let mut settings = settings(Integrator::ImplicitEuler);
    settings.gravity = [0.0, -10.0, 0.0];
    let mut simulation = Simulation::new(system, settings).unwrap();
    let start = center(&simulation);
    for step in 1..=10 {
        simulation.step().unwrap();
        let time = 0.01 * f64::from(step);
        let fallen = start.y - center(&simulation).y;
        assert!(
            (fallen - 5.0 * time * (time + 0.01)).abs() < 1e-10,
            "{fallen} after {time} s"
        );
    }
}
