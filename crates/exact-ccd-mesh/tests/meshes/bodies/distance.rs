//! The distance of bodies at poses, against the distances of all pairs of primitives in the world.

use exact_ccd::predicates::EdgeFace;
use exact_ccd::{EdgeEdge, Query, VertexEdge, VertexFace, VertexVertex};

use super::*;

/// The rotated and displaced point, in floating point.
fn placed(pose: &Pose, [x, y, z]: Point) -> Point {
    let [a, b, c, d] = pose.rotation();
    let square = a * a + b * b + c * c + d * d;
    let turned = [
        (a * a + b * b - c * c - d * d) * x + 2.0 * (b * c - a * d) * y + 2.0 * (b * d + a * c) * z,
        2.0 * (b * c + a * d) * x + (a * a - b * b + c * c - d * d) * y + 2.0 * (c * d - a * b) * z,
        2.0 * (b * d - a * c) * x + 2.0 * (c * d + a * b) * y + (a * a - b * b - c * c + d * d) * z,
    ];
    [0, 1, 2].map(|axis: usize| turned[axis] / square + pose.place()[axis])
}

fn in_world(frame: &Frame, pose: &Pose) -> Frame {
    Frame {
        mesh: frame.mesh.clone(),
        positions: frame.positions.iter().map(|&point| placed(pose, point)).collect(),
    }
}

fn between<K: Kind>(first: &[Point], second: &[Point]) -> f64 {
    let mut points = K::Points::default();
    let all = first.iter().chain(second);
    for (target, point) in points.as_mut().iter_mut().zip(all) {
        *target = *point;
    }
    let query = Query::<K>::new(points, points).unwrap();
    query.distance_at(0.0).unwrap().lower
}

/// The distance of the surfaces of two bodies in the world, by all pairs of primitives: loose or not.
fn least(one: &Frame, other: &Frame) -> f64 {
    let at = |frame: &Frame, ids: &[u32]| -> Vec<Point> {
        ids.iter().map(|&id| frame.positions[id as usize]).collect()
    };
    let all = |frame: &Frame| {
        let vertices: Vec<_> = frame.positions.iter().map(|&point| vec![point]).collect();
        let edges: Vec<_> = frame.mesh.edges().iter().map(|edge| at(frame, edge)).collect();
        let faces: Vec<_> = frame.mesh.faces().iter().map(|face| at(frame, face)).collect();
        [vertices, edges, faces]
    };
    let ([v, e, f], [w, g, h]) = (all(one), all(other));
    let mut least = f64::INFINITY;
    let mut add = |a: &[Vec<Point>], b: &[Vec<Point>], distance: fn(&[Point], &[Point]) -> f64| {
        for (first, second) in a.iter().flat_map(|a| b.iter().map(move |b| (a, b))) {
            least = least.min(distance(first, second));
        }
    };
    add(&v, &w, between::<VertexVertex>);
    add(&v, &g, between::<VertexEdge>);
    add(&w, &e, between::<VertexEdge>);
    add(&v, &h, between::<VertexFace>);
    add(&w, &f, between::<VertexFace>);
    add(&e, &g, between::<EdgeEdge>);
    let crossing = |edge: &[Point], face: &[Point]| {
        let query = EdgeFace::new([edge[0], edge[1]], [face[0], face[1], face[2]]).unwrap();
        if query.intersects() { 0.0 } else { f64::INFINITY }
    };
    add(&e, &h, crossing);
    add(&g, &f, crossing);
    least
}

/// A pose, whose coordinates are at most 6: the bodies are apart, or they intersect.
fn pose(random: &mut Rng, is_lattice: bool) -> Pose {
    loop {
        let rotation = [(); 4].map(|()| number(random, is_lattice));
        let factor = [0.25, 3.0][random.usize(..2)];
        let place = point(random, is_lattice).map(|x| factor * x);
        if let Ok(pose) = Pose::new(rotation, place) {
            return pose;
        }
    }
}

fn length([x, y, z]: Point) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

#[test]
fn distances_are_those_of_all_pairs_of_primitives() {
    let mut random = Rng::with_seed(7);
    let (mut apart, mut crossing) = (0, 0);
    for case in 0..600 {
        let is_lattice = case % 2 == 0;
        let frames = [(); 3].map(|()| body(&mut random, is_lattice));
        let poses = [(); 3].map(|()| pose(&mut random, is_lattice));
        let world: Vec<_> = frames
            .iter()
            .zip(&poses)
            .map(|(frame, pose)| in_world(frame, pose))
            .collect();
        let bodies = Bodies::new(frames).unwrap();
        let found = bodies.distances(&poses, Separation::new(100.0).unwrap()).unwrap();
        assert_eq!(found.len(), 3, "{case}");
        for distance in &found {
            let [i, j] = distance.bodies;
            let expected = least(&world[i], &world[j]);
            let [lower, upper] = [distance.bounds.lower, distance.bounds.upper];
            // The places here are rounded too.
            assert!(
                lower <= expected + 1e-12 && expected <= upper + 1e-12,
                "{case} {distance:?} {expected}"
            );
            assert!(upper - lower < 1e-10, "{case} {distance:?}");
            let [a, b] = distance.points;
            let between = length([0, 1, 2].map(|axis: usize| a[axis] - b[axis]));
            if expected == 0.0 {
                let point = Frame::with_edges(vec![a], Vec::new(), &[]).unwrap();
                let from = [i, j].map(|body| least(&point, &world[body]));
                assert!(
                    between < 1e-8 && from.iter().all(|&x| x < 1e-8),
                    "{case} {distance:?} {from:?}"
                );
                crossing += 1;
            } else {
                assert!(
                    (between - expected).abs() < 1e-8 * (1.0 + expected),
                    "{case} {distance:?} {expected}"
                );
                apart += 1;
            }
        }
        let nearest = bodies.distance(&poses).unwrap().unwrap();
        assert!(
            found.iter().all(|one| one.bounds.lower >= nearest.bounds.lower),
            "{case}"
        );
        let cut_off = found[0].bounds.upper;
        let near = bodies
            .distances(&poses, Separation::new(cut_off).unwrap())
            .unwrap();
        let expected: Vec<_> = found
            .iter()
            .filter(|one| one.bounds.lower <= cut_off)
            .map(|one| one.bodies)
            .collect();
        assert_eq!(
            near.iter().map(|one| one.bodies).collect::<Vec<_>>(),
            expected,
            "{case}"
        );
    }
    assert!(apart > 500 && crossing > 50, "{apart} {crossing}");
}

#[test]
fn a_body_inside_another_one_is_at_a_distance_from_its_surface() {
    let tetrahedron = |size: f64| {
        let corners = [
            [1.0, 1.0, 1.0],
            [1.0, -1.0, -1.0],
            [-1.0, 1.0, -1.0],
            [-1.0, -1.0, 1.0],
        ];
        let faces = vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
        Frame::with_edges(corners.map(|point| point.map(|x| size * x)).to_vec(), faces, &[]).unwrap()
    };
    let bodies = Bodies::new([tetrahedron(1.0), tetrahedron(6.0)]).unwrap();
    let rest = Pose::new([1.0, 0.0, 0.0, 0.0], [0.0; 3]).unwrap();
    let distance = bodies.distance(&[rest, rest]).unwrap().unwrap();
    // The faces are parallel, at 1/√3 and 6/√3 from the origin.
    let expected = 5.0 / 3.0_f64.sqrt();
    assert!(
        (distance.bounds.lower - expected).abs() < 1e-10,
        "{distance:?} {expected}"
    );
}

#[test]
fn places_whose_errors_have_no_bound_say_nothing() {
    let mut random = Rng::with_seed(8);
    let bodies = Bodies::new([(); 2].map(|()| body(&mut random, true))).unwrap();
    let far = |x: f64| Pose::new([1.0, 0.0, 0.0, 0.0], [x, 0.0, 0.0]).unwrap();
    let distance = bodies.distance(&[far(1e300), far(-1e300)]).unwrap().unwrap();
    assert_eq!(
        (distance.bounds.lower, distance.bounds.upper),
        (0.0, f64::INFINITY)
    );
}
