//! Scenes that turn as a whole.

use exact_ccd_sim::{Body, Friction, HalfSpace, Length, Settings, Simulation, System, shapes};
use nalgebra::{Rotation3, Vector3};

use crate::affine::affine_box;

/// The positions after half a second, in the frame that turns with the scene, and the size of the scene: an
/// elastic and an affine block start within the contact distance of a slope, and slide.
fn motion(turn: &Rotation3<f64>) -> (Vec<Vector3<f64>>, f64) {
    let turned = |vector: [f64; 3]| -> [f64; 3] { (turn * Vector3::from(vector)).into() };
    let placed = |body: Body, shift: f64| body.placed(|[x, y, z]| turned([x, y + 4e-4, z + shift]));
    let blocks = [
        placed(shapes::solid_box([2, 1, 2], [0.4, 0.1, 0.3]), 0.0),
        placed(affine_box([0.3, 0.1, 0.2]), 0.5),
    ];
    let ground = HalfSpace::new([0.0; 3], turned([0.0, 1.0, 0.0]));
    let system = System::new(&blocks, &[]).unwrap();
    let system = system.with_half_spaces(vec![ground]).unwrap();
    let settings = Settings {
        gravity: turned([3.0, -9.0, 0.5]),
        friction: Friction {
            coefficient: 0.2,
            ..Friction::default()
        },
        tolerance: Length::Absolute(1e-8),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for _ in 0..50 {
        assert!(simulation.step().unwrap().converged);
    }
    let system = simulation.system();
    let positions = system.mesh_vertices().into_iter().map(|vertex| {
        let point = simulation.state().positions[vertex as usize];
        turn.inverse() * Vector3::from(point)
    });
    (positions.collect(), system.size())
}

/// No length and no stiffness depends on the axes.
#[test]
fn a_turned_scene_has_the_same_motion() {
    let (expected, size) = motion(&Rotation3::identity());
    for angles in [[0.0, 0.0, 0.8], [0.3, -1.0, 2.0]] {
        let turn = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let (found, turned_size) = motion(&turn);
        assert!((turned_size / size - 1.0).abs() < 1e-8, "{turned_size} {size}");
        let pairs = found.iter().zip(&expected);
        let apart = pairs.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
        assert!(apart < 1e-7, "{angles:?}: {apart} m");
    }
}
