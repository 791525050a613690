//! The degrees of the polynomials of contact and distance.

use alloc::vec::Vec;

use fastrand::Rng;

use super::*;
use crate::exact::motion::Motion;
use crate::exact::nearness::excess_degrees;
use crate::tables::{EdgeEdge, VertexEdge, VertexFace, VertexVertex};
use crate::values::Separation;

fn point(random: &mut Rng) -> Point {
    [(); 3].map(|()| f64::from(random.i32(-99..=99)))
}

/// Motions with this number of control points of their places; one is repeated, at rest.
fn chain(random: &mut Rng, joints: usize, places: usize) -> Vec<([[f64; 4]; 2], Vec<Point>)> {
    let mut motion = || {
        let quaternions = [(); 2].map(|()| [(); 4].map(|()| f64::from(random.i32(1..=99))));
        let mut control: Vec<Point> = (0..places).map(|_| point(random)).collect();
        if places == 1 {
            control.push(control[0]);
        }
        (quaternions, control)
    };
    (0..joints).map(|_| motion()).collect()
}

/// The points of chains of joints.
fn bodies<K: Tables>(random: &mut Rng, joints: [usize; 2], places: usize) -> MovingPoints {
    let points = [(); 4].map(|()| point(random));
    let points = K::LAYOUT.map(|i: usize| points[i]);
    let chains = joints.map(|joints| chain(random, joints, places));
    let turns = [0, 1].map(|body: usize| {
        let motions = chains[body].iter();
        let turns = motions.map(|(quaternions, places)| Turn {
            quaternions: *quaternions,
            places,
        });
        turns.collect::<Vec<_>>()
    });
    MovingPoints::of_bodies::<K>(&points, [&turns[0], &turns[1]])
}

/// The degree of a polynomial without factors t + s.
fn degree(polynomial: &Polynomial) -> usize {
    let lowered = core::iter::successors(polynomial.lowered(), Polynomial::lowered);
    lowered.last().as_ref().unwrap_or(polynomial).degree()
}

/// The degree of the coplanarity polynomial, and the largest degree of an excess of two features.
fn degrees<K: Tables>(points: MovingPoints) -> [usize; 2] {
    let d = Separation::new(1.0).expect("a distance");
    let excess = excess_degrees::<K>(&points, d, degree).into_iter().max();
    [
        degree(&Motion::<K>::new(points).volume),
        excess.unwrap_or_default(),
    ]
}

fn assert_degrees(case: &str, points: impl Fn(&mut Rng, bool) -> MovingPoints, expected: [usize; 2]) {
    let mut random = Rng::with_seed(1);
    for _ in 0..20 {
        assert_eq!(
            degrees::<VertexFace>(points(&mut random, true)),
            expected,
            "{case}"
        );
        assert_eq!(
            degrees::<EdgeEdge>(points(&mut random, false)),
            expected,
            "{case}"
        );
    }
}

/// Chains of joints with places of degree p.
fn assert_degrees_of_bodies(joints: [usize; 2], p: usize, expected: [usize; 2]) {
    let points = |random: &mut Rng, is_face: bool| {
        if is_face {
            bodies::<VertexFace>(random, joints, p + 1)
        } else {
            bodies::<EdgeEdge>(random, joints, p + 1)
        }
    };
    assert_degrees(&alloc::format!("{joints:?} {p}"), points, expected);
}

#[test]
fn curves_of_degree_p_have_degree_3_p() {
    for p in 1..=8 {
        let points = |random: &mut Rng, _: bool| {
            let control: Vec<_> = (0..=p).map(|_| [(); 4].map(|()| point(random))).collect();
            MovingPoints::along(&control)
        };
        assert_degrees("curves", points, [3 * p, 6 * p]);
    }
}

#[test]
fn a_body_against_rest_has_degree_3() {
    for joints in [[1, 0], [0, 1]] {
        assert_degrees_of_bodies(joints, 1, [3, 6]);
        assert_degrees_of_bodies(joints, 2, [4, 8]);
        assert_degrees_of_bodies(joints, 3, [5, 10]);
    }
}

#[test]
fn two_bodies_have_degree_5() {
    assert_degrees_of_bodies([1, 1], 1, [5, 10]);
    assert_degrees_of_bodies([1, 1], 2, [6, 12]);
}

#[test]
fn revolute_joints_have_degree_2_each() {
    for joints in [[1, 0], [0, 2], [1, 1], [2, 1], [3, 3]] {
        let m = joints[0] + joints[1];
        assert_degrees_of_bodies(joints, 0, [2 * m, 4 * m]);
    }
}

/// The longest chains, on one side or on both: the largest degrees of all motions.
#[test]
fn chains_of_eight_motions_have_degree_2_each_and_that_of_a_place() {
    assert_degrees_of_bodies([8, 0], 0, [16, 32]);
    assert_degrees_of_bodies([8, 8], 0, [32, 64]);
    assert_degrees_of_bodies([8, 8], 3, [35, 70]);
}

#[test]
fn edges_and_vertices_have_the_degrees_of_their_differences() {
    let mut random = Rng::with_seed(1);
    let d = Separation::new(1.0).expect("a distance");
    for p in 1..=3 {
        let control: Vec<_> = (0..=p).map(|_| [(); 4].map(|()| point(&mut random))).collect();
        let points = MovingPoints::along(&control);
        let all = excess_degrees::<VertexFace>(&points, d, degree);
        assert_eq!(all, [2, 2, 2, 4, 4, 4, 6].map(|degree| degree * p));
        let points = bodies::<VertexEdge>(&mut random, [1, 1], p + 1);
        assert!(
            excess_degrees::<VertexEdge>(&points, d, degree)
                .iter()
                .all(|&degree| degree == 8 + 2 * p)
        );
        let points = bodies::<VertexVertex>(&mut random, [1, 1], p + 1);
        assert_eq!(excess_degrees::<VertexVertex>(&points, d, degree), [8 + 2 * p]);
    }
}
