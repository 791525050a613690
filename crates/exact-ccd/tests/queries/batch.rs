//! Many queries at once are answered as one by one, whatever the processor's instructions.

use std::cell::RefCell;

use exact_ccd::batch::{Instructions, Trajectories, TrajectoriesError, VertexOutOfRange};
use exact_ccd::{EdgeEdge, VertexFace};

use crate::generators::mixed;
use crate::laws::query;
use crate::primitives::{Points, Primitives};
use crate::runner::for_all;

/// Queries of all families, and the bounds of the chunks that a batch is worked off in.
const COUNT: u32 = 4_001;

fn queries<K: Primitives>() -> Vec<Points> {
    let queries = RefCell::new(Vec::new());
    for_all(COUNT, mixed::<K>(), |points| queries.borrow_mut().push(points));
    queries.into_inner()
}

/// The vertices of all queries, and which ones make a query: each one's own.
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

fn answers_as_one_by_one<K: Primitives>() {
    let queries = queries::<K>();
    let (trajectories, vertices) = meshed::<K>(&queries);
    let expected: Vec<(usize, Points)> = queries
        .iter()
        .map(query::<K>)
        .enumerate()
        .filter(|(_, query)| query.collides())
        .map(|(index, query)| (index, *query.points()))
        .collect();
    assert!((100..queries.len() - 100).contains(&expected.len()));
    for instructions in Instructions::available() {
        let trajectories = trajectories.clone().with_instructions(instructions);
        for count in [0, 1, 7, 8, 9, 255, 256, 257, 264, queries.len()] {
            let mut found = Vec::new();
            trajectories
                .collisions::<K>(&vertices[..count], |index, query| {
                    found.push((index, *query.points()));
                })
                .unwrap();
            let among_these = expected.partition_point(|(index, _)| *index < count);
            assert_eq!(found, expected[..among_these], "{instructions:?}");
        }
    }
}

#[test]
fn vertex_face_as_one_by_one() {
    answers_as_one_by_one::<VertexFace>();
}

#[test]
fn edge_edge_as_one_by_one() {
    answers_as_one_by_one::<EdgeEdge>();
}

#[test]
fn a_query_of_vertices_is_that_of_their_positions() {
    let queries = queries::<EdgeEdge>();
    let (trajectories, vertices) = meshed::<EdgeEdge>(&queries);
    for (points, vertices) in queries.iter().zip(vertices) {
        assert_eq!(trajectories.query(vertices), Some(query::<EdgeEdge>(points)));
    }
    let beyond = trajectories.vertex_count() as u32;
    assert_eq!(trajectories.query::<EdgeEdge>([0, 1, 2, beyond]), None);
}

#[test]
fn names_what_is_wrong() {
    let (o, x) = ([0.0; 3], [1.0, 0.0, f64::NAN]);
    assert_eq!(
        Trajectories::new(&[o, o], &[o]).unwrap_err(),
        TrajectoriesError::Count { start: 2, end: 1 }
    );
    assert_eq!(
        Trajectories::new(&[o, o], &[o, x]).unwrap_err(),
        TrajectoriesError::NonFinite { vertex: 1 }
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
