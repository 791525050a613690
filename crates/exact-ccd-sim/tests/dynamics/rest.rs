//! Bodies at rest stay at rest.

use exact_ccd_sim::{Body, BodyKind, Formulation, Length, Settings, Simulation, System, shapes};
use nalgebra::{Rotation3, Vector3};

use crate::measure::{center, is_free_since};

/// A cube above a floor settles on it and then stays in place.
#[test]
fn a_cube_on_a_floor_rests() {
    let mut cube = shapes::solid_box([2, 2, 2], [0.5; 3]).placed(|[x, y, z]| [x + 0.3, y + 0.004, z + 0.2]);
    if let BodyKind::Solid { material, .. } = &mut cube.kind {
        material.young = 1e7;
    }
    // The floor is a single triangle, so that none of its edges is near: the barriers of two faces at an edge
    // have a tangential force.
    let floor = Body::new(
        vec![[-9.0, 0.0, -9.0], [0.0, 0.0, 19.0], [19.0, 0.0, -9.0]],
        BodyKind::Obstacle {
            faces: vec![[0, 1, 2]],
        },
    );
    let system = System::new(&[cube, floor], &[]).unwrap();
    let settings = Settings {
        contact_distance: Length::Absolute(0.005),
        tolerance: Length::Absolute(1e-6),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for _ in 0..100 {
        let before = simulation.state().positions.clone();
        simulation.step().unwrap();
        assert!(is_free_since(&simulation, &before));
    }
    let settled = center(&simulation);
    for _ in 0..20 {
        let statistics = simulation.step().unwrap();
        assert!(statistics.converged && statistics.contacts > 0);
        let height = statistics.minimal_distance.unwrap();
        assert!(height > 0.0 && height < 0.005);
    }
    let drift = (center(&simulation) - settled).norm();
    assert!(drift < 1e-6, "drifted by {drift} m in 0.2 s");
    let fastest = simulation
        .state()
        .velocities
        .iter()
        .map(|v| Vector3::from(*v).norm())
        .fold(0.0, f64::max);
    assert!(fastest < 1e-5, "{fastest} m/s");
}

/// The distance by which the center of a body moves along the floor in 2 s without friction, with default
/// settings, after it has settled.
fn drift(body: Body, floor: Body, formulation: Formulation) -> f64 {
    let system = System::new(&[body, floor], &[]).unwrap();
    let settings = Settings {
        formulation,
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    let mut center_after = |steps: u32| {
        (0..steps).for_each(|_| assert!(simulation.step().unwrap().converged));
        center(&simulation)
    };
    let settled = center_after(30);
    let moved = center_after(200) - settled;
    moved.x.hypot(moved.z)
}

/// A cube on a floor of triangles, across edges and vertices of it, does not drift.
#[test]
fn a_cube_on_a_floor_of_triangles_does_not_drift() {
    let mut largest = 0.0_f64;
    for (shift, degrees) in [(0.0, 0.0), (0.013, 0.0), (0.0777, 17.0), (0.1, 45.0)] {
        let turn = Rotation3::from_axis_angle(&Vector3::y_axis(), f64::to_radians(degrees));
        let cube = || {
            shapes::solid_box([2, 2, 2], [0.3; 3]).placed(|x| {
                (turn * Vector3::from(x) + Vector3::new(0.31 + shift, 4e-4, 0.42 + 2.0 * shift)).into()
            })
        };
        let floor = || shapes::floor([9, 7], [1.3, 1.3]);
        let found = drift(cube(), floor(), Formulation::Convergent);
        assert!(found < 1e-6 * 0.3, "{found} m at {shift} m and {degrees}°");
        largest = largest.max(drift(cube(), floor(), Formulation::Sum));
    }
    // The sum over all pairs has forces along the floor.
    assert!(largest > 1e-3, "{largest} m");
}
