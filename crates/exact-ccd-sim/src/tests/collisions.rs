//! The constraint set, in which equal collisions are merged, against the sum over all pairs of primitives.

use exact_ccd_mesh::{Bvh, CanCollide, CandidateOptions, Candidates, Point, Step, TriangleMesh};
use nalgebra::Vector3;

use super::differences::{Points, random_rotation, random_vector};
use super::naive::Naive;
use crate::energies::contact::{Barrier, CollisionSet, Surface};
use crate::energies::term::Energy;
use crate::solver::Form;

/// The activation distance of the barrier.
const DISTANCE: f64 = 0.5;

/// Two tetrahedra, and a triangle of an obstacle below them, in random positions.
fn random_bodies(random: &mut fastrand::Rng) -> Vec<Point> {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector3::from);
    // The relative rotation is random or small. If it is small, edges are nearly parallel.
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
    // The shift along the direction leaves exactly the gap between the projections of the tetrahedra.
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
fn the_sum_over_merged_collisions_is_the_sum_over_all_pairs() {
    let sides = |first: u32| [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].map(|face| face.map(|v| first + v));
    let faces: Vec<[u32; 3]> = sides(0).into_iter().chain(sides(4)).chain([[8, 9, 10]]).collect();
    let obstacle: Vec<bool> = (0..11).map(|vertex| vertex >= 8).collect();
    let mesh = TriangleMesh::new(11, faces).unwrap();
    let options = CandidateOptions::default()
        .with_distance(DISTANCE)
        .with_can_collide(CanCollide::not_two_obstacles(obstacle.clone()));
    let barrier = Barrier::new(DISTANCE);
    let mut random = fastrand::Rng::with_seed(3);
    // Counts of collisions by their number of vertices, of near pairs, and of nearly parallel edges.
    let (mut kinds, mut count, mut parallel) = ([0; 5], 0, 0);
    for case in 0..200 {
        let points = random_bodies(&mut random);
        // The mollifier depends on the lengths at rest, so these differ from the current ones.
        let rest: Vec<Point> = points.iter().map(|point| point.map(|x| 1.5 * x)).collect();
        let step = Step::new(&mesh, &points, &points).unwrap();
        let candidates = Candidates::with_options(step, &Bvh, &options).unwrap();
        let surface = Surface::new(&mesh, &rest);
        let collisions = CollisionSet::new(surface, &candidates, &points, barrier);
        let naive = Naive::new(&mesh, &obstacle, &points, &rest, barrier);

        let sum = Form::of(collisions.as_slice(), 1.0);
        let value = sum.value(&points);
        assert!(
            (value - naive.value).abs() <= 1e-10 * naive.value,
            "case {case}: {value} {}",
            naive.value
        );
        let scale: f64 = naive.gradient.iter().map(Vector3::norm).sum();
        for (vertex, (found, expected)) in sum.gradient(&points).iter().zip(&naive.gradient).enumerate() {
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

        // All collisions are distinct.
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
    // The cases must contain collisions of all kinds, and pairs to merge.
    assert!(kinds[2] > 30 && kinds[3] > 100 && kinds[4] > 100, "{kinds:?}");
    assert!(
        count > 2 * kinds.iter().sum::<usize>() && parallel > 20,
        "{count} {kinds:?} {parallel}"
    );
}
