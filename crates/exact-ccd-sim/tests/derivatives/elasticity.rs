//! Elastic energies of solids, and the invariance of all elastic energies under rigid motions.

use exact_ccd_sim::elasticity::{ElasticModuli, Hinge, Membrane, SolidMaterial, Tetrahedron};
use nalgebra::{Matrix3, Vector3};

use crate::differences::{
    Points, assert_gradient, assert_hessian, assert_semi_definite, gradient, jacobian, random_points,
    random_rotation, random_vector,
};

pub(crate) const MODULI: ElasticModuli = ElasticModuli {
    young: 3.0,
    poisson: 0.35,
};

const SOLIDS: [SolidMaterial; 2] = [SolidMaterial::NeoHookean, SolidMaterial::StableNeoHookean];

fn corner() -> Points {
    [Vector3::zeros(), Vector3::x(), Vector3::y(), Vector3::z()]
}

/// Random positions of a tetrahedron of positive volume.
fn deformed(random: &mut fastrand::Rng) -> Points {
    loop {
        let points = random_points(random);
        let edges = Matrix3::from_columns(&[
            points[1] - points[0],
            points[2] - points[0],
            points[3] - points[0],
        ]);
        if edges.determinant() > 0.2 {
            return points;
        }
    }
}

#[test]
fn the_derivatives_of_solids_match_differences() {
    let mut random = fastrand::Rng::with_seed(1);
    for material in SOLIDS {
        let solid = Tetrahedron::new([0, 1, 2, 3], &corner(), material, MODULI).unwrap();
        for _ in 0..50 {
            let points = deformed(&mut random);
            let element = solid.derivatives(&points, false);
            let expected = gradient(&points, 1e-3, |x| solid.value(x));
            assert_gradient(&element.gradient, &expected, 1e-7, "solid");
            let expected = jacobian(&points, 1e-3, |x| solid.derivatives(x, false).gradient);
            assert_hessian(&element.hessian, &expected, 1e-6, "solid");
        }
    }
}

#[test]
fn the_derivatives_of_the_stable_solid_match_differences_if_inverted() {
    let mut random = fastrand::Rng::with_seed(2);
    let solid = Tetrahedron::new([0, 1, 2, 3], &corner(), SolidMaterial::StableNeoHookean, MODULI).unwrap();
    for _ in 0..50 {
        let mut points = deformed(&mut random);
        points.swap(1, 2);
        let element = solid.derivatives(&points, false);
        let expected = gradient(&points, 1e-3, |x| solid.value(x));
        assert_gradient(&element.gradient, &expected, 1e-7, "inverted");
        let expected = jacobian(&points, 1e-3, |x| solid.derivatives(x, false).gradient);
        assert_hessian(&element.hessian, &expected, 1e-7, "inverted");
        assert_semi_definite(&solid.derivatives(&points, true).hessian, "inverted");
    }
}

#[test]
fn projection_is_semi_definite_and_keeps_semi_definite_hessians() {
    let mut random = fastrand::Rng::with_seed(3);
    for material in SOLIDS {
        let solid = Tetrahedron::new([0, 1, 2, 3], &corner(), material, MODULI).unwrap();
        let mut changed = 0;
        for _ in 0..100 {
            let points = deformed(&mut random);
            let exact = solid.derivatives(&points, false).hessian;
            let projected = solid.derivatives(&points, true).hessian;
            assert_semi_definite(&projected, "projected solid");
            let least = exact.symmetric_eigenvalues().min();
            if least > -1e-12 {
                assert_hessian(&projected, &exact, 1e-12, "semi-definite solid");
            } else {
                changed += 1;
                assert!((projected - exact).norm() > 0.1 * least.abs());
            }
        }
        assert!(changed > 10, "only {changed} samples were indefinite");
    }
}

/// At small strains, the energy density of all materials is that of Hooke: μ |ε|² + λ/2 tr² ε.
#[test]
fn small_strains_follow_hooke() {
    let mut random = fastrand::Rng::with_seed(4);
    for material in SOLIDS {
        let solid = Tetrahedron::new([0, 1, 2, 3], &corner(), material, MODULI).unwrap();
        for _ in 0..20 {
            let gradient = Matrix3::from_fn(|_, _| random.f64() - 0.5) * 1e-5;
            let points = corner().map(|x| x + gradient * x);
            let strain = (gradient + gradient.transpose()) * 0.5;
            let hooke =
                MODULI.shear() * strain.norm_squared() + 0.5 * MODULI.lambda() * strain.trace().powi(2);
            let error = (solid.value(&points) * 6.0 / hooke - 1.0).abs();
            assert!(error < 1e-3, "{material:?}: relative error {error}");
        }
    }
}

#[test]
fn rigid_motions_have_no_energy() {
    let mut random = fastrand::Rng::with_seed(5);
    let rest = deformed(&mut random);
    for _ in 0..20 {
        let (rotation, shift) = (random_rotation(&mut random), random_vector(&mut random));
        let points = rest.map(|x| rotation * x + shift);
        for material in SOLIDS {
            let solid = Tetrahedron::new([0, 1, 2, 3], &rest, material, MODULI).unwrap();
            assert!(solid.value(&points).abs() < 1e-13);
            assert!(solid.derivatives(&points, true).gradient.norm() < 1e-13);
        }
        let [a, b, c, _] = rest;
        let membrane = Membrane::new([0, 1, 2], &[a, b, c], 0.1, MODULI).unwrap();
        assert!(membrane.value(&[points[0], points[1], points[2]]) < 1e-25);
        let hinge = Hinge::new([0, 1, 2, 3], &rest, 1.0).unwrap();
        assert!(hinge.value(&points) < 1e-25);
    }
}

#[test]
fn inverted_tetrahedra_are_rejected() {
    let solid = Tetrahedron::new([0, 1, 2, 3], &corner(), SolidMaterial::NeoHookean, MODULI).unwrap();
    let [a, b, c, d] = corner();
    assert_eq!(solid.value(&[a, c, b, d]), f64::INFINITY);
    assert!(Tetrahedron::new([0, 1, 2, 3], &[a, c, b, d], SolidMaterial::NeoHookean, MODULI).is_none());
    assert!(Tetrahedron::new([0, 1, 2, 3], &[a, b, c, c], SolidMaterial::NeoHookean, MODULI).is_none());
}
