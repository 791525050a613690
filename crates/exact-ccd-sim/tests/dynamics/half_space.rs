//! Half spaces as obstacles.

use exact_ccd_sim::{
    Friction, HalfSpace, Length, LineSearch, Settings, Simulation, SimulationError, System, SystemError,
    shapes,
};
use nalgebra::Vector3;

use crate::measure::center;

const TILTED: HalfSpace = HalfSpace::new([0.3, -0.7, 0.1], [0.31, 1.7, -0.23]);

fn normal() -> Vector3<f64> {
    TILTED.unit_normal().into()
}

/// A cube with its lowest corner at a height above the tilted half space.
fn above(height: f64) -> System {
    let normal = normal();
    let shift = Vector3::from(TILTED.point) + normal * height;
    let lowest = [[0.0, 0.4], [0.0, 0.4], [0.0, 0.4]];
    let corners = (0..8).map(|k: usize| Vector3::from_fn(|axis, _| lowest[axis][k >> axis & 1]));
    let depth = corners.map(|x| x.dot(&normal)).fold(f64::INFINITY, f64::min);
    let shift = shift - normal * depth;
    let cube = shapes::solid_box([2, 2, 2], [0.4; 3]).placed(|x| (Vector3::from(x) + shift).into());
    System::new(&[cube], &[])
        .unwrap()
        .with_half_spaces(vec![TILTED])
        .unwrap()
}

/// A cube that falls fast onto a half space stays apart from it in every increment, exactly.
#[test]
fn no_increment_enters_a_half_space() {
    for line_search in [LineSearch::Common, LineSearch::Vertex] {
        let settings = Settings {
            gravity: (normal() * -300.0).into(),
            time_step: 0.05,
            line_search,
            ..Settings::default()
        };
        let mut simulation = Simulation::new(above(0.3), settings).unwrap();
        let system = simulation.system().clone();
        let (mut increments, mut contacts) = (0, 0);
        for _ in 0..10 {
            let visit = &mut |positions: &[[f64; 3]]| {
                increments += 1;
                assert_eq!(system.first_grounded(positions), None);
            };
            contacts += simulation.step_along(visit).unwrap().contacts;
        }
        assert!(increments > 20 && contacts > 0, "{increments} {contacts}");
    }
}

#[test]
fn a_start_within_a_half_space_is_an_error() {
    assert!(Simulation::new(above(1e-3), Settings::default()).is_ok());
    let error = Simulation::new(above(-1e-3), Settings::default()).unwrap_err();
    assert!(
        matches!(&error, SimulationError::Grounded { half_space, .. } if half_space.place() == 0),
        "{error}"
    );
    for (what, half_space) in [
        (
            "normal",
            HalfSpace {
                normal: [0.0; 3],
                ..TILTED
            },
        ),
        (
            "point",
            HalfSpace {
                point: [f64::NAN, 0.0, 0.0],
                ..TILTED
            },
        ),
    ] {
        let error = above(0.1).with_half_spaces(vec![half_space]).unwrap_err();
        assert!(
            matches!(&error, SystemError::HalfSpace { source, .. } if source.what == what),
            "{error}"
        );
    }
}

/// A body with an offset keeps it: the contact surface rests within the contact distance.
#[test]
fn offsets_keep_their_distance() {
    let ball = shapes::particles([1, 1, 2], [0.0, 0.0, 0.3]).placed(|[x, y, z]| [x, y + 0.012, z]);
    let ground = HalfSpace::new([0.0; 3], [0.0, 2.0, 0.0]);
    let system = System::new(&[ball.with_offset(0.01)], &[]).unwrap();
    let system = system.with_half_spaces(vec![ground]).unwrap();
    let settings = Settings {
        contact_distance: Length::Absolute(1e-3),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for _ in 0..60 {
        simulation.step().unwrap();
    }
    let height = simulation.state().positions[0][1];
    assert!(0.01 < height && height < 0.011, "{height}");
}

/// A cube at rest on a half space does not drift, without friction: not by a millionth of its size in 2 s.
#[test]
fn a_cube_at_rest_does_not_drift() {
    let normal = normal();
    let turn = nalgebra::Rotation3::rotation_between(&Vector3::y(), &normal).unwrap();
    let cube = shapes::solid_box([2, 2, 2], [0.3; 3])
        .placed(|x| (Vector3::from(TILTED.point) + turn * (Vector3::from(x) + Vector3::y() * 1e-3)).into());
    let system = System::new(&[cube], &[])
        .unwrap()
        .with_half_spaces(vec![TILTED])
        .unwrap();
    let gravity = (normal * -9.81).into();
    let mut simulation = Simulation::new(
        system,
        Settings {
            gravity,
            ..Settings::default()
        },
    )
    .unwrap();
    for _ in 0..50 {
        simulation.step().unwrap();
    }
    let before = center(&simulation);
    for _ in 0..200 {
        assert!(simulation.step().unwrap().contacts > 0);
    }
    let drift = center(&simulation) - before;
    let along = (drift - normal * drift.dot(&normal)).norm();
    assert!(along < 1e-6 * 0.3, "{along} m");
}

/// Friction on a half space obeys Coulomb's law, with default settings.
#[test]
fn friction_acts_on_a_half_space() {
    let slides = |coefficient: f64| {
        let angle = 20.0_f64.to_radians();
        let ground = HalfSpace::new([0.0; 3], [0.0, 1.0, 0.0]);
        let block = shapes::solid_box([2, 1, 2], [0.4, 0.1, 0.4]).placed(|[x, y, z]| [x, y + 3e-4, z]);
        let system = System::new(&[block], &[])
            .unwrap()
            .with_half_spaces(vec![ground])
            .unwrap();
        let friction = Friction {
            coefficient,
            ..Friction::default()
        };
        let gravity = [9.81 * angle.sin(), -9.81 * angle.cos(), 0.0];
        let mut simulation = Simulation::new(
            system,
            Settings {
                gravity,
                friction,
                ..Settings::default()
            },
        )
        .unwrap();
        let mut at = |steps: u32| {
            (0..steps).for_each(|_| assert!(simulation.step().unwrap().converged));
            center(&simulation).x
        };
        let (start, middle, end) = (at(50), at(50), at(50));
        (end - 2.0 * middle + start) / 0.25
    };
    let angle = 20.0_f64.to_radians();
    let expected = 9.81 * (angle.sin() - 0.3 * angle.cos());
    let found = slides(0.3);
    assert!(
        (found / expected - 1.0).abs() < 0.02,
        "{found}, expected {expected}"
    );
    let sticks = slides(1.02 * angle.tan());
    assert!(sticks.abs() < 1e-3, "{sticks}");
}
