//! The derivatives of friction.

use arrayvec::ArrayVec;
use nalgebra::Vector3;

use super::differences::{at, check, random_points, slope};
use crate::energies::distance::point_triangle;
use crate::energies::friction::{FrictionContact, Smoothing};

const SMOOTHING: Smoothing = Smoothing { threshold: 0.8 };

#[test]
fn the_derivatives_of_the_smoothing_match_differences() {
    for i in 1..200 {
        let slip = 0.01 * f64::from(i);
        let force = |y: f64| y * SMOOTHING.force_over_slip(y);
        let step = 1e-5;
        let slope = (SMOOTHING.potential(slip + step) - SMOOTHING.potential(slip - step)) / (2.0 * step);
        assert!((force(slip) - slope).abs() < 1e-8);
        let slope = (force(slip + step) - force(slip - step)) / (2.0 * step);
        assert!((SMOOTHING.stiffness(slip) - slope).abs() < 2e-5);
    }
    assert_eq!(SMOOTHING.force_over_slip(4.0), 0.25);
}

#[test]
fn the_derivatives_of_friction_match_differences() {
    let mut random = fastrand::Rng::with_seed(1);
    for _ in 0..100 {
        let points = random_points(&mut random);
        let shortest = point_triangle(&points).shortest_vector(&points);
        let vertices = ArrayVec::from([0, 1, 2, 3]);
        let contact = FrictionContact::new(vertices, &at(&points), &shortest, 0.7, SMOOTHING);
        let displacements = random_points(&mut random).map(|x| x * 0.5);
        let moved = core::array::from_fn(|place| points[place] + displacements[place]);
        check(&contact, &moved, 1e-4, [1e-7, 2e-4], "friction");
        // The force opposes the slip and is tangential. The sum over the vertices is zero.
        let gradient = slope(&contact, &moved);
        let force = |place: usize| gradient.fixed_rows::<3>(3 * place).into_owned();
        let power: f64 = (0..4).map(|place| force(place).dot(&displacements[place])).sum();
        assert!(power >= 0.0);
        let total: Vector3<f64> = (0..4).map(force).sum();
        assert!(total.norm() < 1e-12);
        assert!(force(0).dot(&shortest.vector).abs() < 1e-12);
        assert!(force(0).norm() <= 0.7 * (1.0 + 1e-12));
    }
}
