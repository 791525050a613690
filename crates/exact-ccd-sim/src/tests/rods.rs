//! Elastic energies of rods.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::differences::{
    Points, at, check, curvature, random_points, random_rotation, random_vector, slope,
};
use crate::energies::elasticity::{RodBend, Stretch};
use crate::energies::term::{Energy, Projection};

/// cos φ of the angle φ between two successive edges.
fn cosine(points: &Points) -> f64 {
    let [a, b] = [points[1] - points[0], points[2] - points[1]];
    a.dot(&b) / (a.norm() * b.norm())
}

#[test]
fn the_derivatives_of_stretching_match_differences() {
    let mut random = fastrand::Rng::with_seed(21);
    let mut compressed = 0;
    for _ in 0..100 {
        let (rest, points) = (random_points(&mut random), random_points(&mut random));
        let lengths = [rest, points].map(|x| (x[1] - x[0]).norm());
        if lengths.into_iter().any(|length| length < 0.3) {
            continue;
        }
        let stretch = Stretch::new([0, 1], &at(&rest), 5.0).unwrap();
        check(&stretch, &points, 1e-3, [1e-8, 1e-7], "stretch");
        let [exact, projected] = [Projection::None, Projection::SemiDefinite]
            .map(|projection| curvature(&stretch, &points, projection));
        // The projection changes the Hessian of compressed edges only.
        let is_compressed = lengths[1] < lengths[0];
        assert_eq!((projected - exact).amax() > 1e-12, is_compressed);
        compressed += usize::from(is_compressed);
    }
    assert!(compressed > 20);
}

#[test]
fn a_stretched_edge_has_the_energy_of_a_bar() {
    let stretch = Stretch::new([0, 1], &[[0.0; 3], [2.0, 0.0, 0.0]], 7.0).unwrap();
    let turn = random_rotation(&mut fastrand::Rng::with_seed(22));
    let value = stretch.value(&[Vector3::y(), Vector3::y() + turn * Vector3::x() * 2.5].map(Point::from));
    // ½ E A ε² L.
    assert!((value / (0.5 * 7.0 * 0.25 * 0.25 * 2.0) - 1.0).abs() < 1e-13);
}

#[test]
fn the_derivatives_of_bending_match_differences() {
    let mut random = fastrand::Rng::with_seed(23);
    let (mut tested, mut indefinite) = (0, 0);
    while tested < 200 {
        let (rest, points) = (random_points(&mut random), random_points(&mut random));
        let is_good = |x: &Points| {
            let shortest = (x[1] - x[0]).norm().min((x[2] - x[1]).norm());
            shortest > 0.4 && (-0.7..0.9).contains(&cosine(x))
        };
        if !is_good(&rest) || !is_good(&points) {
            continue;
        }
        tested += 1;
        // Every other rod is straight at rest.
        let straight = [rest[0], rest[1], rest[1] * 2.0 - rest[0], rest[3]];
        let rest = if tested % 2 == 0 { rest } else { straight };
        let bend = RodBend::new([0, 1, 2], &at(&rest), 3.0).unwrap();
        indefinite += usize::from(check(&bend, &points, 1e-4, [1e-7; 2], "bend") < -1e-6);
    }
    assert!(indefinite > 20, "{indefinite}");
}

/// Near the straight shape, cos φ is 1 up to rounding; the energy still has all digits.
#[test]
fn slight_bending_keeps_its_digits() {
    let bend = RodBend::new([0, 1, 2], &[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], 2.0).unwrap();
    for angle in [1e-9, 1e-6, 1e-3, 0.1, 1.0, 3.0_f64] {
        let end = Vector3::new(angle.cos(), angle.sin(), 0.0);
        let points = [Vector3::zeros(), Vector3::x(), Vector3::x() + end].map(Point::from);
        let expected = 2.0 / 2.0 * (2.0 * (0.5 * angle).tan()).powi(2);
        let value = bend.value(&points);
        // The rounding of the points alone is ε / angle.
        assert!(
            (value / expected - 1.0).abs() < 4e-16 / angle + 1e-13,
            "{angle}: {value}"
        );
    }
}

/// A straight rod, rolled into a circle of radius R, has the energy ½ E I / R² of a beam for each length.
#[test]
fn a_rod_that_is_rolled_into_a_circle_has_the_energy_of_a_beam() {
    let errors = [20, 40].map(|count: u32| {
        let angle = core::f64::consts::TAU / f64::from(count);
        let edge = 2.0 * (0.5 * angle).sin();
        let straight = [0.0, 1.0, 2.0].map(|place| [place * edge, 0.0, 0.0]);
        let circle = [0.0, 1.0, 2.0].map(|place: f64| {
            let (sine, cosine) = (place * angle).sin_cos();
            [cosine, sine, 0.0]
        });
        let bend = RodBend::new([0, 1, 2], &straight, 3.0).unwrap();
        let whole = bend.value(&circle) * f64::from(count);
        let beam = 0.5 * 3.0 * core::f64::consts::TAU;
        // The rod is straight again without energy, and a ring has none at rest.
        assert_eq!(bend.value(&straight), 0.0);
        let ring = RodBend::new([0, 1, 2], &circle, 3.0).unwrap();
        assert!(ring.value(&circle) < 1e-28);
        whole / beam - 1.0
    });
    assert!(
        errors[0].abs() < 0.025 && (3.5..4.5).contains(&(errors[0] / errors[1])),
        "{errors:?}"
    );
}

/// Energies are the same after a rigid motion; forces and moments of a rod sum to zero.
#[test]
fn rods_are_invariant_under_rigid_motions() {
    let mut random = fastrand::Rng::with_seed(24);
    for _ in 0..50 {
        let (rest, points) = (random_points(&mut random), random_points(&mut random));
        let (turn, shift) = (random_rotation(&mut random), random_vector(&mut random));
        let moved = points.map(|x| turn * x + shift);
        let stretch = Stretch::new([0, 1], &at(&rest), 1.0).unwrap();
        let bend = RodBend::new([0, 1, 2], &at(&rest), 1.0).unwrap();
        let values = [&points, &moved].map(|x| stretch.value(&at(x)) + bend.value(&at(x)));
        assert!(
            (values[0] - values[1]).abs() < 1e-9 * (1.0 + values[0]),
            "{values:?}"
        );
        let forces = slope(&stretch, &points) + slope(&bend, &points);
        let force = |place: usize| forces.fixed_rows::<3>(3 * place).into_owned();
        let scale = forces.norm();
        assert!((force(0) + force(1) + force(2)).norm() < 1e-12 * scale);
        let moment: Vector3<f64> = (0..3).map(|place| points[place].cross(&force(place))).sum();
        assert!(moment.norm() < 1e-12 * scale);
    }
}

/// A rod that is folded onto itself has infinite energy, and no derivatives that are not finite.
#[test]
fn degenerate_rods_have_finite_derivatives() {
    fn is_finite(energy: &dyn Energy, points: &[Point]) -> bool {
        let hessian = energy.hessian(points, Projection::SemiDefinite);
        let gradient = energy.gradient(points);
        gradient.iter().chain(&hessian).all(|x| x.is_finite())
    }
    let [o, x, xx, xy] = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
    let bend = RodBend::new([0, 1, 2], &[o, x, xx], 1.0).unwrap();
    for points in [[o, x, o], [o, o, x], [x, x, x]] {
        assert_eq!(bend.value(&points), f64::INFINITY);
        assert!(is_finite(&bend, &points));
        assert!(RodBend::new([0, 1, 2], &points, 1.0).is_none());
    }
    let stretch = Stretch::new([0, 1], &[o, x], 1.0).unwrap();
    assert_eq!(
        (stretch.value(&[o, o]), stretch.gradient(&[o, o]).amax()),
        (0.5, 0.0)
    );
    assert!(is_finite(&stretch, &[o, o]));
    assert!(Stretch::new([0, 1], &[x, x], 1.0).is_none());
    // A straight rod that is curved at rest is at a peak of its energy.
    let curved = RodBend::new([0, 1, 2], &[o, x, xy], 1.0).unwrap();
    assert!(is_finite(&curved, &[o, x, xx]));
}
