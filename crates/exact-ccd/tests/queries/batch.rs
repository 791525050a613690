//! The answers to a batch are those to single queries, for all vector instructions of the processor.

use std::cell::RefCell;

use exact_ccd::batch::{
    self, Instructions, NonFiniteQuery, Trajectories, TrajectoriesError, VertexOutOfRange,
};
use exact_ccd::{Axis, Collision, EdgeEdge, Impact, NonFinite, Query, VertexFace, exact};
use proptest::array::{uniform2, uniform4};
use proptest::collection::vec;
use proptest::prelude::any;

use crate::generators::mixed;
use crate::laws::{bits, query};
use crate::primitives::{Points, Primitives};
use crate::runner::for_all;

/// Enough for queries of all families, and for several chunks of a batch.
const COUNT: u32 = 4_001;

/// The sizes of batches: those around a vector of 8 queries and a chunk of 256, and all queries.
const SIZES: [usize; 10] = [0, 1, 7, 8, 9, 255, 256, 257, 264, COUNT as usize];

fn queries<K: Primitives>() -> Vec<Points> {
    let queries = RefCell::new(Vec::new());
    for_all(COUNT, mixed::<K>(), |points| queries.borrow_mut().push(points));
    queries.into_inner()
}

/// The trajectories of the points of all queries, and the four vertices of each query.
fn meshed<K: Primitives>(queries: &[Points]) -> (Trajectories, Vec<[u32; 4]>) {
    let at = |time: usize| -> Vec<_> {
        queries
            .iter()
            .flat_map(|points| query::<K>(points).points()[time])
            .collect()
    };
    let vertices = (0..queries.len() as u32).map(|i| [0, 1, 2, 3].map(|k| 4 * i + k));
    (Trajectories::new(&at(0), &at(1)).unwrap(), vertices.collect())
}

/// All answers about a colliding query, to the last bit.
#[derive(Debug, PartialEq)]
struct Answers {
    index: usize,
    points: Points,
    times: (bool, Vec<(u64, bool)>),
    time_of_impact: u64,
    impact: Impact,
}

impl Answers {
    fn of_query<K: Primitives>(index: usize, query: &Query<K>) -> Option<Self> {
        query.collides().then(|| Self {
            index,
            points: *query.points(),
            times: bits(&query.contact_times()),
            time_of_impact: query.time_of_impact().unwrap().to_bits(),
            impact: query.impact().unwrap(),
        })
    }

    fn of_collision<K: Primitives>(index: usize, collision: &Collision<'_, K>) -> Self {
        Self {
            index,
            points: *collision.query().points(),
            times: bits(&collision.contact_times()),
            time_of_impact: collision.time_of_impact().to_bits(),
            impact: collision.impact(),
        }
    }
}

fn answers_as_single_queries<K: Primitives>() {
    let queries = queries::<K>();
    let (trajectories, vertices) = meshed::<K>(&queries);
    let expected: Vec<Answers> = queries
        .iter()
        .enumerate()
        .filter_map(|(index, points)| Answers::of_query(index, &query::<K>(points)))
        .collect();
    assert!((100..queries.len() - 100).contains(&expected.len()));
    for instructions in Instructions::available() {
        let trajectories = trajectories.clone().with_instructions(instructions);
        for size in SIZES {
            let expected = &expected[..expected.partition_point(|answers| answers.index < size)];
            let mut found = Vec::new();
            trajectories
                .collisions::<K>(&vertices[..size], |index, collision| {
                    found.push(Answers::of_collision(index, &collision));
                })
                .unwrap();
            assert_eq!(found, expected, "vertices, {instructions:?}");

            let mut found = Vec::new();
            let of_points = batch::Queries::<K>::new(&queries[..size]).with_instructions(instructions);
            of_points
                .collisions(|index, collision| found.push(Answers::of_collision(index, &collision)))
                .unwrap();
            assert_eq!(found, expected, "points, {instructions:?}");
        }
    }
}

#[test]
fn batches_of_vertex_face_answer_as_single_queries() {
    answers_as_single_queries::<VertexFace>();
}

#[test]
fn batches_of_edge_edge_answer_as_single_queries() {
    answers_as_single_queries::<EdgeEdge>();
}

/// In units of 1 and of the smallest subnormal number, where many queries are degenerate.
fn small_integers_answer_as_integers_do<K: Primitives>() {
    let points = vec(uniform2([-4..=4i8, -4..=4i8, -4..=4i8]), 12);
    let cases = (points, vec(uniform4(0..12_u32), 30), any::<bool>());
    for_all(200, cases, |(points, vertices, is_subnormal)| {
        let unit = if is_subnormal { f64::from_bits(1) } else { 1.0 };
        let at = |time: usize| -> Vec<[f64; 3]> {
            let scaled = points.iter().map(|ends| ends[time].map(|x| f64::from(x) * unit));
            scaled.collect()
        };
        let trajectories = Trajectories::new(&at(0), &at(1)).unwrap();
        let mut found = Vec::new();
        trajectories
            .collisions::<K>(&vertices, |index, collision| {
                found.push((index, bits(&collision.contact_times()), collision.impact().time));
            })
            .unwrap();
        let expected: Vec<_> = (0..)
            .zip(&vertices)
            .filter_map(|(index, &vertices)| {
                let query = trajectories.query::<K>(vertices).unwrap();
                let time = exact::impact(&query)?.time;
                Some((index, bits(&exact::contact_times(&query)), time))
            })
            .collect();
        assert_eq!(found, expected);
    });
}

#[test]
fn batches_of_small_integers_answer_as_integers_do() {
    small_integers_answer_as_integers_do::<VertexFace>();
    small_integers_answer_as_integers_do::<EdgeEdge>();
}

#[test]
fn a_query_of_vertices_is_that_of_their_positions() {
    let queries = queries::<EdgeEdge>();
    let (trajectories, vertices) = meshed::<EdgeEdge>(&queries);
    for (points, vertices) in queries.iter().zip(vertices) {
        assert_eq!(
            trajectories.query::<EdgeEdge>(vertices),
            Some(query::<EdgeEdge>(points))
        );
    }
    let beyond = trajectories.vertex_count() as u32;
    assert_eq!(trajectories.query::<EdgeEdge>([0, 1, 2, beyond]), None);
}

#[test]
fn errors_of_trajectories_name_vertex_and_coordinate() {
    let (o, x) = ([0.0; 3], [1.0, 0.0, f64::INFINITY]);
    assert_eq!(
        Trajectories::new(&[o, o], &[o]).unwrap_err(),
        TrajectoriesError::Count { start: 2, end: 1 }
    );
    let error = Trajectories::new(&[o, o], &[o, x]).unwrap_err();
    let expected = TrajectoriesError::NonFinite {
        time: 1,
        vertex: 1,
        axis: Axis::Z,
        value: f64::INFINITY,
    };
    assert_eq!(error, expected);
    assert_eq!(
        error.to_string(),
        "vertex 1 has z = inf at t = 1, expected a finite number"
    );
    let trajectories = Trajectories::new(&[o; 5], &[o; 5]).unwrap();
    let found = trajectories.collisions::<VertexFace>(&[[0, 1, 2, 3], [4, 9, 5, 0]], |_, _| {
        unreachable!("nothing is found");
    });
    let expected = VertexOutOfRange {
        query: 1,
        vertex: 9,
        vertex_count: 5,
    };
    assert_eq!(found, Err(expected));
}

/// All queries collide: their points coincide. Those before the one with the error are found, in
/// any chunk.
#[test]
fn errors_of_arrays_name_query_and_coordinate() {
    for bad in [0, 3, 255, 256, 700] {
        let mut queries = vec![[[[0.0; 3]; 4]; 2]; 701];
        queries[bad][1][2][1] = f64::NEG_INFINITY;
        queries[700][1][3] = [f64::NAN; 3];
        let mut found = Vec::new();
        let error = batch::Queries::<EdgeEdge>::new(&queries).collisions(|index, _| found.push(index));
        let error = error.unwrap_err();
        let expected = NonFiniteQuery {
            query: bad,
            source: NonFinite {
                time: 1,
                point: 2,
                axis: Axis::Y,
                value: f64::NEG_INFINITY,
            },
        };
        assert_eq!(error, expected);
        assert_eq!(
            error.to_string(),
            format!("query {bad}: coordinate y of point 2 at t = 1 is -inf, not a finite number")
        );
        assert_eq!(found, (0..bad).collect::<Vec<_>>());
    }
}
