//! The smallest ball around points.

use exact_ccd_mesh::Point;
use nalgebra::{Rotation3, Vector3};

use super::differences::{random_rotation, random_vector};
use crate::system::ball::diameter;

fn moved(points: &[Vector3<f64>], turn: &Rotation3<f64>, shift: Vector3<f64>) -> f64 {
    diameter(points.iter().map(|point| Point::from(turn * point + shift)))
}

/// The unit ball is the smallest one around the corners of a regular tetrahedron, an octahedron, a triangle
/// or a pair on its sphere, and any points inside it.
#[test]
fn the_smallest_ball_is_that_of_its_support() {
    let mut random = fastrand::Rng::with_seed(31);
    let corner = |x: f64, y: f64, z: f64| Vector3::new(x, y, z).normalize();
    let half = 0.75_f64.sqrt();
    let supports = [
        vec![
            corner(1.0, 1.0, 1.0),
            corner(1.0, -1.0, -1.0),
            corner(-1.0, 1.0, -1.0),
            corner(-1.0, -1.0, 1.0),
        ],
        (0..3)
            .flat_map(|axis| [Vector3::ith(axis, 1.0), Vector3::ith(axis, -1.0)])
            .collect(),
        vec![Vector3::x(), corner(-0.5, half, 0.0), corner(-0.5, -half, 0.0)],
        vec![Vector3::y(), -Vector3::y()],
    ];
    for support in supports {
        for count in [0, 1, 10, 300] {
            let inside = (0..count).map(|_| random_vector(&mut random).normalize() * random.f64());
            let mut points: Vec<_> = support.iter().copied().chain(inside).collect();
            random.shuffle(&mut points);
            let turn = random_rotation(&mut random);
            let found = moved(&points, &turn, random_vector(&mut random) * 1e3);
            assert!((found - 2.0).abs() < 3e-9, "{count}: {found}");
        }
    }
}

/// Points on a sphere, all of which are nearly as far from each other, and points in one place or on a line.
#[test]
fn points_on_spheres_and_lines_have_a_ball() {
    let mut random = fastrand::Rng::with_seed(32);
    let sphere: Vec<Vector3<f64>> = (0..20_000)
        .map(|_| random_vector(&mut random).normalize())
        .collect();
    let found = moved(&sphere, &Rotation3::identity(), Vector3::zeros());
    assert!(found < 2.0 + 3e-9 && found > 1.99, "{found}");
    let line: Vec<Vector3<f64>> = (0..100).map(|place| Vector3::repeat(f64::from(place))).collect();
    let found = moved(&line, &Rotation3::identity(), Vector3::zeros());
    assert!((found - 99.0 * 3.0_f64.sqrt()).abs() < 1e-11, "{found}");
    assert_eq!(diameter([[1.0, 2.0, 3.0]; 5].into_iter()), 0.0);
    assert_eq!(diameter(std::iter::empty()), 0.0);
    assert_eq!(diameter([[1e200; 3], [-1e200; 3]].into_iter()), f64::INFINITY);
}
