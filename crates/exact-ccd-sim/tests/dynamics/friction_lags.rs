//! Friction with the default number of lags, where normal forces change within a time step.

use exact_ccd_sim::{Body, Friction, HalfSpace, Length, Settings, Simulation, System};

use crate::affine::affine_box;
use crate::measure::center;

fn on_ground(body: Body, settings: Settings) -> Simulation {
    let ground = HalfSpace::new([0.0; 3], [0.0, 1.0, 0.0]);
    let system = System::new(&[body], &[]).unwrap();
    Simulation::new(system.with_half_spaces(vec![ground]).unwrap(), settings).unwrap()
}

/// A block with the speed v that starts within the contact distance, and is pushed away at first, stops after
/// v² / (2 μ g).
#[test]
fn a_block_that_starts_in_contact_stops_by_coulombs_law() {
    let (speed, coefficient) = (2.0, 0.4);
    let mut block = affine_box([0.3, 0.05, 0.3]).placed(|[x, y, z]| [x, y + 3e-4, z]);
    block.velocity = [speed, 0.0, 0.0];
    let settings = Settings {
        time_step: 2.5e-3,
        friction: Friction {
            coefficient,
            ..Friction::default()
        },
        ..Settings::default()
    };
    let mut simulation = on_ground(block, settings);
    let start = center(&simulation).x;
    for _ in 0..300 {
        assert!(simulation.step().unwrap().converged);
    }
    let expected = speed * speed / (2.0 * coefficient * 9.81);
    let found = center(&simulation).x - start;
    assert!(
        (found / expected - 1.0).abs() < 0.02,
        "{found} m, expected {expected} m"
    );
}

/// A box that is twice as high as wide stays upright on a slope of 0.97 of the tangent at which it tips, 1/2.
#[test]
fn a_stable_box_does_not_topple() {
    let height = 0.2;
    let body = affine_box([0.1, height, 0.1]).placed(|[x, y, z]| [x, y + 1.2e-5, z]);
    let angle = f64::atan(0.97 * 0.5);
    let settings = Settings {
        gravity: [9.81 * angle.sin(), -9.81 * angle.cos(), 0.0],
        contact_distance: Length::Absolute(1e-5),
        friction: Friction {
            coefficient: 5.0,
            static_velocity: Length::Relative(1e-4),
            ..Friction::default()
        },
        ..Settings::default()
    };
    let mut simulation = on_ground(body, settings);
    for _ in 0..100 {
        assert!(simulation.step().unwrap().converged);
    }
    let found = center(&simulation).y;
    assert!((found / (0.5 * height) - 1.0).abs() < 1e-3, "{found} m");
}
