//! Elastic energies.

use exact_ccd_sim::elasticity::{ElasticModuli, Hinge, Membrane, SolidMaterial, Tetrahedron};
use exact_ccd_sim::{Body, BodyKind};
use nalgebra::{Matrix3, Vector3};

use crate::differences::{
    Points, assert_gradient, assert_hessian, assert_semi_definite, gradient, jacobian, random_points,
    random_rotation, random_vector,
};

const MODULI: ElasticModuli = ElasticModuli {
    young: 3.0,
    poisson: 0.35,
};

const SOLIDS: [SolidMaterial; 2] = [SolidMaterial::NeoHookean, SolidMaterial::StableNeoHookean];

fn corner() -> Points {
    [Vector3::zeros(), Vector3::x(), Vector3::y(), Vector3::z()]
}

/// Tetrahedra at rest in the shape of `corner`, moved at random without being turned inside out.
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
fn solids_have_the_derivatives_that_they_tell() {
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
fn the_stable_solid_has_derivatives_inside_out() {
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
fn projection_is_semi_definite_and_changes_nothing_that_is() {
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

/// For small strains all solids are that of Hooke: μ |ε|² + λ/2 tr² ε.
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
fn rotations_cost_nothing() {
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
fn a_solid_inside_out_is_refused() {
    let solid = Tetrahedron::new([0, 1, 2, 3], &corner(), SolidMaterial::NeoHookean, MODULI).unwrap();
    let [a, b, c, d] = corner();
    assert_eq!(solid.value(&[a, c, b, d]), f64::INFINITY);
    assert!(Tetrahedron::new([0, 1, 2, 3], &[a, c, b, d], SolidMaterial::NeoHookean, MODULI).is_none());
    assert!(Tetrahedron::new([0, 1, 2, 3], &[a, b, c, c], SolidMaterial::NeoHookean, MODULI).is_none());
}

#[test]
fn membranes_have_the_derivatives_that_they_tell() {
    let mut random = fastrand::Rng::with_seed(6);
    let mut indefinite = 0;
    for _ in 0..50 {
        let (rest, points) = (random_points(&mut random), random_points(&mut random));
        let [a, b, c, _] = rest;
        if (b - a).cross(&(c - a)).norm() < 0.3 {
            continue;
        }
        let membrane = Membrane::new([0, 1, 2], &[a, b, c], 0.1, MODULI).unwrap();
        let three = |x: &Points| [x[0], x[1], x[2]];
        let element = membrane.derivatives(&three(&points), false);
        let expected = gradient(&points, 1e-3, |x| membrane.value(&three(x)));
        assert_gradient(&element.gradient, &expected, 1e-8, "membrane");
        let expected = jacobian(&points, 1e-3, |x| membrane.derivatives(&three(x), false).gradient);
        assert_hessian(&element.hessian, &expected, 1e-8, "membrane");
        assert_semi_definite(&membrane.derivatives(&three(&points), true).hessian, "membrane");
        indefinite += usize::from(element.hessian.symmetric_eigenvalues().min() < -1e-6);
    }
    assert!(indefinite > 5);
}

/// A square that is stretched along one side: h A (μ ε² + λ/2 ε²) with ε = (s² − 1) / 2.
#[test]
fn a_stretched_membrane_has_the_energy_of_saint_venant_and_kirchhoff() {
    let rest = [Vector3::zeros(), Vector3::x(), Vector3::y()];
    let membrane = Membrane::new([0, 1, 2], &rest, 0.1, MODULI).unwrap();
    let strain = 0.5 * (1.2_f64 * 1.2 - 1.0);
    let expected = 0.05 * (MODULI.shear() + 0.5 * MODULI.plane_lambda()) * strain * strain;
    let value = membrane.value(&rest.map(|x| Vector3::new(0.0, x.x * 1.2, -x.y)));
    assert!((value / expected - 1.0).abs() < 1e-13);
}

#[test]
fn hinges_have_the_derivatives_that_they_tell() {
    let mut random = fastrand::Rng::with_seed(7);
    for _ in 0..100 {
        let (rest, points) = (random_points(&mut random), random_points(&mut random));
        let flat = |[a, b, c, d]: Points| {
            let edge = b - a;
            edge.norm()
                .min(edge.cross(&(c - a)).norm())
                .min(edge.cross(&(d - a)).norm())
                < 0.4
        };
        let Some(hinge) = Hinge::new([0, 1, 2, 3], &rest, 1.0).filter(|_| !flat(rest) && !flat(points))
        else {
            continue;
        };
        let element = hinge.derivatives(&points, false);
        let expected = gradient(&points, 1e-4, |x| hinge.value(x));
        assert_gradient(&element.gradient, &expected, 1e-6, "hinge");
        let expected = jacobian(&points, 1e-4, |x| hinge.derivatives(x, false).gradient);
        assert_hessian(&element.hessian, &expected, 1e-6, "hinge");
        assert_semi_definite(&hinge.derivatives(&points, true).hessian, "hinge");
    }
}

/// Two unit triangles, folded by an angle about their common edge.
#[test]
fn a_fold_costs_half_the_stiffness_times_the_square_of_the_angle() {
    let rest = [Vector3::zeros(), Vector3::z(), Vector3::x(), -Vector3::x()];
    let hinge = Hinge::new([0, 1, 2, 3], &rest, 2.0).unwrap();
    for angle in [-3.0_f64, -1.0, 0.25, 2.5] {
        let mut folded = rest;
        folded[3] = Vector3::new(-angle.cos(), angle.sin(), 0.0);
        // D |e|² / A = 2 · 1 / 1.
        let expected = 0.5 * 2.0 * angle * angle;
        assert!((hinge.value(&folded) / expected - 1.0).abs() < 1e-13);
    }
}

/// A hinge that is bent at rest springs back through the flat shape, however far it is bent the other way: only where its
/// faces touch, the angle jumps.
#[test]
fn a_hinge_unbends_the_way_that_it_came() {
    let bent = |angle: f64| {
        let corner = |y: f64, z: f64| Vector3::new(0.5, y, z);
        [
            Vector3::zeros(),
            Vector3::x(),
            corner(1.0, 0.0),
            corner(-angle.cos(), angle.sin()),
        ]
    };
    let hinge = Hinge::new([0, 1, 2, 3], &bent(2.0), 1.0).unwrap();
    for angle in (-31..=31).map(|tenths| 0.1 * f64::from(tenths)) {
        // k = |e|² / A, where the edge is 1 long and both triangles together have an area of 1.
        let expected = 0.5 * (angle - 2.0).powi(2);
        let found = hinge.value(&bent(angle));
        assert!(
            (found - expected).abs() < 1e-12,
            "{angle}: {found}, expected {expected}"
        );
    }
}

/// A plate that is rolled into a cylinder of curvature κ has the energy ½ D κ² per area: one of squares along their sides, one of
/// equilateral triangles whichever way; but at the rim, where there are no hinges.
#[test]
fn a_rolled_plate_has_the_energy_of_its_curvature() {
    const RIGIDITY: f64 = 0.7;
    const CURVATURE: f64 = 0.5;
    let squares = |n: u16| exact_ccd_sim::shapes::cloth([n, n], [1.0, 1.0]);
    // Equilateral triangles, if rows are sheared and made lower.
    let triangles = |n: u16| {
        let n = u32::from(n);
        let at = |i: u32, j: u32| i + j * (n + 1);
        let points = (0..=n).flat_map(|j| (0..=n).map(move |i| (i, j)));
        let point = |(i, j): (u32, u32)| {
            let (x, z) = (f64::from(i) + 0.5 * f64::from(j), 0.75_f64.sqrt() * f64::from(j));
            Vector3::new(x, 0.0, z) / f64::from(n)
        };
        let cells = (0..n).flat_map(|j| (0..n).map(move |i| (i, j)));
        let faces = cells.flat_map(|(i, j)| {
            [
                [at(i, j), at(i, j + 1), at(i + 1, j)],
                [at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)],
            ]
        });
        (points.map(point).collect::<Vec<_>>(), faces.collect::<Vec<_>>())
    };
    let energy = |points: &[Vector3<f64>], faces: &[[u32; 3]], turn: f64| {
        let (sin, cos) = turn.sin_cos();
        let rolled = |p: &Vector3<f64>| {
            let (across, along) = (cos * p.x + sin * p.z, cos * p.z - sin * p.x);
            let angle = CURVATURE * across;
            Vector3::new(angle.sin(), 1.0 - angle.cos(), CURVATURE * along) / CURVATURE
        };
        let bent: Vec<_> = points.iter().map(rolled).collect();
        let mut energy = 0.0;
        for (place, &[a, b, c]) in faces.iter().enumerate() {
            for [from, to, left] in [[a, b, c], [b, c, a], [c, a, b]] {
                for &[a, b, c] in &faces[place + 1..] {
                    for [first, second, right] in [[a, b, c], [b, c, a], [c, a, b]] {
                        if [from, to] == [second, first] {
                            let vertices = [from, to, left, right];
                            let rest = vertices.map(|v| points[v as usize]);
                            let hinge = Hinge::new(vertices, &rest, RIGIDITY).unwrap();
                            energy += hinge.value(&vertices.map(|v| bent[v as usize]));
                        }
                    }
                }
            }
        }
        energy
    };
    let area = |points: &[Vector3<f64>], faces: &[[u32; 3]]| -> f64 {
        let area = |face: &[u32; 3]| {
            let [a, b, c] = face.map(|v| points[v as usize]);
            0.5 * (b - a).cross(&(c - a)).norm()
        };
        faces.iter().map(area).sum()
    };
    let check = |points: &[Vector3<f64>], faces: &[[u32; 3]], turn: f64, n: u16| {
        let expected = 0.5 * RIGIDITY * CURVATURE * CURVATURE * area(points, faces);
        let ratio = energy(points, faces, turn) / expected;
        // Of n rows of faces, one is at the rim.
        let rim = 3.0 / f64::from(n);
        assert!((1.0 - rim..=1.001).contains(&ratio), "{n}, {turn}: {ratio}");
    };
    for n in [10, 20] {
        let Body { points, kind, .. } = squares(n);
        let BodyKind::Shell { faces, .. } = kind else {
            panic!("cloth is a shell")
        };
        let points: Vec<_> = points.into_iter().map(Vector3::from).collect();
        for turn in [0.0, core::f64::consts::FRAC_PI_2] {
            check(&points, &faces, turn, n);
        }
        let (points, faces) = triangles(n);
        for turn in [0.0, 0.3, 1.0, 2.0] {
            check(&points, &faces, turn, n);
        }
    }
}
