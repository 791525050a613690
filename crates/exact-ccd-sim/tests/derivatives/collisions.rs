//! The sum of the barriers over all pairs that are near, each by itself, against the set in which equal ones are merged.

use exact_ccd_mesh::{Point, TriangleMesh};
use exact_ccd_sim::contact::{Barrier, Collisions, Pairs, Surface};
use exact_ccd_sim::distance::Mollifier;
use nalgebra::Vector3;

use crate::differences::{Points, random_rotation, random_vector};

/// The distance at which the barrier begins.
const DISTANCE: f64 = 0.5;

/// The weights of four points in the shortest vector between two primitives: found without the library's features.
type Weights = [f64; 4];

fn vector(points: &Points, weights: &Weights) -> Vector3<f64> {
    points
        .iter()
        .zip(weights)
        .map(|(point, weight)| point * *weight)
        .sum()
}

fn shortest(points: &Points, choices: impl IntoIterator<Item = Weights>) -> Weights {
    let length = |weights: &Weights| vector(points, weights).norm();
    choices
        .into_iter()
        .min_by(|a, b| length(a).total_cmp(&length(b)))
        .unwrap()
}

fn to_segment(points: &Points, point: usize, [a, b]: [usize; 2]) -> Weights {
    let edge = points[b] - points[a];
    let share = (edge.dot(&(points[point] - points[a])) / edge.norm_squared()).clamp(0.0, 1.0);
    let mut weights = [0.0; 4];
    (weights[point], weights[a], weights[b]) = (1.0, share - 1.0, -share);
    weights
}

/// From the triangle's plane if the foot is inside, or else from one of its sides.
fn to_triangle(points: &Points) -> Weights {
    let [p, a, b, c] = *points;
    let normal = (b - a).cross(&(c - a));
    let share = |from: Vector3<f64>, to: Vector3<f64>| {
        (to - from).cross(&(p - from)).dot(&normal) / normal.norm_squared()
    };
    let shares = [share(b, c), share(c, a), share(a, b)];
    if shares.iter().all(|&share| share >= 0.0) {
        return [1.0, -shares[0], -shares[1], -shares[2]];
    }
    shortest(
        points,
        [[1, 2], [2, 3], [3, 1]].map(|side| to_segment(points, 0, side)),
    )
}

/// Between the lines if both feet are inside, or else from one of the ends.
fn between_edges(points: &Points) -> Weights {
    let [a, b, c, d] = *points;
    let (u, v) = (b - a, d - c);
    let normal = u.cross(&v);
    let s = (c - a).cross(&v).dot(&normal) / normal.norm_squared();
    let t = (c - a).cross(&u).dot(&normal) / normal.norm_squared();
    if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
        return [1.0 - s, s, t - 1.0, -t];
    }
    let ends = [(0, [2, 3]), (1, [2, 3]), (2, [0, 1]), (3, [0, 1])];
    shortest(points, ends.map(|(end, edge)| to_segment(points, end, edge)))
}

/// What is summed pair by pair.
struct Naive {
    value: f64,
    gradient: Vec<Vector3<f64>>,
    minimum: f64,
    /// How many pairs are near, and of them those of edges that are nearly parallel.
    count: [usize; 2],
}

impl Naive {
    fn new(surface: &Surface, obstacle: &[bool], points: &[Point], rest: &[Point], barrier: Barrier) -> Self {
        let mut sum = Self {
            value: 0.0,
            gradient: vec![Vector3::zeros(); points.len()],
            minimum: f64::INFINITY,
            count: [0; 2],
        };
        let is_of_concern = |vertices: [u32; 4], first: usize| {
            let (a, b) = vertices.split_at(first);
            a.iter().all(|vertex| !b.contains(vertex))
                && !vertices.into_iter().all(|vertex| obstacle[vertex as usize])
        };
        let counts = [
            surface.mesh().faces().len() as u32,
            surface.mesh().edges().len() as u32,
        ];
        for vertex in 0..points.len() as u32 {
            for face in 0..counts[0] {
                let vertices = surface.vertex_face([vertex, face]);
                if is_of_concern(vertices, 1) {
                    let corners = at(points, vertices);
                    sum.add(vertices, &corners, &to_triangle(&corners), None, barrier);
                }
            }
        }
        for a in 0..counts[1] {
            for b in a + 1..counts[1] {
                let vertices = surface.edge_edge([a, b]);
                if is_of_concern(vertices, 2) {
                    let [p, q, r, s] = at(rest, vertices);
                    let mollifier = Mollifier::new([(q - p).norm_squared(), (s - r).norm_squared()]);
                    let corners = at(points, vertices);
                    sum.add(
                        vertices,
                        &corners,
                        &between_edges(&corners),
                        Some(mollifier),
                        barrier,
                    );
                }
            }
        }
        sum
    }

    /// m b(|r|²), whose gradient is m b′ 2 wᵢ r + b ∇m.
    fn add(
        &mut self,
        vertices: [u32; 4],
        corners: &Points,
        weights: &Weights,
        mollifier: Option<Mollifier>,
        barrier: Barrier,
    ) {
        let vector = vector(corners, weights);
        let squared = vector.norm_squared();
        if squared >= barrier.reach() {
            return;
        }
        let fade = mollifier.map_or(1.0, |mollifier| mollifier.value(corners));
        let fades = mollifier.map_or_else(exact_ccd_sim::Vector12::zeros, |mollifier| {
            mollifier.derivatives(corners).0
        });
        self.value += fade * barrier.value(squared);
        for (place, &vertex) in vertices.iter().enumerate() {
            let push = vector * (2.0 * weights[place] * barrier.slope(squared) * fade);
            self.gradient[vertex as usize] +=
                push + fades.fixed_rows::<3>(3 * place) * barrier.value(squared);
        }
        self.minimum = self.minimum.min(vector.norm());
        self.count[0] += 1;
        self.count[1] += usize::from(fade < 1.0);
    }
}

fn at(points: &[Point], vertices: [u32; 4]) -> Points {
    vertices.map(|vertex| Vector3::from(points[vertex as usize]))
}

/// Two tetrahedra and a triangle of an obstacle about them. What is nearest is at times a corner, at times an edge.
fn random_bodies(random: &mut fastrand::Rng) -> Vec<Point> {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector3::from);
    // Turned at random, or not at all: then edges are parallel, or nearly.
    let mut turn = |angle: f64| random_rotation(random).powf(angle);
    let turns = [turn(1.0), turn(1.0)];
    let wobble = turn(0.01);
    let turns = if random.bool() {
        turns
    } else {
        [turns[0], wobble * turns[0]]
    };
    let gap = 0.02 + 0.3 * random.f64();
    let direction = random_vector(random).normalize();
    let [first, second] = turns.map(|turn| corners.map(|corner| turn * corner));
    // So far along the direction that there is just the gap between the projections.
    let along = |points: &Points| points.map(|point| point.dot(&direction));
    let end = along(&first).into_iter().fold(f64::NEG_INFINITY, f64::max);
    let begin = along(&second).into_iter().fold(f64::INFINITY, f64::min);
    let aside = random_vector(random) * 0.4;
    let shift = direction * (end - begin + gap) + aside - direction * aside.dot(&direction);
    let second = second.map(|point| point + shift);
    let lowest = first
        .iter()
        .chain(&second)
        .map(|point| point.y)
        .fold(f64::INFINITY, f64::min);
    let floor = [[-3.0, -3.0], [5.0, -2.0], [0.0, 5.0]].map(|[x, z]| Vector3::new(x, lowest - gap, z));
    first
        .into_iter()
        .chain(second)
        .chain(floor)
        .map(Point::from)
        .collect()
}

#[test]
fn merged_collisions_sum_to_what_all_pairs_do() {
    let sides = |first: u32| [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].map(|face| face.map(|v| first + v));
    let faces: Vec<[u32; 3]> = sides(0).into_iter().chain(sides(4)).chain([[8, 9, 10]]).collect();
    let obstacle: Vec<bool> = (0..11).map(|vertex| vertex >= 8).collect();
    let surface = Surface::new(TriangleMesh::new(11, faces).unwrap(), obstacle.clone());
    let barrier = Barrier::new(DISTANCE);
    let mut random = fastrand::Rng::with_seed(3);
    // Collisions by the number of their vertices, near pairs, and nearly parallel ones.
    let (mut kinds, mut count, mut parallel) = ([0; 5], 0, 0);
    for case in 0..200 {
        let points = random_bodies(&mut random);
        // Of other lengths, on which the mollifier depends.
        let rest: Vec<Point> = points.iter().map(|point| point.map(|x| 1.5 * x)).collect();
        let pairs = Pairs::near(&surface, &points, &points, DISTANCE);
        let collisions = Collisions::new(&surface, &pairs, &points, &rest, barrier);
        let naive = Naive::new(&surface, &obstacle, &points, &rest, barrier);

        let value = collisions.value(&points);
        assert!(
            (value - naive.value).abs() <= 1e-10 * naive.value,
            "case {case}: {value} {}",
            naive.value
        );
        let scale: f64 = naive.gradient.iter().map(Vector3::norm).sum();
        for (vertex, (found, expected)) in collisions
            .gradient(&points)
            .iter()
            .zip(&naive.gradient)
            .enumerate()
        {
            let error = (found - expected).norm();
            assert!(
                error <= 1e-10 * scale,
                "case {case}, vertex {vertex}: {found} {expected}"
            );
        }
        let least = collisions.minimal_distance();
        assert!(
            least == naive.minimum || (least - naive.minimum).abs() < 1e-12,
            "case {case}: {least}"
        );

        // Each once.
        for (place, collision) in collisions.as_slice().iter().enumerate() {
            assert!(
                !collisions.as_slice()[..place]
                    .iter()
                    .any(|other| other.is_same(collision))
            );
            kinds[collision.vertices().len()] += 1;
        }
        count += naive.count[0];
        parallel += naive.count[1];
    }
    // Else there would have been little to merge.
    assert!(kinds[2] > 30 && kinds[3] > 100 && kinds[4] > 100, "{kinds:?}");
    assert!(
        count > 2 * kinds.iter().sum::<usize>() && parallel > 20,
        "{count} {kinds:?} {parallel}"
    );
}
