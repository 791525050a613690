//! Elastic energies of solids, and the invariance of all elastic energies under rigid motions.

use nalgebra::{Matrix3, Vector3};

use super::differences::{
    Points, assert_hessian, assert_semi_definite, at, check, curvature, random_points, random_rotation,
    random_vector, slope,
};
use std::sync::Arc;

use crate::energies::elasticity::{ElasticModuli, Hinge, Membrane, SolidMaterial, Tetrahedron};
use crate::energies::term::{Energy, Projection};

pub(crate) const MODULI: ElasticModuli = ElasticModuli {
    young: 3.0,
    poisson: 0.35,
};

fn solid(rest: &Points, material: SolidMaterial) -> Option<Arc<dyn Energy>> {
    let element = Tetrahedron::new([0, 1, 2, 3], &at(rest))?;
    Some(material.energy(element, MODULI))
}

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
    for material in SolidMaterial::ALL {
        let solid = solid(&corner(), material).unwrap();
        for _ in 0..50 {
            let points = deformed(&mut random);
            check(&*solid, &points, 1e-3, [1e-7, 1e-6], "solid");
        }
    }
}

#[test]
fn the_derivatives_of_solids_that_can_invert_match_differences_if_inverted() {
    let mut random = fastrand::Rng::with_seed(2);
    for material in [
        SolidMaterial::StableNeoHookean,
        SolidMaterial::SaintVenantKirchhoff,
    ] {
        let solid = solid(&corner(), material).unwrap();
        for _ in 0..50 {
            let mut points = deformed(&mut random);
            points.swap(1, 2);
            check(&*solid, &points, 1e-3, [1e-7; 2], "inverted");
        }
    }
}

#[test]
fn projection_is_semi_definite_and_keeps_semi_definite_hessians() {
    let mut random = fastrand::Rng::with_seed(3);
    for material in SolidMaterial::ALL {
        let solid = solid(&corner(), material).unwrap();
        let mut changed = 0;
        for _ in 0..100 {
            let points = deformed(&mut random);
            let exact = curvature(&*solid, &points, Projection::None);
            let projected = curvature(&*solid, &points, Projection::SemiDefinite);
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

/// At small strains, all materials have the energy density of Hooke: μ |ε|² + λ/2 tr² ε.
#[test]
fn small_strains_follow_hooke() {
    let mut random = fastrand::Rng::with_seed(4);
    for material in SolidMaterial::ALL {
        let solid = solid(&corner(), material).unwrap();
        for _ in 0..20 {
            let gradient = Matrix3::from_fn(|_, _| random.f64() - 0.5) * 1e-5;
            let points = corner().map(|x| x + gradient * x);
            let strain = (gradient + gradient.transpose()) * 0.5;
            let hooke =
                MODULI.shear() * strain.norm_squared() + 0.5 * MODULI.lame().lambda * strain.trace().powi(2);
            let error = (solid.value(&at(&points)) * 6.0 / hooke - 1.0).abs();
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
        for material in SolidMaterial::ALL {
            let solid = solid(&rest, material).unwrap();
            assert!(solid.value(&at(&points)).abs() < 1e-13);
            assert!(slope(&*solid, &points).norm() < 1e-13);
        }
        let membrane = Membrane::new([0, 1, 2], &at(&rest), 0.1, MODULI).unwrap();
        assert!(membrane.value(&at(&points)) < 1e-25);
        let hinge = Hinge::new([0, 1, 2, 3], &at(&rest), 1.0).unwrap();
        assert!(hinge.value(&at(&points)) < 1e-25);
    }
}

#[test]
fn inverted_tetrahedra_are_rejected() {
    let element = solid(&corner(), SolidMaterial::NeoHookean).unwrap();
    let [a, b, c, d] = corner();
    assert_eq!(element.value(&at(&[a, c, b, d])), f64::INFINITY);
    assert!(solid(&[a, c, b, d], SolidMaterial::NeoHookean).is_none());
    assert!(solid(&[a, b, c, c], SolidMaterial::NeoHookean).is_none());
}
