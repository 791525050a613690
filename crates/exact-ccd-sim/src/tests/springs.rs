//! The energy of springs.

use nalgebra::Vector3;

use super::differences::{at, check, curvature, random_points};
use crate::energies::spring::SpringEnergy;
use crate::energies::term::{Energy, Projection};

#[test]
fn the_derivatives_of_springs_match_differences() {
    let mut random = fastrand::Rng::with_seed(33);
    let mut compressed = 0;
    for place in 0..100 {
        let spring = SpringEnergy {
            vertices: vec![0, 1, 2],
            weights: vec![0.7, 0.3, -1.0],
            fixed: Vector3::new(0.1, 0.2, 0.0),
            stiffness: 2.0,
            length: if place % 3 == 0 { 0.0 } else { 1.5 },
        };
        let points = random_points(&mut random);
        let length = spring.vector(&at(&points)).norm();
        if length < 0.2 {
            continue;
        }
        check(&spring, &points, 1e-4, [1e-7; 2], "spring");
        let [exact, projected] = [Projection::None, Projection::SemiDefinite]
            .map(|projection| curvature(&spring, &points, projection));
        let is_compressed = length < spring.length;
        assert_eq!((projected - exact).amax() > 1e-12, is_compressed);
        compressed += usize::from(is_compressed);
    }
    assert!(compressed > 20);
}

/// Where both ends are at one place, all derivatives are finite.
#[test]
fn ends_at_one_place_have_finite_derivatives() {
    for length in [0.0, 1.0] {
        let spring = SpringEnergy {
            vertices: vec![0, 1],
            weights: vec![1.0, -1.0],
            fixed: Vector3::zeros(),
            stiffness: 2.0,
            length,
        };
        let points = [[0.5; 3]; 2];
        assert!((spring.value(&points) - length * length).abs() < 1e-15);
        assert_eq!(spring.gradient(&points).norm(), 0.0);
        let hessian = spring.hessian(&points, Projection::SemiDefinite);
        assert!(hessian.iter().all(|value| value.is_finite()));
    }
}
