//! The registry, and the guarantees of every registered method on random motions.

use std::collections::BTreeSet;

use exact_ccd::{CONTACT, Ccd, ContactTime, Decide, EdgeEdge, Kind, Point, Query, TimeGuarantee, VertexFace};
use exact_ccd_methods::{all, by_name, names};
use proptest::array::{uniform2, uniform3, uniform4};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

#[test]
fn names_differ_even_in_lower_case() {
    let distinct: BTreeSet<String> = names().iter().map(|name| name.to_lowercase()).collect();
    assert_eq!(distinct.len(), all().len());
    assert_eq!(distinct.len(), 11);
}

#[test]
fn a_method_is_found_by_its_name_in_any_case() {
    for name in names() {
        for spelling in [name.to_lowercase(), name.to_uppercase()] {
            assert_eq!(by_name(&spelling).unwrap().name(), name);
        }
    }
}

#[test]
fn an_unknown_name_is_an_error_that_lists_all_names() {
    let error = by_name("guess").err().unwrap();
    assert_eq!(error.known, names());
    assert_eq!(
        error.to_string(),
        "there is no method guess; there are exact, parity, IRF, UIRF, FPRF, TCCD, RP, RRP, BSC, MSRF, TI"
    );
}

/// True if the answer has no error, and the time no error, that the method does not admit.
fn is_kept(method: &dyn Ccd, answer: Option<f64>, truth: Option<ContactTime>) -> bool {
    let guarantees = method.guarantees();
    match (truth, answer) {
        (Some(_), None) => guarantees.false_negatives,
        (None, Some(_)) => guarantees.false_positives,
        (Some(first), Some(time)) => match guarantees.time {
            TimeGuarantee::Exact => time == first.lower(),
            TimeGuarantee::Conservative => time <= first.upper(),
            TimeGuarantee::Approximate => (0.0..=1.0).contains(&time),
            TimeGuarantee::Absent => time == 0.0,
        },
        (None, None) => true,
    }
}

fn check<K: Kind<Points = [Point; 4]> + std::fmt::Debug>(
    method: &dyn Ccd,
    decide: &dyn Decide<K>,
    [start, end]: [[Point; 4]; 2],
) {
    let query = Query::<K>::new(start, end).unwrap();
    let answer = decide.time_of_impact(&query);
    assert_eq!(
        answer.is_some(),
        decide.collides(&query),
        "{}: {query:?}",
        method.name()
    );
    let truth = query.collision(CONTACT).map(|collision| collision.time());
    assert!(
        is_kept(method, answer, truth),
        "{}: {answer:?}, {truth:?}",
        method.name()
    );
}

/// Some meet: one vertex and face in about fourteen, one pair of edges in five. Primitives are as large as
/// their motion.
fn points() -> impl Strategy<Value = [[Point; 4]; 2]> {
    uniform2(uniform4(uniform3(-1.0..=1.0)))
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 300,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0),
        ..ProptestConfig::default()
    })]

    #[test]
    fn every_method_keeps_its_guarantees(points in points()) {
        for method in all() {
            let method = method.as_ref();
            check::<VertexFace>(method, method, points);
            check::<EdgeEdge>(method, method, points);
        }
    }
}
