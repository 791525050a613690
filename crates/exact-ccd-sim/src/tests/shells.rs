//! Elastic energies of shells.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, Matrix6, Vector2, Vector3};

use super::differences::{Points, at, check, curvature, random_points, random_rotation};
use super::elasticity::MODULI;
use crate::energies::elasticity::{Hinge, Membrane, StrainLimit};
use crate::energies::term::{Energy, Projection};
use crate::{Body, BodyKind};

#[test]
fn the_derivatives_of_membranes_match_differences() {
    let mut random = fastrand::Rng::with_seed(6);
    let mut indefinite = 0;
    for _ in 0..50 {
        let (rest, points) = (random_points(&mut random), random_points(&mut random));
        let [a, b, c, _] = rest;
        if (b - a).cross(&(c - a)).norm() < 0.3 {
            continue;
        }
        let membrane = Membrane::new([0, 1, 2], &at(&rest), 0.1, MODULI).unwrap();
        indefinite += usize::from(check(&membrane, &points, 1e-3, [1e-8; 2], "membrane") < -1e-6);
    }
    assert!(indefinite > 5);
}

/// The limit is three tenths of the strain. Stretches are up to its 0.97th part, and some are compressions.
#[test]
fn the_derivatives_of_limited_membranes_match_differences() {
    let mut random = fastrand::Rng::with_seed(16);
    let rest = [[0.0; 3], [1.0, 0.1, 0.0], [0.2, 0.9, 0.1]];
    let limit = StrainLimit::new(0.3, 1.5);
    let membrane = |limit| {
        let membrane = Membrane::new([0, 1, 2], &rest, 0.1, MODULI).unwrap();
        membrane.with_limit(limit)
    };
    let (free, limited) = (membrane(None), membrane(Some(limit)));
    let mut active = 0;
    for round in 0..60 {
        let turn = random_rotation(&mut random);
        let about = random_rotation(&mut random);
        let mut stretches = Vector3::from_fn(|_, _| 0.7 + 0.59 * random.f64());
        if round % 6 == 0 {
            // Twice the same stretch.
            stretches.fill(1.0 + 0.28 * random.f64());
        }
        let deformation = turn.matrix() * Matrix3::from_diagonal(&stretches) * about.matrix();
        let corner = |place: usize| deformation * Vector3::from(rest[place]);
        let points = [corner(0), corner(1), corner(2), Vector3::zeros()];
        check(&limited, &points, 1e-5, [1e-6; 2], "limited membrane");
        // The energy of the limit is convex.
        let projection = Projection::None;
        let own = curvature(&limited, &points, projection) - curvature(&free, &points, projection);
        let eigenvalues = own.symmetric_eigenvalues();
        assert!(eigenvalues.min() >= -1e-12 * eigenvalues.amax(), "{eigenvalues}");
        let [with, without] = [&limited, &free].map(|energy| energy.value(&at(&points)));
        active += usize::from(with > without);
        assert!(with >= without);
    }
    assert!(active > 30, "{active}");
    let at_limit = rest.map(|[x, y, z]| [1.3 * x, 1.3 * y, 1.3 * z]);
    let beyond = at_limit.map(|point| point.map(|x| 1.001 * x));
    assert_eq!(limited.value(&beyond), f64::INFINITY);
    assert!(
        limited
            .value(&at_limit.map(|point| point.map(|x| 0.999 * x)))
            .is_finite()
    );
}

/// The quotient of the differences of s and λ is the mean of s′ between both: by a rule of Gauss with three
/// points, which is exact for polynomials of fifth degree.
#[test]
fn the_quotient_of_limited_stresses_is_a_mean_of_slopes() {
    let nodes = [-0.6_f64.sqrt(), 0.0, 0.6_f64.sqrt()].map(|node| 0.5 * (1.0 + node));
    let weights = [5.0, 8.0, 5.0].map(|weight| weight / 18.0);
    for limit in [1e-6, 1e-4, 0.05, 0.5] {
        let law = StrainLimit::new(limit, 1.5);
        let larger = (1.0 + 0.5 * limit) * (1.0 + 0.5 * limit);
        // Relative differences of λ, up to a fifth of that from the state without strain.
        let differences = (-16..0).map(|exponent| 10_f64.powf(f64::from(exponent)));
        for difference in differences.filter(|difference| *difference < 0.2 * limit) {
            let smaller = larger * (1.0 - difference);
            let slope = |square: f64| law.principal(&Vector2::repeat(square)).slopes.x;
            let means = nodes.iter().zip(weights);
            let expected: f64 = means
                .map(|(node, weight)| weight * slope(smaller + node * (larger - smaller)))
                .sum();
            let found = law.principal(&Vector2::new(larger, smaller)).quotient;
            let error = (found - expected).abs();
            assert!(
                error < 2e-6 * expected,
                "{limit} {difference}: {error} of {expected}"
            );
        }
    }
}

/// F has the columns x_b − x_a and x_c − x_a for a triangle of two unit sides: the blocks of b and c are the
/// second derivatives by F. The projection is that to the nearest matrix, by the eigenvalues of all six
/// coordinates; also for stretches near a limit, for triangles without area, and for equal stretches.
#[test]
fn the_projected_hessian_of_a_membrane_is_the_nearest_one() {
    let mut random = fastrand::Rng::with_seed(21);
    let rest = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let free = || Membrane::new([0, 1, 2], &rest, 0.1, MODULI).unwrap();
    let limited = free().with_limit(Some(StrainLimit::new(0.5, 1.5)));
    let mut indefinite = 0;
    for round in 0..250 {
        let [x, y, z] = [0; 3].map(|_| 1.4 * random.f64());
        let stretches = match round % 4 {
            0 => [x, y, z],
            1 => [x, 0.0, 0.0],
            2 => [x, x, x],
            _ => [x, 1e-9 * y, 0.0],
        };
        let [turn, about] = [0; 2].map(|_| random_rotation(&mut random));
        let deformation = turn.matrix() * Matrix3::from_diagonal(&stretches.into()) * about.matrix();
        let corner = |place: usize| deformation * Vector3::from(rest[place]);
        let mut points = [corner(0), corner(1), corner(2), Vector3::zeros()];
        if round % 5 == 4 {
            // Exactly on a line, in a direction in which products round.
            points[1] = Vector3::new(0.6, -0.15, 0.3) * x;
            points[2] = points[1] * 0.75;
        }
        for membrane in [&free(), &limited] {
            let [exact, found] = [Projection::None, Projection::SemiDefinite].map(|projection| {
                let hessian = curvature(membrane, &points, projection);
                hessian.fixed_view::<6, 6>(3, 3).into_owned()
            });
            let eigen = exact.symmetric_eigen();
            let values = eigen.eigenvalues.map(|value| value.max(0.0));
            let expected =
                eigen.eigenvectors * Matrix6::from_diagonal(&values) * eigen.eigenvectors.transpose();
            indefinite += usize::from(eigen.eigenvalues.min() < -1e-6);
            let error = (found - expected).amax();
            assert!(error < 1e-12 * exact.amax(), "{round}: {error} of {exact}");
        }
        // Without a limit, the energy is a polynomial of fourth degree also where the triangle has no area.
        check(&free(), &points, 1e-3, [1e-7; 2], "membrane");
    }
    assert!(indefinite > 100, "{indefinite}");
}

/// The energy of a triangle that is stretched along one side is h A (μ ε² + λ/2 ε²) with ε = (s² − 1) / 2.
#[test]
fn a_stretched_membrane_has_the_energy_of_saint_venant_and_kirchhoff() {
    let rest = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let membrane = Membrane::new([0, 1, 2], &rest, 0.1, MODULI).unwrap();
    let strain = 0.5 * (1.2_f64 * 1.2 - 1.0);
    let expected = 0.05 * (MODULI.shear() + 0.5 * MODULI.plane_lambda()) * strain * strain;
    let value = membrane.value(&rest.map(|[x, y, _]| [0.0, x * 1.2, -y]));
    assert!((value / expected - 1.0).abs() < 1e-13);
}

#[test]
fn the_derivatives_of_hinges_match_differences() {
    let mut random = fastrand::Rng::with_seed(7);
    let mut tested = 0;
    for _ in 0..100 {
        let (rest, points) = (random_points(&mut random), random_points(&mut random));
        let flat = |[a, b, c, d]: Points| {
            let edge = b - a;
            edge.norm()
                .min(edge.cross(&(c - a)).norm())
                .min(edge.cross(&(d - a)).norm())
                < 0.4
        };
        let Some(hinge) = Hinge::new([0, 1, 2, 3], &at(&rest), 1.0).filter(|_| !flat(rest) && !flat(points))
        else {
            continue;
        };
        check(&hinge, &points, 1e-4, [1e-6; 2], "hinge");
        tested += 1;
    }
    assert!(tested > 30, "{tested}");
}

/// Two triangles, folded by an angle about their common edge.
#[test]
fn the_energy_of_a_fold_is_half_the_stiffness_times_the_square_of_the_angle() {
    let rest = [Vector3::zeros(), Vector3::z(), Vector3::x(), -Vector3::x()];
    let hinge = Hinge::new([0, 1, 2, 3], &at(&rest), 2.0).unwrap();
    for angle in [-3.0_f64, -1.0, 0.25, 2.5] {
        let mut folded = rest;
        folded[3] = Vector3::new(-angle.cos(), angle.sin(), 0.0);
        // D |e|² / A = 2 · 1 / 1.
        let expected = 0.5 * 2.0 * angle * angle;
        assert!((hinge.value(&at(&folded)) / expected - 1.0).abs() < 1e-13);
    }
}

/// The angle of a hinge that is bent at rest is continuous through the flat shape, up to the angles at which
/// the faces touch.
#[test]
fn the_angle_of_a_hinge_is_continuous_between_touching_faces() {
    let bent = |angle: f64| {
        let corner = |y: f64, z: f64| Vector3::new(0.5, y, z);
        [
            Vector3::zeros(),
            Vector3::x(),
            corner(1.0, 0.0),
            corner(-angle.cos(), angle.sin()),
        ]
    };
    let hinge = Hinge::new([0, 1, 2, 3], &at(&bent(2.0)), 1.0).unwrap();
    for angle in (-31..=31).map(|tenths| 0.1 * f64::from(tenths)) {
        // k = |e|² / A = 1: the edge has length 1, and the triangles together have area 1.
        let expected = 0.5 * (angle - 2.0).powi(2);
        let found = hinge.value(&at(&bent(angle)));
        assert!(
            (found - expected).abs() < 1e-12,
            "{angle}: {found}, expected {expected}"
        );
    }
}

/// A plate that is rolled into a cylinder of curvature κ has the energy ½ D κ² per area, except at the rim,
/// which has no hinges. The plates are a grid of squares, rolled along a side, and a grid of equilateral
/// triangles, rolled along any direction.
#[test]
fn a_rolled_plate_has_the_energy_of_its_curvature() {
    const RIGIDITY: f64 = 0.7;
    const CURVATURE: f64 = 0.5;
    let squares = |n: u16| crate::shapes::cloth([n, n], [1.0, 1.0]);
    // The triangles are equilateral: rows of a grid are shifted and have the height √¾.
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
        let bent: Vec<Point> = points.iter().map(|point| rolled(point).into()).collect();
        let flat: Vec<Point> = points.iter().map(|&point| point.into()).collect();
        let mut energy = 0.0;
        for (place, &[a, b, c]) in faces.iter().enumerate() {
            for [from, to, left] in [[a, b, c], [b, c, a], [c, a, b]] {
                for &[a, b, c] in &faces[place + 1..] {
                    for [first, second, right] in [[a, b, c], [b, c, a], [c, a, b]] {
                        if [from, to] == [second, first] {
                            let vertices = [from, to, left, right];
                            let hinge = Hinge::new(vertices, &flat, RIGIDITY).unwrap();
                            energy += hinge.value(&bent);
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
        // One of n rows of faces is at the rim.
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
