//! The map from unknowns to vertices, and volume integrals.

use exact_ccd_mesh::Point;
use nalgebra::{DVector, Matrix3, Vector3};

use super::differences::{random_points, random_rotation, random_vector};
use super::elasticity::MODULI;
use crate::carriers::{Carrier, Carriers};
use crate::energies::elasticity::{SolidMaterial, Tetrahedron};
use crate::energies::term::Projection;
use crate::moments::{Moments, is_closed};
use crate::shapes;

/// A tetrahedron with one vertex of its own and three that four nodes carry: its first and second derivatives
/// along a motion of the unknowns follow from the collected gradient and the pulled Hessian.
#[test]
fn derivatives_by_nodes_are_those_of_the_composition() {
    let mut random = fastrand::Rng::with_seed(31);
    for _ in 0..20 {
        let mut carriers = Carriers::default();
        let carrier = |random: &mut fastrand::Rng| {
            let [a, b, c] = [0; 3].map(|_| random.f64() - 0.5);
            let weights = [1.0 - a - b - c, a, b, c];
            Carrier { first: 4, weights }
        };
        carriers.add(1, [0; 3].map(|_| carrier(&mut random)));
        assert_eq!(carriers.nodes(&carriers.bodies()[0]), [4, 5, 6, 7]);
        let rest = random_points(&mut random).map(Point::from);
        let mut corners = [0, 1, 2, 3];
        if Tetrahedron::new(corners, &rest).is_none() {
            corners = [0, 2, 1, 3];
        }
        let element = Tetrahedron::new(corners, &rest).unwrap();
        let term = SolidMaterial::StableNeoHookean.energy(element, MODULI);
        let points: Vec<Vector3<f64>> = (0..8).map(|_| random_vector(&mut random)).collect();
        let motion: Vec<Vector3<f64>> = (0..8).map(|_| random_vector(&mut random)).collect();
        let at = |time: f64| -> Vec<Point> {
            let moved = points.iter().zip(&motion).map(|(x, v)| (x + v * time).into());
            let mut moved: Vec<Point> = moved.collect();
            carriers.carry(&mut moved);
            moved
        };
        let slope = |time: f64| {
            let gradient = term.gradient(&at(time));
            let mut forces = vec![Vector3::zeros(); 8];
            for (place, &vertex) in term.vertices().iter().enumerate() {
                forces[vertex as usize] += gradient.fixed_rows::<3>(3 * place);
            }
            carriers.collect(&mut forces);
            assert!(forces[1..4].iter().all(|force| *force == Vector3::zeros()));
            forces.iter().zip(&motion).map(|(f, v)| f.dot(v)).sum::<f64>()
        };
        let h = 1e-5;
        let expected = (term.value(&at(h)) - term.value(&at(-h))) / (2.0 * h);
        let found = slope(0.0);
        assert!(
            (found - expected).abs() < 1e-6 * (1.0 + found.abs()),
            "{found} {expected}"
        );

        let expected = (slope(h) - slope(-h)) / (2.0 * h);
        let unknowns = carriers.unknowns(term.vertices());
        assert_eq!(unknowns[..], [0, 4, 5, 6, 7]);
        let hessian = carriers.pulled(term.vertices(), term.hessian(&at(0.0), Projection::None));
        let along = unknowns
            .iter()
            .flat_map(|&v| <[f64; 3]>::from(motion[v as usize]));
        let along = DVector::from_iterator(15, along);
        let found = along.dot(&(hessian * &along));
        assert!(
            (found - expected).abs() < 1e-5 * (1.0 + found.abs()),
            "{found} {expected}"
        );
    }
}

/// Translations of the nodes translate carried vertices without rounding, where the sums are exact.
#[test]
fn nodes_that_move_alike_move_the_body() {
    let mut carriers = Carriers::default();
    let weights = [0.1, 0.2, 0.3, 0.4];
    carriers.add(0, [Carrier { first: 1, weights }]);
    let mut shifts = vec![Vector3::new(1.1, -2.3, 1e9); 5];
    shifts[0] = Vector3::zeros();
    carriers.carry(&mut shifts);
    assert_eq!(shifts[0], shifts[1]);
}

/// The moments of a box that is turned and far from the origin, by theory.
#[test]
fn the_moments_of_a_box_are_exact() {
    let mut random = fastrand::Rng::with_seed(32);
    let turn = random_rotation(&mut random);
    let sides = Vector3::new(1.0, 2.0, 3.0);
    let center = Vector3::new(50.0, -20.0, 30.0);
    let corner = |place: usize| [0, 1, 2].map(|axis| (place >> axis & 1) as f64 - 0.5);
    // A vertex of another body, far away, is not at any corner.
    let far = [1e9, -1e9, 1e9];
    let points: Vec<Point> = (0..8)
        .map(|place| (center + turn * Vector3::from(corner(place)).component_mul(&sides)).into())
        .collect();
    let points = [vec![far], points].concat();
    let faces = [
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ]
    .map(|face: [u32; 3]| face.map(|corner| corner + 1));
    assert!(is_closed(&faces));
    assert!(!is_closed(&faces[1..]));
    let moments = Moments::new(&points, &faces);
    assert!((moments.volume - 6.0).abs() < 1e-12);
    assert!((moments.center - center).norm() < 1e-12);
    let squares = sides.component_mul(&sides) / 12.0;
    let expected = turn * Matrix3::from_diagonal(&squares) * turn.transpose();
    assert!((moments.covariance - expected).norm() < 1e-12);
}

/// The generated torus is closed, and its normals point outward.
#[test]
fn a_torus_encloses_its_volume() {
    let torus = shapes::torus([200, 100], 1.0, 0.25);
    let crate::BodyKind::Obstacle { faces } = &torus.kind else {
        panic!("a torus is an obstacle");
    };
    assert!(is_closed(faces));
    let expected = 2.0 * core::f64::consts::PI.powi(2) * 0.25 * 0.25;
    let volume = Moments::new(&torus.points, faces).volume;
    assert!((volume / expected - 1.0).abs() < 2e-3, "{volume}");
}
