//! Candidates within a distance, compared with distances of sampled points at sampled times.

use std::collections::HashSet;

use exact_ccd::{CONTACT, EdgeEdge, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_mesh::{BoxKind, Bvh, CandidateOptions, Candidates, Pair, PairKind, Point, Step, advance};
use fastrand::Rng;

use super::scene::{Scene, contacts};

/// The weights of points on a primitive of one, two or three vertices.
fn weights(vertices: usize) -> Vec<Vec<f64>> {
    let part = |i: u32| f64::from(i) / 4.0;
    match vertices {
        1 => vec![vec![1.0]],
        2 => (0..=4).map(|i| vec![part(4 - i), part(i)]).collect(),
        _ => (0..=4)
            .flat_map(|i| (0..=4 - i).map(move |j| vec![part(4 - i - j), part(i), part(j)]))
            .collect(),
    }
}

fn points(x: &[Point], vertices: &[u32]) -> Vec<Point> {
    let point = |weights: Vec<f64>| {
        [0, 1, 2].map(|axis: usize| {
            let terms = vertices.iter().zip(&weights);
            terms
                .map(|(&v, weight)| weight * x[v as usize][axis])
                .sum::<f64>()
        })
    };
    weights(vertices.len()).into_iter().map(point).collect()
}

/// True if two sampled points are nearer than a distance: then the primitives are, too.
fn are_within<K: PairKind>(scene: &Scene, x: &[Point], ids: [u32; 2], distance: f64) -> bool {
    let vertices = K::vertices(&scene.mesh, ids).unwrap();
    let (a, b) = vertices.as_ref().split_at(K::FIRST);
    let (a, b) = (points(x, a), points(x, b));
    a.iter().any(|p| {
        b.iter().any(|q| {
            let squares = p.iter().zip(q).map(|(x, y)| (x - y) * (x - y));
            squares.sum::<f64>().sqrt() < distance
        })
    })
}

/// The pairs that the sampling finds within a distance.
fn within(scene: &Scene, x: &[Point], all: &Candidates, distance: f64) -> Candidates {
    // The rounding errors of the sampling are less than this.
    let largest = x.as_flattened().iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let distance = distance * (1.0 - 1e-9) - 16.0 * f64::EPSILON * largest;
    let is_within = |pair: &Pair| match *pair {
        Pair::VertexFace { vertex, face } => are_within::<VertexFace>(scene, x, [vertex, face], distance),
        Pair::EdgeEdge { a, b } => are_within::<EdgeEdge>(scene, x, [a, b], distance),
        Pair::VertexEdge { vertex, edge } => are_within::<VertexEdge>(scene, x, [vertex, edge], distance),
        Pair::VertexVertex { a, b } => are_within::<VertexVertex>(scene, x, [a, b], distance),
    };
    all.pairs().filter(is_within).collect()
}

fn assert_has_all(candidates: &Candidates, expected: &Candidates, what: &str) {
    let found: HashSet<Pair> = candidates.pairs().collect();
    for pair in expected.pairs() {
        assert!(found.contains(&pair), "{what}: {pair:?}");
    }
}

/// The candidates include all pairs that are near, or that collide before, at any end of a line
/// search.
#[test]
fn candidates_contain_all_pairs_that_come_near() {
    let mut random = Rng::with_seed(11);
    let (mut apart, mut near, mut colliding) = (0, 0, 0);
    for case in 0..200 {
        let (scene, scale) = Scene::pieces(&mut random);
        let distance = scale * [0.0, 1e-3, 0.1, 0.4][random.usize(..4)];
        let step = scene.step();
        let all = scene.pairs();
        let both = [BoxKind::Swept, BoxKind::Moving].map(|boxes| {
            let options = CandidateOptions::default()
                .with_distance(distance)
                .with_boxes(boxes);
            Candidates::with_options(step, &Bvh, &options).unwrap()
        });
        assert_has_all(&all, &both[0], "no pair");
        for (time, from_direction) in [
            (0.0, false),
            (1.0, false),
            (random.f64(), false),
            (0.5 * random.f64(), true),
            (1e-9 * random.f64(), false),
        ] {
            let x = if from_direction {
                let ends = scene.x0.iter().zip(&scene.x1);
                let direction: Vec<Point> = ends
                    .map(|(a, b)| [0, 1, 2].map(|axis: usize| b[axis] - a[axis]))
                    .collect();
                // The candidates are valid only if the full step ends at their x1.
                if advance(&scene.x0, &direction, 1.0) != scene.x1 {
                    continue;
                }
                advance(&scene.x0, &direction, time)
            } else {
                step.at(time)
            };
            let expected = within(&scene, &x, &all, distance);
            let shorter = Step::new(&scene.mesh, &scene.x0, &x).unwrap();
            let touching = contacts(shorter, &all);
            for candidates in &both {
                assert_has_all(candidates, &expected, &format!("case {case} at {time}"));
                assert_eq!(
                    candidates.collisions(shorter, CONTACT),
                    touching,
                    "case {case} at {time}"
                );
                apart += usize::from(candidates.counts().total() < all.counts().total());
            }
            near += expected.counts().total();
            colliding += touching.len();
        }
    }
    assert!(
        apart > 500 && near > 5000 && colliding > 2000,
        "{apart} {near} {colliding}"
    );
}

#[test]
fn positions_in_a_step_lie_in_its_box_near_the_exact_ones() {
    let mut random = Rng::with_seed(12);
    let extremes = [0.0, -0.0, 1.0, -1e6, 1e300, f64::MAX, f64::MIN, 5e-324, 0.1];
    for _ in 0..2000 {
        let mut point = || [0; 3].map(|_| extremes[random.usize(..extremes.len())]);
        let (x0, x1) = ([point()], [point()]);
        let mesh = exact_ccd_mesh::TriangleMesh::new(1, vec![]).unwrap();
        let step = Step::new(&mesh, &x0, &x1).unwrap();
        assert_eq!(step.at(0.0), x0);
        assert_eq!(step.at(f64::NAN), x0);
        assert_eq!(step.at(1.0), x1);
        let time = random.f64();
        for axis in 0..3 {
            let (a, b, x) = (x0[0][axis], x1[0][axis], step.at(time)[0][axis]);
            assert!(a.min(b) <= x && x <= a.max(b));
            // Halves, so that nothing overflows.
            let exact = (1.0 - time) * (0.5 * a) + time * (0.5 * b);
            let largest = a.abs().max(b.abs());
            assert!((0.5 * x - exact).abs() <= 4.0 * f64::EPSILON * largest + f64::MIN_POSITIVE);
        }
    }
}
