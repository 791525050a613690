//! A block on a slope.

use exact_ccd_sim::{Body, BodyKind, Friction, Integrator, Length, Settings, Simulation, System, shapes};
use nalgebra::{Rotation3, Vector3};

use crate::affine::affine_box;
use crate::measure::{center, momentum};

const GRAVITY: f64 = 10.0;
const COEFFICIENT: f64 = 0.5;

/// A stiff block on a slope, after it has settled. The argument is the tangent of the angle of the slope.
///
/// The direction of gravity is tilted instead of the slope.
fn settled(tangent: f64, integrator: Integrator) -> Simulation {
    let mut block =
        shapes::solid_box([2, 1, 2], [0.4, 0.1, 0.4]).placed(|[x, y, z]| [x + 1.0, y + 0.0019, z + 0.3]);
    if let BodyKind::Solid { material, .. } = &mut block.kind {
        material.young = 1e8;
    }
    let floor = shapes::floor([1, 1], [6.0, 1.1]);
    let system = System::new(&[block, floor], &[]).unwrap();
    let settings = Settings {
        integrator,
        gravity: (Rotation3::from_axis_angle(&Vector3::z_axis(), tangent.atan())
            * Vector3::new(0.0, -GRAVITY, 0.0))
        .into(),
        contact_distance: Length::Absolute(0.002),
        tolerance: Length::Absolute(1e-6),
        friction: Friction {
            coefficient: COEFFICIENT,
            static_velocity: Length::Absolute(1e-4),
            lags: 2,
            ..Friction::default()
        },
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for _ in 0..30 {
        simulation.step().unwrap();
    }
    simulation
}

/// The acceleration of the block down the slope, in m/s².
fn acceleration(tangent: f64) -> f64 {
    let mut simulation = settled(tangent, Integrator::ImplicitEuler);
    let speed = |simulation: &Simulation, from: Vector3<f64>| (center(simulation) - from).x / 0.01;
    let at = center(&simulation);
    simulation.step().unwrap();
    let before = speed(&simulation, at);
    for _ in 0..19 {
        simulation.step().unwrap();
    }
    let at = center(&simulation);
    simulation.step().unwrap();
    (speed(&simulation, at) - before) / 0.2
}

/// The block slides if g sin α exceeds μ g cos α. This critical angle is accurate to 1 %.
#[test]
fn a_block_slides_above_the_angle_of_friction() {
    let sticks = acceleration(COEFFICIENT * 0.99);
    assert!(sticks.abs() < 1e-3, "{sticks} m/s²");
    let slides = acceleration(COEFFICIENT * 1.01);
    assert!(slides > 0.01, "{slides} m/s²");
}

#[test]
fn a_block_slides_with_the_acceleration_of_coulombs_law() {
    let tangent = 0.8_f64;
    let angle = tangent.atan();
    let expected = GRAVITY * (angle.sin() - COEFFICIENT * angle.cos());
    let found = acceleration(tangent);
    assert!(
        (found / expected - 1.0).abs() < 0.01,
        "{found} against {expected} m/s²"
    );
}

/// The dissipation of friction is its force times the slip, for both integrators. It is zero for a block that
/// sticks.
#[test]
fn friction_dissipates_force_times_slip() {
    for integrator in [Integrator::ImplicitEuler, Integrator::Bdf2] {
        for (tangent, slides) in [(0.8_f64, true), (0.1, false)] {
            let mut simulation = settled(tangent, integrator);
            let weight = GRAVITY * simulation.system().masses().iter().sum::<f64>();
            let bound = COEFFICIENT * weight * tangent.atan().cos();
            let at = center(&simulation);
            let dissipated: f64 = (0..10)
                .map(|_| simulation.step().unwrap().energies.friction)
                .sum();
            let slipped = bound * (center(&simulation) - at).x;
            if slides {
                assert!(slipped > 1.0, "{slipped} J");
                let ratio = dissipated / slipped;
                assert!((ratio - 1.0).abs() < 0.02, "{integrator:?}: {ratio}");
            } else {
                // In 0.1 s, the work of static friction is at most the work of this creep.
                let creep = bound * 1e-4 * 0.1;
                assert!(
                    (0.0..0.1 * creep).contains(&dissipated),
                    "{integrator:?}: {dissipated} J"
                );
            }
        }
    }
}

/// With default settings, a block slides with the acceleration of Coulomb's law on a slope, and sticks above
/// the tangent of the slope.
fn assert_coulombs_law(block: &Body, degrees: f64) {
    let angle = degrees.to_radians();
    let acceleration = |coefficient: f64| {
        let block = block.clone().placed(|[x, y, z]| [x + 1.0, y + 3e-4, z + 0.3]);
        let system = System::new(&[block, shapes::floor([1, 1], [6.0, 1.1])], &[]).unwrap();
        let settings = Settings {
            gravity: [9.81 * angle.sin(), -9.81 * angle.cos(), 0.0],
            friction: Friction {
                coefficient,
                ..Friction::default()
            },
            ..Settings::default()
        };
        let mut simulation = Simulation::new(system, settings).unwrap();
        let mut at = |steps: u32| {
            (0..steps).for_each(|_| assert!(simulation.step().unwrap().converged));
            center(&simulation).x
        };
        let [start, middle, end] = [at(50), at(40), at(40)];
        (end - 2.0 * middle + start) / 0.16
    };
    let expected = 9.81 * (angle.sin() - 0.3 * angle.cos());
    let slides = acceleration(0.3);
    assert!(
        (slides / expected - 1.0).abs() < 0.02,
        "{degrees}°: {slides}, expected {expected} m/s²"
    );
    let sticks = acceleration(1.02 * angle.tan());
    assert!(sticks.abs() < 1e-3, "{degrees}°: {sticks} m/s²");
}

#[test]
fn default_settings_obey_coulombs_law() {
    let block = shapes::solid_box([2, 1, 2], [0.4, 0.1, 0.4]);
    for degrees in [20.0, 23.0, 25.0] {
        assert_coulombs_law(&block, degrees);
    }
}

#[test]
fn an_affine_block_obeys_coulombs_law() {
    assert_coulombs_law(&affine_box([0.4, 0.1, 0.4]), 20.0);
}

/// A block that lands while it slides: with updates of the normal forces until they converge, friction
/// takes μ times the normal impulse in each time step, the impact included. With one update, it does not:
/// at the start of the step of the impact, there is no contact.
#[test]
fn converged_lags_obey_coulombs_law_in_an_impact() {
    const MU: f64 = 0.2;
    let errors = |lags: usize| {
        let mut block = affine_box([0.4, 0.1, 0.4]).placed(|[x, y, z]| [x + 0.3, y + 0.004, z + 0.3]);
        block.velocity = [2.0, -0.5, 0.0];
        let floor = shapes::floor([1, 1], [6.0, 1.1]);
        let system = System::new(&[block, floor], &[]).unwrap();
        let mass: f64 = system.masses().iter().sum();
        let settings = Settings {
            friction: Friction {
                coefficient: MU,
                static_velocity: Length::Absolute(1e-3),
                lags,
                ..Friction::default()
            },
            gravity: [0.0, -GRAVITY, 0.0],
            tolerance: Length::Absolute(1e-7),
            ..Settings::default()
        };
        let (time_step, mut simulation) = (settings.time_step, Simulation::new(system, settings).unwrap());
        let (mut worst, mut taken) = (0.0_f64, 0.0);
        let mut before = momentum(&simulation);
        for _ in 0..5 {
            assert!(simulation.step().unwrap().converged);
            let after = momentum(&simulation);
            let normal = after.y - before.y + mass * GRAVITY * time_step;
            taken += normal;
            worst = worst.max((before.x - after.x - MU * normal).abs());
            before = after;
        }
        // The block has landed.
        assert!(taken > 0.9 * 0.5 * mass, "{taken}");
        worst / taken
    };
    let [one, converged] = [1, 100].map(errors);
    assert!(converged < 1e-4, "{converged}");
    assert!(one > 1e-2, "{one}");
}
