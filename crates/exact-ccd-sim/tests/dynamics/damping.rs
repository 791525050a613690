//! Damping together with forces, and the order of the integrators.

use exact_ccd_sim::{Integrator, Settings, Simulation, System, shapes};

const RATE: f64 = 2.0;

/// The velocity of a particle that falls from rest for a time, in steps of this number, in m/s.
fn velocity(integrator: Integrator, time: f64, steps: u32) -> f64 {
    let particle = shapes::particles([1, 1, 1], [0.0; 3]);
    let settings = Settings {
        integrator,
        time_step: time / f64::from(steps),
        damping: RATE,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(System::new(&[particle], &[]).unwrap(), settings).unwrap();
    for _ in 0..steps {
        assert!(simulation.step().unwrap().converged);
    }
    simulation.state().velocities[0][1]
}

/// With gravity, the velocity is g / α (1 − exp(−α t)), up to the order of the integrator.
#[test]
fn a_damped_fall_converges_with_the_order_of_the_integrator() {
    let exact = -9.81 / RATE * (1.0 - (-RATE).exp());
    for (integrator, order) in [(Integrator::ImplicitEuler, 1.0), (Integrator::Bdf2, 2.0)] {
        let errors = [80, 160].map(|steps| velocity(integrator, 1.0, steps) - exact);
        let found = (errors[0] / errors[1]).log2();
        assert!((found - order).abs() < 0.2, "{integrator:?}: {found}, {errors:?}");
    }
}

#[test]
fn the_terminal_velocity_does_not_depend_on_the_time_step() {
    for integrator in [Integrator::ImplicitEuler, Integrator::Bdf2] {
        for steps in [50, 200] {
            let found = velocity(integrator, 20.0, steps);
            assert!(
                (found / (-9.81 / RATE) - 1.0).abs() < 1e-9,
                "{integrator:?}: {found}"
            );
        }
    }
}
