//! Closest points of primitives, in rounded numbers (Ericson 2005, *Real-Time Collision Detection*, 5.1).

use exact_ccd_mesh::Point;
use exact_ccd_mesh::vector::{cross, dot, minus};

/// The weights of the corners at the point of a face that is closest to a point.
pub(crate) fn closest_in_face(point: Point, [a, b, c]: [Point; 3]) -> [f64; 3] {
    let normal = cross(minus(b, a), minus(c, a));
    let square = dot(normal, normal);
    let weight = |from: Point, to: Point| {
        let area = dot(normal, cross(minus(to, from), minus(point, from)));
        if square > 0.0 { area / square } else { -1.0 }
    };
    let weights = [weight(b, c), weight(c, a), weight(a, b)];
    if weights.iter().all(|&weight| weight >= 0.0) {
        return weights;
    }
    // It is on a side.
    let on = |from: Point, to: Point| {
        let t = closest_on_edge(point, [from, to]);
        let apart = [0, 1, 2].map(|axis: usize| from[axis] + t * (to[axis] - from[axis]) - point[axis]);
        (dot(apart, apart), t)
    };
    let ((of_ab, t), (of_bc, u), (of_ca, v)) = (on(a, b), on(b, c), on(c, a));
    if of_ab <= of_bc && of_ab <= of_ca {
        [1.0 - t, t, 0.0]
    } else if of_bc <= of_ca {
        [0.0, 1.0 - u, u]
    } else {
        [v, 0.0, 1.0 - v]
    }
}

/// The places on two edges at which they are closest: 0 at the first end, 1 at the second.
pub(crate) fn closest_of_edges([a, b]: [Point; 2], [c, d]: [Point; 2]) -> [f64; 2] {
    let (first, second, between) = (minus(b, a), minus(d, c), minus(a, c));
    let [f, s, m] = [dot(first, first), dot(second, second), dot(first, second)];
    let (along_first, along_second) = (dot(first, between), dot(second, between));
    let determinant = f * s - m * m;
    let place = (m * along_second - s * along_first) / determinant;
    let place = if determinant > 0.0 {
        place.clamp(0.0, 1.0)
    } else {
        0.0
    };
    let point = [0, 1, 2].map(|axis: usize| a[axis] + place * first[axis]);
    let other = closest_on_edge(point, [c, d]);
    let point = [0, 1, 2].map(|axis: usize| c[axis] + other * second[axis]);
    [closest_on_edge(point, [a, b]), other]
}

/// The place on an edge that is closest to a point.
fn closest_on_edge(point: Point, [a, b]: [Point; 2]) -> f64 {
    let along = minus(b, a);
    let place = dot(minus(point, a), along) / dot(along, along);
    if place.is_nan() {
        0.0
    } else {
        place.clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(random: &mut fastrand::Rng) -> Point {
        [0; 3].map(|_| random.f64())
    }

    fn between(points: &[Point], weights: &[f64]) -> Point {
        [0, 1, 2].map(|axis: usize| points.iter().zip(weights).map(|(p, w)| w * p[axis]).sum())
    }

    fn distance(a: Point, b: Point) -> f64 {
        dot(minus(a, b), minus(a, b)).sqrt()
    }

    #[test]
    fn no_other_point_of_a_face_is_closer() {
        let mut random = fastrand::Rng::with_seed(5);
        for _ in 0..200 {
            let p = point(&mut random);
            let face = [0; 3].map(|_| point(&mut random));
            let least = distance(p, between(&face, &closest_in_face(p, face)));
            for _ in 0..50 {
                let (u, v) = (random.f64(), random.f64());
                let other = between(&face, &[1.0 - u, u * (1.0 - v), u * v]);
                assert!(least <= distance(p, other) + 1e-12);
            }
        }
    }

    #[test]
    fn no_other_points_of_edges_are_closer() {
        let mut random = fastrand::Rng::with_seed(7);
        for _ in 0..200 {
            let [a, b] = [0; 2].map(|_| [0; 2].map(|_| point(&mut random)));
            let [s, t] = closest_of_edges(a, b);
            let least = distance(between(&a, &[1.0 - s, s]), between(&b, &[1.0 - t, t]));
            for _ in 0..50 {
                let [s, t] = [random.f64(), random.f64()];
                let other = distance(between(&a, &[1.0 - s, s]), between(&b, &[1.0 - t, t]));
                assert!(least <= other + 1e-12);
            }
        }
        // Points, and parallel edges.
        let [p, q] = [[0.0; 3], [1.0, 0.0, 0.0]];
        assert_eq!(closest_of_edges([p, p], [q, q]), [0.0; 2]);
        let shifted = [[0.25, 1.0, 0.0], [0.75, 1.0, 0.0]];
        let [s, t] = closest_of_edges([p, q], shifted);
        assert!((distance(between(&[p, q], &[1.0 - s, s]), between(&shifted, &[1.0 - t, t])) - 1.0) < 1e-15);
    }
}
