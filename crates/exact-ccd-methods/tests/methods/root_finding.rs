//! The floating-point root finders: contacts, false negatives and false positives.

use exact_ccd::{CONTACT, Ccd, Decide, EdgeEdge, Kind, Point, Query, VertexFace};
use exact_ccd_methods::{FloatingPointRootFinder, MinimumSeparationRootFinder};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngSeed, TestRunner};

const NO_DISTANCE: FloatingPointRootFinder = FloatingPointRootFinder { distance: 0.0 };
const SOME_DISTANCE: FloatingPointRootFinder = FloatingPointRootFinder { distance: 1e-6 };

fn minimum_separation() -> MinimumSeparationRootFinder {
    MinimumSeparationRootFinder::default()
}

fn at_rest<const N: usize>(points: [Point; N]) -> [[Point; N]; 2] {
    [points; 2]
}

fn moved(points: [Point; 4], moving: [bool; 4], by: Point) -> [Point; 4] {
    std::array::from_fn(|i| {
        if moving[i] {
            std::array::from_fn(|axis| points[i][axis] + by[axis])
        } else {
            points[i]
        }
    })
}

/// A vertex that falls upon the middle of a face at rest.
fn falling(height: f64, depth: f64) -> Query<VertexFace> {
    let start = [[0.25, 0.25, height], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let end = moved(start, [true, false, false, false], [0.0, 0.0, -height - depth]);
    Query::<VertexFace>::new(start, end).unwrap()
}

/// An edge of twice the length that falls upon the middle of another, at a right angle.
fn crossing(length: f64, height: f64, depth: f64) -> Query<EdgeEdge> {
    let start = [
        [-length, 0.0, height],
        [length, 0.0, height],
        [0.0, -length, 0.0],
        [0.0, length, 0.0],
    ];
    let end = moved(start, [true, true, false, false], [0.0, 0.0, -height - depth]);
    Query::<EdgeEdge>::new(start, end).unwrap()
}

fn assert_time(time: Option<f64>, expected: f64) {
    let time = time.unwrap();
    assert!((time - expected).abs() < 1e-5, "{time} is not {expected}");
}

#[test]
fn plain_contacts_are_found_in_time() {
    for method in [&SOME_DISTANCE as &dyn Ccd, &minimum_separation()] {
        assert_time(method.time_of_impact(&falling(1.0, 2.0)), 1.0 / 3.0);
        assert_time(method.time_of_impact(&crossing(1.0, 1.0, 2.0)), 1.0 / 3.0);
        assert_eq!(method.time_of_impact(&falling(1.0, -0.5)), None);
        assert_eq!(method.time_of_impact(&crossing(1.0, 1.0, -0.5)), None);
    }
}

/// The same contact at other heights: rounding decides, unless there is a distance far above the precision.
#[test]
fn double_roots_are_missed() {
    let missed = |method: &dyn Ccd| {
        let heights = (1..=100).map(|n| f64::from(n) / 7.0);
        heights
            .filter(|&height| !method.collides(&crossing(1.0, height, 0.3)))
            .count()
    };
    let of_none = missed(&NO_DISTANCE);
    assert!((10..=90).contains(&of_none), "{of_none}");
    let of_separation = missed(&minimum_separation());
    assert!((1..=50).contains(&of_separation), "{of_separation}");
    assert_eq!(missed(&SOME_DISTANCE), 0);
}

#[test]
fn parallel_edges_are_missed() {
    let start = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
    let end = moved(start, [true, true, false, false], [0.0, 0.0, -2.0]);
    let query = Query::<EdgeEdge>::new(start, end).unwrap();
    assert!(query.collides(CONTACT));
    assert_eq!(SOME_DISTANCE.time_of_impact(&query), None);
    assert_eq!(minimum_separation().time_of_impact(&query), None);
}

#[test]
fn short_edges_are_missed() {
    let query = crossing(4e-5, 1e-4, 1e-4);
    assert!(query.collides(CONTACT));
    assert_eq!(SOME_DISTANCE.time_of_impact(&query), None);
    assert_eq!(minimum_separation().time_of_impact(&query), None);
}

/// A corner swings over and turns the normal, but the method uses the direction at t = 0.
#[test]
fn a_turning_face_is_missed() {
    let p = [0.25, -0.2, 0.225];
    let (a, b) = ([0.0; 3], [1.0, 0.0, 0.0]);
    let query = Query::<VertexFace>::new([p, a, b, [0.0, 1.0, 0.0]], [p, a, b, [0.0, -1.0, 1.0]]).unwrap();
    assert_eq!(SOME_DISTANCE.time_of_impact(&query), None);
    assert!(minimum_separation().collides(&query));
}

/// 2e-5 apart at the closest.
#[test]
fn near_passes_are_taken_for_contacts_by_the_minimum_separation() {
    let face = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let [start, end] = at_rest(face);
    let beside = -2e-5;
    let query = Query::<VertexFace>::new(
        [[beside, 0.5, 1.0], start[0], start[1], start[2]],
        [[beside, 0.5, -1.0], end[0], end[1], end[2]],
    )
    .unwrap();
    assert!(!query.collides(CONTACT));
    assert!(minimum_separation().collides(&query));
    assert_eq!(SOME_DISTANCE.time_of_impact(&query), None);
}

fn point() -> impl Strategy<Value = Point> {
    prop::array::uniform3(-1.0..1.0)
}

fn in_general_position() -> impl Iterator<Item = [[Point; 4]; 2]> {
    let mut runner = TestRunner::deterministic();
    let points = prop::array::uniform2(prop::array::uniform4(point()));
    (0..5000).map(move |_| points.new_tree(&mut runner).unwrap().current())
}

/// The numbers of contacts, of false negatives and of false positives.
#[derive(Debug, Default)]
struct Tally {
    contacts: usize,
    false_negatives: usize,
    false_positives: usize,
}

impl FromIterator<(bool, bool)> for Tally {
    fn from_iter<I: IntoIterator<Item = (bool, bool)>>(answers: I) -> Self {
        answers
            .into_iter()
            .fold(Self::default(), |tally, (truth, answer)| Self {
                contacts: tally.contacts + usize::from(truth),
                false_negatives: tally.false_negatives + usize::from(truth && !answer),
                false_positives: tally.false_positives + usize::from(!truth && answer),
            })
    }
}

/// The tally of a method whose false positives are rare.
fn tally<K: Kind>(method: &impl Decide<K>, queries: impl Iterator<Item = Query<K>>) -> Tally {
    let answers = queries.map(|query| (query.collides(CONTACT), method.collides(&query)));
    let tally: Tally = answers.collect();
    let is_rare = tally.false_positives * 100 < tally.contacts;
    assert!(tally.contacts > 100 && is_rare, "{tally:?}");
    tally
}

fn tally_of_edges(method: &impl Decide<EdgeEdge>) -> Tally {
    let query = |[start, end]: [_; 2]| Query::<EdgeEdge>::new(start, end).unwrap();
    tally(method, in_general_position().map(query))
}

/// With a face that does not turn.
fn tally_of_faces(method: &impl Decide<VertexFace>) -> Tally {
    let queries = in_general_position().map(|[start, [by, p, ..]]| {
        let mut end = moved(start, [false, true, true, true], by);
        end[0] = p;
        Query::<VertexFace>::new(start, end).unwrap()
    });
    tally(method, queries)
}

#[test]
fn almost_all_contacts_in_general_position_are_found_with_a_distance() {
    for tally in [tally_of_edges(&SOME_DISTANCE), tally_of_faces(&SOME_DISTANCE)] {
        assert!(tally.false_negatives * 100 < tally.contacts, "{tally:?}");
    }
}

#[test]
fn most_contacts_in_general_position_are_found_by_the_minimum_separation() {
    for tally in [
        tally_of_edges(&minimum_separation()),
        tally_of_faces(&minimum_separation()),
    ] {
        assert!(tally.false_negatives * 10 < tally.contacts, "{tally:?}");
    }
}

#[test]
fn a_third_of_the_contacts_in_general_position_is_missed_without_a_distance() {
    let tally = tally_of_edges(&NO_DISTANCE);
    let share = tally.false_negatives as f64 / tally.contacts as f64;
    assert!((0.2..0.6).contains(&share), "{share}");
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 2000,
        rng_seed: RngSeed::Fixed(0),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn times_are_in_the_step(start in prop::array::uniform4(point()), end in prop::array::uniform4(point())) {
        let face = Query::<VertexFace>::new(start, end).unwrap();
        let edges = Query::<EdgeEdge>::new(start, end).unwrap();
        for method in [&NO_DISTANCE as &dyn Ccd, &minimum_separation()] {
            for time in [method.time_of_impact(&face), method.time_of_impact(&edges)] {
                prop_assert!(time.is_none_or(|t| (0.0..=1.0).contains(&t)));
            }
        }
    }

    #[test]
    fn any_numbers_are_answered(
        start in prop::array::uniform4(prop::array::uniform3(any::<f64>())),
        end in prop::array::uniform4(prop::array::uniform3(any::<f64>())),
    ) {
        for method in [&NO_DISTANCE as &dyn Ccd, &SOME_DISTANCE, &minimum_separation()] {
            if let Ok(face) = Query::<VertexFace>::new(start, end) {
                method.time_of_impact(&face);
            }
            if let Ok(edges) = Query::<EdgeEdge>::new(start, end) {
                method.time_of_impact(&edges);
            }
        }
    }
}
