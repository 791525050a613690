//! Motion without curvature.

use exact_ccd::{EdgeEdge, Point, Query, Separation, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_curved::{
    CurvedKind, End, Polynomial, Proximity, RigidMotion, SearchOptions, Trajectory, time_of_impact,
};

use crate::{points, within};

/// Small integers, whose sums are exact.
fn point(random: &mut fastrand::Rng) -> Point {
    [0; 3].map(|_| f64::from(random.i32(-6..7)))
}

fn compare<K: CurvedKind, T: Trajectory>(trajectories: &K::Trajectories<T>, query: &Query<K>, d: Separation) {
    let answer = time_of_impact::<K, T>(trajectories, d, &SearchOptions::default()).unwrap();
    let first = query.collision(d).map(|collision| collision.time());
    assert_eq!(answer.end == End::Free, first.is_none());
    match (answer.within, first) {
        (Some(reached), Some(first)) => {
            assert_eq!((answer.free_until, reached.by), (first.lower(), first.upper()));
            assert_eq!(reached.proximity, Proximity::Contact);
        }
        (None, None) => assert_eq!((answer.free_until, answer.chords), (1.0, 1)),
        other => panic!("{other:?}"),
    }
}

macro_rules! straight_motion_is_one_exact_query {
    ($name:ident, $kind:ty) => {
        #[test]
        fn $name() {
            let mut random = fastrand::Rng::with_seed(3);
            let mut near = 0;
            for _ in 0..20_000 {
                let start = points::<$kind>(|_| point(&mut random));
                let moves = points::<$kind>(|_| point(&mut random));
                let end: Vec<Point> = start
                    .iter()
                    .zip(moves)
                    .map(|(p, v)| [0, 1, 2].map(|k: usize| p[k] + v[k]))
                    .collect();
                let end = points::<$kind>(|i| end[i]);
                let query = Query::<$kind>::new(start, end).unwrap();
                let d = within([0.0, 1.0, 0.3][random.usize(0..3)]);
                near += usize::from(query.collides(d));
                let mut index = 0..;
                let polynomials = start.map(|p| Polynomial::new([p, end[index.next().unwrap()]]));
                compare(&polynomials, &query, d);
                // Without rotation the direction of the axis does not matter.
                let mut index = 0..;
                let rigid = start.map(|p| {
                    let (center, axis) = (point(&mut random), [0.0; 3]);
                    RigidMotion::new(center, axis, 0.0, moves[index.next().unwrap()])
                        .unwrap()
                        .point(p)
                });
                compare(&rigid, &query, d);
            }
            assert!((50..19_900).contains(&near), "{near}");
        }
    };
}

straight_motion_is_one_exact_query!(of_a_vertex_and_a_face, VertexFace);
straight_motion_is_one_exact_query!(of_two_edges, EdgeEdge);
straight_motion_is_one_exact_query!(of_a_vertex_and_an_edge, VertexEdge);
straight_motion_is_one_exact_query!(of_two_vertices, VertexVertex);
