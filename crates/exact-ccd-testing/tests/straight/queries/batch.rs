//! The answers to a batch are those to single queries, for all vector instructions of the processor.

use std::cell::RefCell;

use exact_ccd::batch::{
    self, Instructions, NonFiniteQuery, Trajectories, TrajectoriesError, VertexOutOfRange,
};
use exact_ccd::{
    Axis, CONTACT, Collision, EdgeEdge, Impact, Intervals, Kind, NonFinite, Point, Query, Separation,
    Separations, Thickness, VertexEdge, VertexFace, VertexVertex, environment,
};
use proptest::array::{uniform2, uniform4};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::queries::each_kind::for_each_kind;
use crate::queries::families::{cases, ordinary};
use exact_ccd_testing::families::mixed;
use exact_ccd_testing::kinds::{points_of, query};
use exact_ccd_testing::primitives::Primitives;
use exact_ccd_testing::runner::for_all;

/// Enough for queries of all families, and for several chunks of a batch.
const COUNT: u32 = 4_001;

/// The sizes of batches: those around a vector of 8 queries and a chunk of 256, and all queries.
const SIZES: [usize; 10] = [0, 1, 7, 8, 9, 255, 256, 257, 264, COUNT as usize];

/// True if batches are examined in vectors.
const HAS_VECTORS: bool = cfg!(any(
    target_arch = "x86",
    target_arch = "x86_64",
    all(target_arch = "aarch64", target_feature = "neon"),
    all(target_arch = "wasm32", target_feature = "simd128"),
));

/// Values of a strategy.
pub(crate) fn values<T: std::fmt::Debug>(count: u32, strategy: impl Strategy<Value = T>) -> Vec<T> {
    let values = RefCell::new(Vec::new());
    for_all(count, strategy, |value| values.borrow_mut().push(value));
    values.into_inner()
}

/// The vertices of queries that have none in common.
pub(crate) fn vertices<K: Kind>(count: usize) -> Vec<K::Vertices> {
    let mut next = 0..;
    let mut vertices = vec![K::Vertices::default(); count];
    for vertex in vertices.iter_mut().flat_map(AsMut::as_mut) {
        *vertex = next.next().unwrap();
    }
    vertices
}

/// Those vertices in motion.
pub(crate) fn trajectories<P: AsRef<[Point]>>(queries: &[[P; 2]]) -> Trajectories {
    let at = |time: usize| -> Vec<Point> {
        let now = queries.iter().flat_map(|ends| ends[time].as_ref());
        now.copied().collect()
    };
    Trajectories::new(&at(0), &at(1)).unwrap()
}

/// All answers about a colliding query, to the last bit.
#[derive(Debug, PartialEq)]
struct Answers {
    index: usize,
    points: Vec<Point>,
    intervals: Intervals,
    time_of_impact: u64,
    impact: Impact,
}

fn all_points<K: Kind>(query: &Query<K>) -> Vec<Point> {
    let points = query.points().iter().flat_map(AsRef::as_ref);
    points.copied().collect()
}

impl Answers {
    fn of_query<K: Kind>(index: usize, query: &Query<K>, d: Separation) -> Option<Self> {
        query.collides(d).then(|| Self {
            index,
            points: all_points(query),
            intervals: query.intervals(d),
            time_of_impact: query.time_of_impact(d).unwrap().to_bits(),
            impact: query.impact(d).unwrap(),
        })
    }

    fn of_collision<K: Kind>(index: usize, collision: &Collision<'_, K>) -> Self {
        Self {
            index,
            points: all_points(collision.query()),
            intervals: collision.intervals(),
            time_of_impact: collision.time_of_impact().to_bits(),
            impact: collision.impact(),
        }
    }
}

/// Checks batches of some queries, given by vertices, and, if all have the same separation, by points.
fn assert_as_single_queries<K: Kind>(
    queries: &[[K::Points; 2]],
    separations: Separations<'_>,
    sizes: &[usize],
) {
    let vertices = vertices::<K>(queries.len());
    let separation = |index: usize| {
        let (a, b) = vertices[index].as_ref().split_at(K::FIRST);
        separations.between(a, b)
    };
    let of_query = |(index, &[start, end]): (usize, &[K::Points; 2])| {
        Answers::of_query::<K>(index, &Query::new(start, end).unwrap(), separation(index))
    };
    let expected: Vec<Answers> = queries.iter().enumerate().filter_map(of_query).collect();
    assert!((1..queries.len()).contains(&expected.len()));
    let trajectories = trajectories(queries);
    for instructions in Instructions::available() {
        let of_vertices = trajectories.clone().with_instructions(instructions);
        for &size in sizes {
            let expected = &expected[..expected.partition_point(|answers| answers.index < size)];
            let mut found = Vec::new();
            of_vertices
                .collisions::<K>(&vertices[..size], separations, |index, collision| {
                    assert_eq!(collision.separation(), separation(index));
                    found.push(Answers::of_collision(index, &collision));
                })
                .unwrap();
            assert!(found == expected, "vertices, {instructions:?}, {separations:?}");

            let mut near = Vec::new();
            of_vertices
                .may_collide::<K>(&vertices[..size], separations, |index| near.push(index))
                .unwrap();
            assert!(near.is_sorted_by(|a, b| a < b) && near.iter().all(|&index| index < size));
            let is_near = |answers: &Answers| near.binary_search(&answers.index).is_ok();
            assert!(expected.iter().all(is_near), "{instructions:?}, {separations:?}");
            if HAS_VECTORS && environment::is_default() && size == queries.len() {
                assert!(near.len() < size, "{instructions:?}, {separations:?}");
            }

            if let Separations::Uniform(d) = separations {
                let mut found = Vec::new();
                batch::Queries::<K>::new(&queries[..size])
                    .with_instructions(instructions)
                    .collisions(d, |index, collision| {
                        found.push(Answers::of_collision(index, &collision));
                    })
                    .unwrap();
                assert!(found == expected, "points, {instructions:?}, {d:?}");
            }
        }
    }
}

fn answers_about_contact<K: Primitives>() {
    let queries = values(COUNT, mixed::<K>());
    assert_as_single_queries::<K>(&queries, Separation::ZERO.into(), &SIZES);
}

#[test]
fn batches_of_vertex_face_answer_as_single_queries() {
    answers_about_contact::<VertexFace>();
}

#[test]
fn batches_of_edge_edge_answer_as_single_queries() {
    answers_about_contact::<EdgeEdge>();
}

/// For one distance, and for a thickness of each vertex.
fn answers_within_distances<K: Kind>() {
    let thickness = prop_oneof![
        Just([0.0; 4]),
        uniform4(prop::sample::select(vec![0.0, 0.125, 0.5, 1.0])),
        uniform4(0.0..0.5),
    ];
    let (queries, thickness): (Vec<[K::Points; 2]>, Vec<[f64; 4]>) =
        values(cases(2_000), (ordinary(), thickness))
            .into_iter()
            .map(|(points, thickness)| (points.map(points_of::<K>), thickness))
            .unzip();
    let each = queries[0][0].as_ref().len();
    let thickness: Vec<f64> = thickness.iter().flat_map(|of| &of[..each]).copied().collect();
    let thickness = Thickness::new(&thickness).unwrap();

    let sizes = [queries.len()];
    assert_as_single_queries::<K>(&queries, (&thickness).into(), &sizes);
    for d in [0.0, 0.25, 1.0] {
        let d = Separation::new(d).unwrap();
        assert_as_single_queries::<K>(&queries, d.into(), &sizes);
    }
}

for_each_kind! {
    batches_within_distances_answer_as_single_queries => answers_within_distances;
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
            .collisions::<K>(&vertices, CONTACT, |index, collision| {
                found.push((index, collision.intervals(), collision.impact().time));
            })
            .unwrap();
        let expected: Vec<_> = (0..)
            .zip(&vertices)
            .filter_map(|(index, &vertices)| {
                let query = trajectories.query::<K>(vertices).unwrap();
                let time = query.exactly().impact(CONTACT)?.time;
                Some((index, query.exactly().intervals(CONTACT), time))
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
    let queries = values(COUNT, mixed::<EdgeEdge>());
    let trajectories = trajectories(&queries);
    for (points, vertices) in queries.iter().zip(vertices::<EdgeEdge>(queries.len())) {
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
}

#[test]
fn other_positions_replace_the_first_ones() {
    let (o, x) = ([0.0; 3], [1.0; 3]);
    let mut trajectories = Trajectories::new(&[o, o, x], &[x; 3]).unwrap();
    trajectories.set(&[x, o], &[o, o]).unwrap();
    assert_eq!(trajectories.vertex_count(), 2);
    assert_eq!(
        trajectories.query::<VertexVertex>([0, 1]),
        Query::new([x, o], [o, o]).ok()
    );
    for wrong in [&[o][..], &[o, [f64::NAN; 3]]] {
        trajectories.set(&[o, o], &[x, x]).unwrap();
        assert!(trajectories.set(wrong, &[o, o]).is_err());
        assert_eq!(trajectories.vertex_count(), 0);
    }
}

#[test]
fn errors_of_batches_name_query_and_vertex() {
    let trajectories = Trajectories::new(&[[0.0; 3]; 5], &[[0.0; 3]; 5]).unwrap();
    let expected = VertexOutOfRange {
        query: 1,
        vertex: 9,
        vertex_count: 5,
    };
    let found = trajectories.collisions::<VertexFace>(&[[0, 1, 2, 3], [4, 9, 5, 0]], CONTACT, |_, _| {
        unreachable!("nothing is found");
    });
    assert_eq!(found, Err(expected));
    let found = trajectories.collisions::<VertexEdge>(&[[0, 1, 2], [4, 0, 9]], CONTACT, |_, _| {
        unreachable!("nothing is found");
    });
    assert_eq!(found, Err(expected));
    assert_eq!(
        expected.to_string(),
        "query 1 names vertex 9, expected one below 5"
    );
    // The first vertex that does not exist, and one without a thickness.
    let expected = |vertex_count| VertexOutOfRange {
        query: 0,
        vertex: vertex_count as u32,
        vertex_count,
    };
    let found = trajectories.collisions::<VertexVertex>(&[[5, 4], [6, 4]], CONTACT, |_, _| ());
    assert_eq!(found, Err(expected(5)));
    let thickness = Thickness::new(&[1.0; 4]).unwrap();
    let found = trajectories.collisions::<VertexVertex>(&[[4, 0], [3, 0]], &thickness, |_, _| ());
    assert_eq!(found, Err(expected(4)));
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
        let batch = batch::Queries::<EdgeEdge>::new(&queries);
        let error = batch.collisions(CONTACT, |index, _| found.push(index));
        let error = error.unwrap_err();
        let expected = NonFiniteQuery {
            query: bad,
            source: NonFinite {
                time: Some(1),
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

/// The differences of one corner, far away at both ends, are rounded across a plane at 45 degrees. The
/// differences of the other corners are small.
#[test]
fn a_far_corner_counts_whatever_the_others_are() {
    let far = 2f64.powi(53);
    for unit in [1.0, 2f64.powi(-60)] {
        for first in 0..3 {
            for axis in 0..3 {
                let at = |x: f64| {
                    let mut face = [[-x, x, 0.0], [-8.0, -8.0, 1.0], [-8.0, -8.0, -1.0]];
                    face.rotate_right(first);
                    [[1.25, 1.25, 0.0], face[0], face[1], face[2]].map(|mut point| {
                        point.rotate_right(axis);
                        point.map(|x| x * unit)
                    })
                };
                let queries = [[at(far), at(-far)]];
                let d = Separation::new(2.0 * unit).unwrap();
                for instructions in Instructions::available() {
                    let mut found = Vec::new();
                    batch::Queries::<VertexFace>::new(&queries)
                        .with_instructions(instructions)
                        .collisions(d, |index, _| found.push(index))
                        .unwrap();
                    assert_eq!(found, [0], "{unit:e} {first} {axis} {instructions:?}");
                }
            }
        }
    }
}
