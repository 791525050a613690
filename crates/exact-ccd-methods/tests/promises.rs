//! What every method of the list promises, on random motions.

use std::collections::BTreeSet;

use exact_ccd::{ContactTimes, EdgeEdge, Point, Query, VertexFace};
use exact_ccd_methods::{Answer, Method, Time, all};
use proptest::array::{uniform2, uniform3, uniform4};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

#[test]
fn names_differ_whatever_the_case() {
    let names: BTreeSet<String> = all().iter().map(|method| method.name().to_lowercase()).collect();
    assert_eq!(names.len(), all().len());
    assert_eq!(names.len(), 11);
}

/// No more of either error, and no later time, than the method says.
fn keeps_its_promise(method: &dyn Method, answer: Answer, times: &ContactTimes) -> bool {
    let promise = method.promise();
    let is_kept = match (times.first(), answer) {
        (Some(_), Answer::Free) => promise.may_miss,
        (None, Answer::Contact { .. }) => promise.may_invent,
        (Some(first), Answer::Contact { time: Some(time) }) => match promise.time {
            Time::Exact => time == first.lower(),
            Time::Conservative => time <= first.upper(),
            Time::Approximate => (0.0..=1.0).contains(&time),
            Time::Absent => false,
        },
        _ => true,
    };
    is_kept && (answer.time().is_some() == (answer.is_contact() && promise.time != Time::Absent))
}

/// Half of them meet: with coordinates in a small range, the primitives are as large as their motion.
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
    fn every_method_keeps_its_promise([start, end] in points()) {
        let (face, edge) = (Query::<VertexFace>::new(start, end).unwrap(), Query::<EdgeEdge>::new(start, end).unwrap());
        for method in all() {
            let answers = [
                (method.vertex_face(&face), face.contact_times()),
                (method.edge_edge(&edge), edge.contact_times()),
            ];
            for (answer, times) in answers {
                prop_assert!(
                    keeps_its_promise(method.as_ref(), answer, &times),
                    "{}: {answer:?}, {times:?}", method.name()
                );
            }
        }
    }
}
