//! Steps of vertices in named cases: vertices that are held back, blocked pairs, and the search after that.

use exact_ccd::{CONTACT, Options, Separation};
use exact_ccd_mesh::{Detector, FreeStepOptions, LineSearchError, Pair, Point, TriangleMesh};

/// With all of the time of impact kept, contact at t = 1/2 and at t = 1.
#[test]
fn a_vertex_that_touches_at_the_end_stops_one_place_before() {
    let mesh = TriangleMesh::new(5, vec![[0, 1, 2]]).unwrap();
    let floor = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let at = |heights: [f64; 2]| {
        let vertices = [[0.25, 0.25, heights[0]], [0.5, 0.25, heights[1]]];
        [&floor[..], &vertices].concat()
    };
    let options = FreeStepOptions::default().with_keep(1.0);
    let mut detector = Detector::new(mesh);
    let steps = detector
        .free_steps(&at([1.0, 1.0]), &at([-1.0, 0.0]), &[], &options)
        .unwrap();
    assert_eq!(steps.sizes[3..], [0.5_f64.next_down(), 1.0_f64.next_down()]);
}

/// A vertex falls onto a floor, and a ceiling follows: in the first round the vertex is below it at each
/// time, but a vertex that has been held back is not. The same for a face between vertices.
#[test]
fn what_is_held_back_is_searched_where_it_is_now() {
    let face = |height: f64| vec![[0.0, 0.0, height], [1.0, 0.0, height], [0.0, 1.0, height]];
    let vertex = |height: f64| vec![[0.25, 0.25, height]];
    let primitives: [[&dyn Fn(f64) -> Vec<Point>; 2]; 2] = [[&vertex, &face], [&face, &vertex]];
    for [falling, others] in primitives {
        let at = |height, follower| [falling(height), others(0.0), others(follower)].concat();
        let (x0, x1) = (at(1.0, 2.0), at(-1.0, 0.125));
        let faces = match x0.len() {
            7 => vec![[1, 2, 3], [4, 5, 6]],
            _ => vec![[0, 1, 2]],
        };
        let mesh = TriangleMesh::new(x0.len(), faces).unwrap();
        let options = FreeStepOptions::default().with_keep(0.5);
        let mut detector = Detector::new(mesh);
        let steps = detector.free_steps(&x0, &x1, &[], &options).unwrap();
        assert_eq!(steps.sizes[0], 0.25);
        assert!(steps.sizes.last() < Some(&1.0), "{steps:?}");
        assert_eq!(detector.collides(&x0, &steps.positions, CONTACT), Ok(false));
    }
}

/// A wall moves onto a cloth at rest: nothing that the cloth can do avoids it.
#[test]
fn what_pinned_vertices_forbid_is_reported() {
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).unwrap();
    let x0 = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.25, 0.25, 1.0],
    ];
    let mut x1 = x0;
    for corner in &mut x1[..3] {
        corner[2] = 2.0;
    }
    let mut detector = Detector::new(mesh);
    let options = FreeStepOptions::default();
    let free = detector.free_steps(&x0, &x1, &[], &options).unwrap();
    assert!(free.blocked.is_empty() && free.sizes[3] == 1.0 && free.sizes[0] < 0.5);
    let steps = detector.free_steps(&x0, &x1, &[0, 1, 2], &options).unwrap();
    assert_eq!(steps.blocked, [Pair::VertexFace { vertex: 3, face: 0 }]);
    assert_eq!(
        (&steps.sizes[..3], &steps.positions[..3]),
        (&[1.0; 3][..], &x1[..3])
    );
    // The vertex gets out of the way.
    x1[3][2] = 3.0;
    let steps = detector.free_steps(&x0, &x1, &[0, 1, 2], &options).unwrap();
    assert_eq!((steps.blocked, steps.sizes), (Vec::new(), vec![1.0; 4]));

    let wrong = detector.free_steps(&x0, &x1, &[4], &options);
    let vertex_count = 4;
    assert_eq!(
        wrong,
        Err(LineSearchError::Pinned {
            vertex: 4,
            vertex_count
        })
    );
}

/// A pinned rod moves onto a rod that falls: the pair is blocked once the latter, the one with the larger
/// index, has been held back to the start.
#[test]
fn a_blocked_pair_of_edges_has_the_smaller_index_first() {
    let mesh = TriangleMesh::with_edges(4, Vec::new(), &[[0, 1], [2, 3]]).unwrap();
    let at = |pinned: f64, falling: f64| -> [Point; 4] {
        [
            [-1.0, 0.0, pinned],
            [1.0, 0.0, pinned],
            [0.0, -1.0, falling],
            [0.0, 1.0, falling],
        ]
    };
    let options = FreeStepOptions::default();
    let mut detector = Detector::new(mesh);
    let steps = detector
        .free_steps(&at(0.0, 1.0), &at(2.0, 0.5), &[0, 1], &options)
        .unwrap();
    assert_eq!(steps.blocked, [Pair::EdgeEdge { a: 0, b: 1 }]);
    assert_eq!(steps.sizes, [1.0, 1.0, 0.0, 0.0]);
    assert!(steps.rounds > 1, "{steps:?}");
}

/// Two points meet, and are at the distance at the ends of their steps: the common step is one f64 smaller.
/// A third one meets the place where one of them stops: its box contains its whole step.
#[test]
fn all_is_searched_after_the_common_step() {
    let mesh = TriangleMesh::new(3, Vec::new()).unwrap();
    let x0 = [[0.0; 3], [1.0, 0.0, 0.0], [0.6484375, 3.0, 0.0]];
    let x1 = [[1.0, 0.0, 0.0], [0.0; 3], [0.6484375, -1.0, 0.0]];
    let d = Separation::new(0.0625).unwrap();
    let options = FreeStepOptions::default().with_keep(1.0).with_min_distance(d);
    let mut detector = Detector::new(mesh);
    let first = detector.collisions(&x0, &x1, Options::within(d)).unwrap();
    assert_eq!(first.len(), 1);
    let common = detector.free_step(&x0, &x1, &options).unwrap().size;
    assert_eq!(common, 0.46875_f64.next_down());
    let steps = detector.free_steps(&x0, &x1, &[], &options).unwrap();
    assert_eq!(steps.blocked, []);
    assert!(steps.sizes[2] < 1.0, "{steps:?}");
    assert_eq!(
        detector.collides(&x0, &steps.positions, Options::within(d)),
        Ok(false)
    );
}

/// Pairs that touch at the start are blocked, each once, and the rest of the mesh moves.
#[test]
fn blocked_pairs_are_sorted_and_vertices_at_rest_are_not_held_back() {
    let mesh = TriangleMesh::new(6, vec![[0, 1, 2]]).unwrap();
    let floor = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let at = |heights: [f64; 3]| {
        let [a, b, c] = heights;
        [&floor[..], &[[0.5, 0.5, a], [1.0, 0.5, b], [0.5, 1.0, c]]].concat()
    };
    let options = FreeStepOptions::default().with_keep(0.5);
    let mut detector = Detector::new(mesh);
    let falling = detector
        .free_steps(&at([1.0, 3.0, 1.0]), &at([-1.0, 2.0, -3.0]), &[], &options)
        .unwrap();
    assert_eq!(falling.sizes, [1.0, 1.0, 1.0, 0.25, 1.0, 0.125]);
    let blocked = detector
        .free_steps(&at([0.0, 3.0, 0.0]), &at([-1.0, 2.0, -1.0]), &[], &options)
        .unwrap();
    let face = 0;
    let expected = [3, 5].map(|vertex| Pair::VertexFace { vertex, face });
    assert_eq!(blocked.blocked, expected);
    assert_eq!((blocked.sizes[3], blocked.sizes[4]), (0.0, 1.0));
}

/// Two vertices meet, and are held back, so that a rod meets the place of one of them, beside two vertices
/// that touch at rest or do not.
#[test]
fn what_is_held_back_may_meet_a_rod() {
    let mesh = TriangleMesh::with_edges(6, Vec::new(), &[[2, 3]]).unwrap();
    let mut detector = Detector::new(mesh);
    let options = FreeStepOptions::default().with_keep(0.5);
    for x in [9.0, 8.0] {
        let rest = [[9.0; 3], [x, 9.0, 9.0]];
        let at = |p: f64, q: f64, rod: f64| {
            let moving = [[p, 0.0, 0.0], [q, 0.0, 0.0], [0.5, -1.0, rod], [0.5, 1.0, rod]];
            [&moving[..], &rest].concat()
        };
        let (x0, x1) = (at(0.0, 4.0, 1.0), at(4.0, 0.0, -1.0));
        let steps = detector.free_steps(&x0, &x1, &[], &options).unwrap();
        let blocked: &[Pair] = if x == 9.0 {
            &[Pair::VertexVertex { a: 4, b: 5 }]
        } else {
            &[]
        };
        assert_eq!(steps.blocked, blocked, "{steps:?}");
        let found = detector.collisions(&x0, &steps.positions, CONTACT).unwrap();
        assert_eq!(
            found.iter().map(|contact| contact.pair).collect::<Vec<_>>(),
            blocked
        );
        assert!(steps.sizes[1] == 0.25 && steps.rounds > 2, "{steps:?}");
    }
}
