//! The answers to hard cases agree with the definition.

use exact_ccd::batch::Queries;
use exact_ccd::{EdgeEdge, Query, Separation, Stage, VertexEdge, VertexFace, VertexVertex};

use exact_ccd_testing::definition::assert_defined;
use exact_ccd_testing::hard_cases::hard::Hard;
use exact_ccd_testing::hard_cases::{Case, cases, families};

/// The number of queries of each family, for contact and within a distance.
const COUNT: usize = if cfg!(debug_assertions) { 4 } else { 40 };

fn are_defined<K: Hard>() {
    for Case { query, distance, .. } in cases::<K>(COUNT) {
        assert_defined(&query, distance);
    }
}

#[test]
fn a_vertex_and_a_face() {
    are_defined::<VertexFace>();
}

#[test]
fn two_edges() {
    are_defined::<EdgeEdge>();
}

#[test]
fn a_vertex_and_an_edge() {
    are_defined::<VertexEdge>();
}

#[test]
fn two_vertices() {
    are_defined::<VertexVertex>();
}

/// A batch of all cases, so that hard ones are side by side with others, answers as one by one.
fn batches_are_defined<K: Hard>() {
    let cases: Vec<Case<K>> = cases(7).collect();
    for d in [Separation::ZERO, Separation::new(1.0).expect("a distance")] {
        let queries: Vec<_> = cases.iter().map(|case| *case.query.points()).collect();
        let mut found = vec![None; queries.len()];
        Queries::<K>::new(&queries)
            .collisions(d, |index, collision| found[index] = Some(collision.time()))
            .expect("one distance for all");
        for (case, found) in cases.iter().zip(found) {
            let first = case.query.collision(d).map(|collision| collision.time());
            assert_eq!(found, first, "{}: {:?}", case.class, case.query);
        }
    }
}

#[test]
fn batches_of_hard_cases_answer_as_single_queries() {
    batches_are_defined::<VertexFace>();
    batches_are_defined::<EdgeEdge>();
    batches_are_defined::<VertexEdge>();
    batches_are_defined::<VertexVertex>();
}

/// Some queries of each family collide. Hence no family is a list of queries far from contact.
fn some_collide<K: Hard>() {
    for (class, _) in families::<K>() {
        let mut cases = cases::<K>(100).filter(|case| case.class == class);
        assert!(cases.any(|case| case.query.collides(case.distance)), "{class}");
    }
}

#[test]
fn some_queries_of_each_family_collide() {
    some_collide::<VertexFace>();
    some_collide::<EdgeEdge>();
    some_collide::<VertexEdge>();
    some_collide::<VertexVertex>();
}

/// The filters do not settle some queries of the families that are closest to contact.
fn some_need_integers<K: Hard>() {
    let hard = [
        "tangent",
        "flat extremum",
        "flat extremum, neighbours",
        "narrow miss",
    ];
    for class in hard {
        let of_class = cases::<K>(100).filter(|case| case.class == class);
        let settled_last = of_class.filter(|case| case.query.decide(case.distance).1 == Stage::Exact);
        assert!(settled_last.count() > 5, "{class}");
    }
}

#[test]
fn some_queries_need_the_integers() {
    some_need_integers::<VertexFace>();
    some_need_integers::<EdgeEdge>();
}

/// The vertex reaches the plane and a side of a moving face at t = 1 / (p + 1), for the prime p = 2⁶¹ − 2373
/// by which common factors are ruled out. With u = 1 − t, the cubic and the side have the factor u − p t in
/// common. It is a constant modulo p.
#[test]
fn a_common_factor_that_vanishes_modulo_the_prime() {
    let far = 2f64.powi(61) - 2560.0;
    let face = |x: f64| [[x, 0.0, x], [x + 1.0, 0.0, x], [x, 1.0, x]];
    let [[a, b, c], [d, e, f]] = [face(0.0), face(187.0)];
    let start = [[1.0, 0.25, 1.0], a, b, c];
    let end = [[-far, 0.25, -far], d, e, f];
    let query = Query::<VertexFace>::new(start, end).expect("finite numbers");
    assert!(assert_defined(&query, Separation::ZERO));
    // 2⁻⁶¹ / (1 − 2372 · 2⁻⁶¹), rounded down to 53 digits.
    let first = 2f64.powi(-61) * (1.0 + 4.0 * f64::EPSILON);
    assert_eq!(query.time_of_impact(Separation::ZERO), Some(first));
}
