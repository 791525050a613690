//! The barrier of surfaces with a thickness.

use nalgebra::Vector3;

use super::differences::{at, check, random_points, slope};
use crate::energies::contact::{Barrier, Collision};
use crate::energies::distance::{Mollifier, edge_edge, point_edge, point_triangle};
use crate::energies::term::Energy;

const REACH: f64 = 0.25;

#[test]
fn the_derivatives_of_the_barrier_with_thickness_match_differences() {
    for thickness in [1e-3, 0.1, 0.5, 4.0] {
        let barrier = Barrier::new(REACH).with_thickness(thickness);
        for i in 1..100 {
            let distance = thickness + REACH * f64::from(i) / 100.0;
            let squared = distance * distance;
            let step = 1e-4 * (squared - thickness * thickness);
            let slope = (barrier.value(squared + step) - barrier.value(squared - step)) / (2.0 * step);
            assert!((barrier.slope(squared) - slope).abs() < 1e-6 * (1e-3 + slope.abs()));
            let curvature = (barrier.slope(squared + step) - barrier.slope(squared - step)) / (2.0 * step);
            assert!((barrier.curvature(squared) - curvature).abs() < 1e-6 * (1e-3 + curvature.abs()));
            assert!(barrier.slope(squared) < 0.0 && barrier.curvature(squared) > 0.0);
            assert!((barrier.gap(squared) - (distance - thickness)).abs() < 1e-14);
        }
    }
}

#[test]
fn the_barrier_is_infinite_at_the_thickness_and_ends_at_the_activation_distance() {
    for thickness in [1e-3, 0.1, 0.5, 4.0] {
        let barrier = Barrier::new(REACH).with_thickness(thickness);
        assert_eq!(barrier.value(thickness * thickness), f64::INFINITY);
        assert_eq!(barrier.value(0.25 * thickness * thickness), f64::INFINITY);
        assert!(barrier.value((thickness * (1.0 + 1e-12)).powi(2)) > 0.0);
        let end = (thickness + REACH).powi(2);
        let [before, after] = [end * (1.0 - 1e-13), end * (1.0 + 1e-13)];
        assert!(barrier.is_active(before) && !barrier.is_active(after));
        assert!(barrier.value(before) < 1e-20 && barrier.slope(before) > -1e-10);
        assert_eq!(
            [
                barrier.value(after),
                barrier.slope(after),
                barrier.curvature(after)
            ],
            [0.0; 3]
        );
    }
}

/// A thickness of zero is the barrier without thickness, bit for bit.
#[test]
fn no_thickness_is_the_plain_barrier() {
    let (plain, thin) = (Barrier::new(REACH), Barrier::new(REACH).with_thickness(0.0));
    assert_eq!(plain, thin);
    let d_hat = REACH * REACH;
    for i in 1..100 {
        let squared = d_hat * f64::from(i) / 100.0;
        let gap = squared - d_hat;
        assert_eq!(plain.value(squared), -gap * gap * (squared / d_hat).ln());
    }
}

/// At the same gap, the forces of thick and of thin surfaces are of the same magnitude: their ratio is from
/// 1/2 near contact to 1/8 near the activation distance.
#[test]
fn forces_hardly_depend_on_the_thickness() {
    for i in 1..100 {
        let gap = 1e-3 * f64::from(i) / 100.0;
        let force = |thickness: f64| {
            let distance = thickness + gap;
            -2.0 * distance
                * Barrier::new(1e-3)
                    .with_thickness(thickness)
                    .slope(distance * distance)
        };
        let ratio = force(0.1) / force(0.0);
        assert!((0.1..1.0).contains(&ratio), "{gap}: {ratio}");
    }
}

#[test]
fn the_derivatives_of_collisions_with_thickness_match_differences() {
    let mut random = fastrand::Rng::with_seed(31);
    let barrier = Barrier::new(0.5).with_thickness(0.3);
    let (mut tested, mut indefinite, mut mollified) = (0, 0, 0);
    while tested < 300 {
        let points = random_points(&mut random);
        let feature = match tested % 3 {
            0 => point_triangle(&points),
            1 => edge_edge(&points),
            _ => point_edge(&points, 0, 1, 2),
        };
        let distance = feature.shortest_vector(&points).squared().sqrt();
        let [a, b, c, d] = points;
        let sines = [(b - a).cross(&(d - c)), (c - b).cross(&(d - b))];
        if !(0.35..0.75).contains(&distance) || sines.iter().any(|sine| sine.norm() < 0.5) {
            continue;
        }
        tested += 1;
        let vertices = [0, 1, 2, 3];
        let mollifier = Mollifier::new([30.0, 30.0]);
        let collision = if tested % 3 == 2 && mollifier.is_active(&points) {
            mollified += 1;
            Collision::mollified(vertices, feature, mollifier, barrier)
        } else {
            Collision::new(vertices, feature, barrier)
        };
        let least = check(&collision, &points, 1e-5, [1e-5; 2], "thick collision");
        indefinite += usize::from(least < -1e-9);
        // The normal force is the gradient by the distance, for unit weights.
        let gradient = slope(&collision, &points);
        let shortest = collision.shortest_vector(&at(&points));
        let force: Vector3<f64> = (0..)
            .zip(collision.vertices())
            .filter(|&(place, _): &(usize, &u32)| shortest.weights[place] > 0.0)
            .map(|(_, &vertex)| -gradient.fixed_rows::<3>(3 * vertex as usize))
            .sum();
        if tested % 3 != 2 {
            let normal = collision.normal_force(&at(&points));
            assert!((force.norm() - normal).abs() < 1e-10 * normal);
        }
    }
    assert!(indefinite > 20 && mollified > 10, "{indefinite} {mollified}");
}
