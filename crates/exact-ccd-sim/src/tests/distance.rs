//! Distances and closest features.

use nalgebra::Vector3;

use super::differences::{
    Points, assert_gradient, assert_hessian, gradient, jacobian, random_points, random_vector,
};
use crate::energies::distance::{
    Feature, FeatureKind, Matrix12, Mollifier, Vector12, edge_edge, point_triangle,
};

fn derivatives(feature: &Feature, points: &Points) -> (Vector12, Matrix12) {
    let factors = feature.factors(points);
    let change = factors.change;
    (
        change * factors.first,
        change * factors.second * change.transpose(),
    )
}

fn features() -> [Feature; 5] {
    [
        Feature::point_point(0, 2),
        Feature::point_line(0, 1, 2),
        Feature::point_line(3, 0, 1),
        Feature::point_plane(),
        Feature::line_line(),
    ]
}

#[test]
fn the_derivatives_of_squared_distances_match_differences() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut tested = 0;
    while tested < 200 {
        let points = random_points(&mut random);
        let feature = features()[tested % 5];
        // The distance of nearly parallel lines varies too fast for differences.
        let [a, b, c, d] = points;
        let sines = [(b - a).cross(&(d - c)), (c - b).cross(&(d - b)), b - a, c - b];
        if sines.iter().any(|sine| sine.norm() < 0.5) {
            continue;
        }
        tested += 1;
        let (first, second) = derivatives(&feature, &points);
        let expected = gradient(&points, 1e-3, |x| feature.shortest_vector(x).squared());
        assert_gradient(&first, &expected, 1e-7, "distance");
        let expected = jacobian(&points, 1e-3, |x| derivatives(&feature, x).0);
        assert_hessian(&second, &expected, 1e-7, "distance");
    }
}

/// The least distance over a fine grid on both primitives is not smaller, and not much larger.
#[test]
fn the_distance_of_the_closest_features_is_the_least_on_a_grid() {
    let mut random = fastrand::Rng::with_seed(2);
    let mut kinds = std::collections::BTreeMap::new();
    const CELLS: i32 = 40;
    let share = |i: i32| f64::from(i) / f64::from(CELLS);
    for sample in 0..2000 {
        let points = random_points(&mut random);
        let [a, b, c, d] = points;
        let mut least = f64::INFINITY;
        for i in 0..=CELLS {
            for j in 0..=CELLS {
                let (u, v) = (share(i), share(j));
                let vector = if sample % 2 == 0 {
                    // Folds the unit square of parameters onto the triangle.
                    let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
                    a - (b * (1.0 - u - v) + c * u + d * v)
                } else {
                    a * (1.0 - u) + b * u - c * (1.0 - v) - d * v
                };
                least = least.min(vector.norm());
            }
        }
        let feature = if sample % 2 == 0 {
            point_triangle(&points)
        } else {
            edge_edge(&points)
        };
        *kinds.entry((sample % 2, feature.kind())).or_insert(0) += 1;
        let distance = feature.shortest_vector(&points).squared().sqrt();
        assert!(distance <= least + 1e-12, "{distance} > {least}: {points:?}");
        // The grid's error is at most the diagonal of a cell.
        assert!(least - distance < 0.15, "{distance} < {least}: {points:?}");
    }
    use FeatureKind::{LineLine, PointLine, PointPlane, PointPoint};
    for kind in [
        (0, PointPoint),
        (0, PointLine),
        (0, PointPlane),
        (1, PointPoint),
        (1, PointLine),
        (1, LineLine),
    ] {
        assert!(kinds[&kind] > 50, "{kind:?} is rare: {kinds:?}");
    }
}

#[test]
fn parallel_and_degenerate_edges_have_a_distance() {
    let [o, x, y] = [Vector3::zeros(), Vector3::x(), Vector3::y()];
    let distance = |points: Points| edge_edge(&points).shortest_vector(&points).squared().sqrt();
    assert_eq!(distance([o, x, y, x + y]), 1.0);
    assert_eq!(distance([o, x, y + x * 3.0, y + x * 4.0]), 5.0_f64.sqrt());
    assert_eq!(distance([o, o, y, x + y]), 1.0);
    assert_eq!(distance([o, o, y, y]), 1.0);
    // The edges differ from parallel ones in the last digits.
    let tilted = x + y + Vector3::z() * 1e-15;
    assert!((distance([o, x, y, tilted]) - 1.0).abs() < 1e-12);
}

#[test]
fn the_derivatives_of_the_mollifier_match_differences() {
    let mut random = fastrand::Rng::with_seed(3);
    let mut active = 0;
    for sample in 0..100 {
        let mut points = random_points(&mut random);
        if sample % 2 == 0 {
            let edge = points[1] - points[0];
            points[3] = points[2] + edge * 1.5 + random_vector(&mut random) * 0.02;
        }
        let mollifier = Mollifier::new([(points[1] - points[0]).norm_squared(), 1.0]);
        active += usize::from(mollifier.is_active(&points));
        assert_eq!(mollifier.is_active(&points), mollifier.value(&points) < 1.0);
        let (first, second) = mollifier.derivatives(&points);
        let expected = gradient(&points, 1e-5, |x| mollifier.value(x));
        let scale = 1.0 + expected.norm();
        assert!((first - expected).norm() < 1e-6 * scale);
        let expected = jacobian(&points, 1e-5, |x| mollifier.derivatives(x).0);
        // The second derivative is discontinuous at the end of the mollifier.
        if (mollifier.value(&points) - 1.0).abs() > 1e-3 || second.norm() == 0.0 && expected.norm() == 0.0 {
            assert!((second - expected).norm() < 1e-6 * (1.0 + expected.norm()));
        }
    }
    assert!(active > 20);
}

#[test]
fn the_mollifier_of_parallel_edges_is_zero() {
    let [o, x, y] = [Vector3::zeros(), Vector3::x(), Vector3::y()];
    let mollifier = Mollifier::new([1.0, 1.0]);
    assert_eq!(mollifier.value(&[o, x, y, x + y]), 0.0);
    assert_eq!(mollifier.value(&[o, x, y, y * 2.0]), 1.0);
}
