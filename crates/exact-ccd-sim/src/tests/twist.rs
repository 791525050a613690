//! Twist of rods.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::differences::{at, check, random_points, random_vector};
use crate::energies::elasticity::paths_between_ends;
use crate::energies::elasticity::{Chain, Twist};
use crate::energies::term::{Block, Energy, Projection, write_blocks};

/// The twist of a chain as an energy of its four inner vertices. The first and the last edge are held.
#[derive(Debug)]
struct Clamped(Twist);

impl Clamped {
    fn points(points: &[Point]) -> Vec<Point> {
        let before = [[-0.5, 2.0, 0.0], [0.3, 2.5, 0.4]];
        let after = [[0.6, -2.2, 0.5], [0.0, -2.9, -0.3]];
        [&before, points, &after].concat()
    }
}

impl Energy for Clamped {
    fn vertices(&self) -> &[u32] {
        &[0, 1, 2, 3]
    }

    fn value(&self, points: &[Point]) -> f64 {
        self.0.value(&Self::points(points))
    }

    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let all = self.0.gradient(&Self::points(points));
        gradient.copy_from_slice(&all.as_slice()[6..18]);
    }

    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]) {
        let all = self.0.hessian(&Self::points(points), projection);
        write_blocks(&all.view((6, 6), (12, 12)), 4, hessian);
    }
}

/// The time step starts from another shape.
#[test]
fn the_derivatives_of_twist_match_differences() {
    let mut random = fastrand::Rng::with_seed(31);
    let (mut checked, mut indefinite) = (0, 0);
    while checked < 60 {
        let (start, points) = (random_points(&mut random), random_points(&mut random));
        let all = [start, points].map(|points| Clamped::points(&at(&points)));
        let is_sharp = |points: &Vec<Point>| {
            let edge = |pair: &[Point]| Vector3::from(pair[1]) - Vector3::from(pair[0]);
            let edges: Vec<Vector3<f64>> = points.windows(2).map(edge).collect();
            let folded = |pair: &[Vector3<f64>]| pair[0].normalize().dot(&pair[1].normalize()) < -0.7;
            edges.iter().any(|edge| edge.norm() < 0.4) || edges.windows(2).any(folded)
        };
        if all.iter().any(is_sharp) {
            continue;
        }
        let chain = Chain::new((0..8).collect(), &all[0], 0.8);
        let twist = Clamped(Twist::new(&chain, &all[0], 4.0 * random.f64() - 2.0));
        indefinite += usize::from(check(&twist, &points, 1e-3, [1e-7, 1e-6], "twist") < -1e-6);
        checked += 1;
    }
    assert!(indefinite > 30, "{indefinite}");
}

/// The inner vertices of a chain move on closed paths of many small time steps. Each continues with the twist
/// of the one before. The twist at the end equals the twist at the start; on the way it is another one. It is
/// the same as in one time step to the same place.
#[test]
fn twist_is_a_function_of_the_shape() {
    let mut random = fastrand::Rng::with_seed(32);
    let rest: Vec<Point> = (0..8).map(|place| [f64::from(place), 0.0, 0.0]).collect();
    let chain = Chain::new((0..8).collect(), &rest, 1.0);
    let mut most = 0.0_f64;
    for _ in 0..10 {
        let ways: Vec<[Vector3<f64>; 2]> = (0..4)
            .map(|_| [random_vector(&mut random) * 0.4, random_vector(&mut random) * 0.4])
            .collect();
        let shape = |time: f64| {
            let mut points = rest.clone();
            for (point, [a, b]) in points[2..6].iter_mut().zip(&ways) {
                let moved = a * time.sin() + b * (1.0 - time.cos());
                *point = (Vector3::from(*point) + moved).into();
            }
            points
        };
        let (mut points, mut angle) = (rest.clone(), 0.3);
        let steps = 200;
        for step in 1..=steps {
            let time = core::f64::consts::TAU * f64::from(step) / f64::from(steps);
            let next = shape(time);
            angle = Twist::new(&chain, &points, angle).angle(&next);
            let at_once = Twist::new(&chain, &rest, 0.3).angle(&next);
            assert!((angle - at_once).abs() < 1e-12, "{angle} {at_once}");
            most = most.max((angle - 0.3).abs());
            points = next;
        }
        assert!((angle - 0.3).abs() < 1e-12, "{angle}");
    }
    assert!(most > 0.1, "{most}");
}

#[test]
fn chains_end_at_hinges() {
    // A rod, a star of three rods, one of them a single edge, and a loop.
    let edges = [
        [1, 0],
        [1, 2],
        [10, 11],
        [11, 12],
        [10, 13],
        [14, 13],
        [15, 10],
        [20, 21],
        [21, 22],
        [22, 20],
    ];
    assert_eq!(
        paths_between_ends(&edges),
        [vec![0, 1, 2], vec![10, 11, 12], vec![10, 13, 14]]
    );
    // A loop at a hinge is one chain. An edge that is given twice is one edge.
    let lasso = [[0, 1], [1, 2], [2, 3], [3, 1], [1, 0]];
    assert_eq!(paths_between_ends(&lasso), [vec![1, 2, 3, 1]]);
}
