//! The barrier, and its sum over collisions.

use nalgebra::Vector3;

use super::differences::{at, check, random_points, random_vector, slope};
use crate::energies::contact::{Barrier, Collision};
use crate::energies::distance::{Mollifier, edge_edge, point_triangle};
use crate::energies::term::{Energy, Projection};

#[test]
fn the_derivatives_of_the_barrier_match_differences() {
    let barrier = Barrier::new(0.5);
    for i in 1..100 {
        let squared = 0.25 * f64::from(i) / 100.0;
        let step = 1e-4 * squared;
        let slope = (barrier.value(squared + step) - barrier.value(squared - step)) / (2.0 * step);
        assert!((barrier.slope(squared) - slope).abs() < 1e-6 * (1.0 + slope.abs()));
        let curvature = (barrier.slope(squared + step) - barrier.slope(squared - step)) / (2.0 * step);
        assert!((barrier.curvature(squared) - curvature).abs() < 1e-6 * (1.0 + curvature.abs()));
        assert!(barrier.slope(squared) < 0.0 && barrier.curvature(squared) > 0.0);
    }
}

#[test]
fn the_barrier_ends_smoothly_and_is_infinite_at_contact() {
    let barrier = Barrier::new(0.5);
    let before = 0.25_f64.next_down();
    assert!(
        barrier.value(before) < 1e-40 && barrier.slope(before) > -1e-14 && barrier.curvature(before) < 1e-12
    );
    assert_eq!(
        [barrier.value(0.25), barrier.slope(0.25), barrier.curvature(0.25)],
        [0.0; 3]
    );
    assert_eq!(barrier.value(0.0), f64::INFINITY);
    assert!(barrier.value(1e-300) > 40.0);
}

#[test]
fn the_derivatives_of_collisions_match_differences() {
    let mut random = fastrand::Rng::with_seed(1);
    let barrier = Barrier::new(1.0);
    let (mut tested, mut indefinite, mut sizes) = (0, 0, [0; 5]);
    while tested < 400 {
        let points = random_points(&mut random);
        let feature = if tested % 2 == 0 {
            point_triangle(&points)
        } else {
            edge_edge(&points)
        };
        let squared = feature.shortest_vector(&points).squared();
        let [a, b, c, d] = points;
        let sines = [(b - a).cross(&(d - c)), (c - b).cross(&(d - b))];
        if !(0.01..0.9).contains(&squared) || sines.iter().any(|sine| sine.norm() < 0.5) {
            continue;
        }
        tested += 1;
        let collision = Collision::new([0, 1, 2, 3], feature, barrier);
        sizes[collision.vertices().len()] += 1;
        // The canonical form, without unused vertices, has the same distance.
        let shortest = collision.shortest_vector(&at(&points)).squared();
        assert!((shortest - squared).abs() < 1e-12);
        indefinite += usize::from(check(&collision, &points, 1e-5, [1e-5; 2], "collision") < -1e-9);
    }
    assert!(
        indefinite > 20 && sizes[2..].iter().all(|&count| count > 20),
        "{indefinite} {sizes:?}"
    );
}

#[test]
fn the_derivatives_of_mollified_collisions_match_differences() {
    let mut random = fastrand::Rng::with_seed(2);
    let barrier = Barrier::new(1.0);
    let mut tested = 0;
    while tested < 50 {
        let [a, b, c, _] = random_points(&mut random);
        let d = c + (b - a) + random_vector(&mut random) * 0.3;
        let points = [a, b, c, d];
        let mollifier = Mollifier::new([20.0, 20.0]);
        let feature = edge_edge(&points);
        let squared = feature.shortest_vector(&points).squared();
        // Differences need a distance from the end of the mollifier and from changes of the closest feature.
        let shares = feature.shortest_vector(&points).weights;
        let inside = shares
            .iter()
            .all(|share| share.abs() < 1e-9 || (0.05..0.95).contains(&share.abs()) || share.abs() == 1.0);
        let sine = (b - a).cross(&(d - c)).norm();
        if !(0.05..0.9).contains(&squared) || !(0.1..0.6).contains(&sine) || !inside {
            continue;
        }
        tested += 1;
        let collision = Collision::mollified([0, 1, 2, 3], feature, mollifier, barrier);
        assert_eq!(collision.vertices().len(), 4);
        check(&collision, &points, 1e-5, [1e-5; 2], "mollified");
    }
}

/// Equal features of different primitives are the same collision.
#[test]
fn features_have_a_canonical_form() {
    let barrier = Barrier::new(1.0);
    let [o, x, y] = [Vector3::zeros(), Vector3::x(), Vector3::y()];
    let p = Vector3::new(0.5, -0.5, 0.0);
    let (face, back) = ([p, o, x, y], [p, x, o, y]);
    let one = Collision::new([7, 3, 5, 6], point_triangle(&face), barrier);
    let other = Collision::new([7, 5, 3, 6], point_triangle(&back), barrier);
    assert!(one.is_same(&other));
    assert_eq!(one.vertices(), [7, 3, 5]);
    // The same features, from a pair of edges.
    let edges = [o, x, p, p - y];
    let third = Collision::new(
        [5, 3, 7, 8],
        edge_edge(&[edges[1], edges[0], edges[2], edges[3]]),
        barrier,
    );
    assert!(one.is_same(&third), "{third:?}");
}

/// The positive weights of nearly parallel edges belong to the first of the vertices, whichever edge has the
/// end that is closest.
#[test]
fn mollified_collisions_have_a_canonical_order() {
    let mut random = fastrand::Rng::with_seed(5);
    let barrier = Barrier::new(10.0);
    let mut swapped = 0;
    for _ in 0..200 {
        let [a, b, c, _] = random_points(&mut random);
        let d = c + (b - a) * random.f64() + random_vector(&mut random) * 1e-3;
        let points = [a, b, c, d];
        let mollifier = Mollifier::new([20.0, 20.0]);
        let feature = edge_edge(&points);
        let collision = Collision::mollified([0, 1, 2, 3], feature, mollifier, barrier);
        let shortest = collision.shortest_vector(&at(&points));
        assert!(shortest.weights[..2].iter().all(|&weight| weight >= 0.0));
        assert!(shortest.weights[2..].iter().all(|&weight| weight <= 0.0));
        swapped += usize::from(collision.vertices()[0] == 2);
        // The distance is the same as with the edges in their first order.
        let squared = feature.shortest_vector(&points).squared();
        assert!((shortest.squared() - squared).abs() <= 1e-12 * squared);
    }
    assert!((20..180).contains(&swapped), "{swapped}");
}

/// Parallel edges whose distance rounds to zero have no barrier, and no derivatives.
#[test]
fn parallel_edges_that_touch_have_finite_derivatives() {
    let barrier = Barrier::new(1.0);
    let points = [0.0, 2.0, 1.0, 3.0].map(|x| Vector3::x() * x);
    let mollifier = Mollifier::new([4.0, 4.0]);
    let collision = Collision::mollified([0, 1, 2, 3], edge_edge(&points), mollifier, barrier);
    assert_eq!(collision.shortest_vector(&at(&points)).squared(), 0.0);
    assert_eq!(collision.value(&at(&points)), 0.0);
    assert_eq!(slope(&collision, &points).amax(), 0.0);
    assert_eq!(collision.normal_force(&at(&points)), 0.0);
    for projection in [Projection::None, Projection::SemiDefinite] {
        assert_eq!(collision.hessian(&at(&points), projection).amax(), 0.0);
    }
}
