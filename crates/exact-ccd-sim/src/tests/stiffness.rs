//! The choice of the barrier's stiffness.

use nalgebra::Vector3;

use crate::energies::contact::{Barrier, StiffnessRange};
use crate::{Length, Script, Settings, Simulation, System, shapes};

const SIZE: f64 = 3.0;
const MASS: f64 = 0.02;

fn range() -> (StiffnessRange, Barrier) {
    let barrier = Barrier::new(1e-3 * SIZE);
    (StiffnessRange::new(SIZE, MASS, 0.0, &barrier), barrier)
}

/// At the distance d of 10⁻⁸ of the scene's size, the second derivative (d²)′² b″ κ of the softest barrier is
/// 10¹¹ mean masses.
#[test]
fn the_least_stiffness_is_a_multiple_of_the_mean_mass() {
    let (range, barrier) = range();
    let distance = 1e-8 * SIZE;
    let curvature = 4.0 * distance * distance * barrier.curvature(distance * distance) * range.least;
    assert!((curvature / (1e11 * MASS) - 1.0).abs() < 1e-12, "{curvature}");
    assert_eq!(range.greatest, 100.0 * range.least);
}

/// The least barrier carries the weight of a vertex at half of the contact distance, if its inertia is small.
#[test]
fn the_least_stiffness_carries_a_weight() {
    let barrier = Barrier::new(1e-3 * SIZE);
    let weight = 0.7;
    let range = StiffnessRange::new(SIZE, 1e-12, weight, &barrier);
    let distance = 0.5 * barrier.activation_distance();
    let force = -2.0 * distance * barrier.slope(distance * distance) * range.least;
    assert!((force / weight - 1.0).abs() < 1e-12, "{force}");
}

/// The balancing κ minimises the remaining force in the range: larger and smaller κ leave more force.
#[test]
fn the_balancing_stiffness_minimises_the_remaining_force() {
    let (range, _) = range();
    let barriers = [[3.0, -1.0, 0.5], [0.0, 2.0, 0.0], [0.0; 3]].map(Vector3::from);
    let across = [[1.0, 3.0, 0.0], [0.0, 0.0, 7.0], [5.0, 0.0, 0.0]].map(Vector3::from);
    let left = |energy: &[Vector3<f64>], stiffness: f64| -> f64 {
        let pairs = energy.iter().zip(&barriers);
        pairs
            .map(|(energy, barrier)| (energy + barrier * stiffness).norm_squared())
            .sum()
    };
    for (wanted, expected) in [(-1.0, 1.0), (0.3, 1.0), (1.5, 1.5), (60.0, 60.0), (1e3, 100.0)] {
        // Forces that are balanced by κ = `wanted`, and forces orthogonal to them.
        let energy: Vec<_> = (barriers.iter().zip(&across))
            .map(|(barrier, across)| (across - barrier * wanted) * range.least)
            .collect();
        let found = range.balance(&energy, &barriers);
        assert!(
            (found / range.least / expected - 1.0).abs() < 1e-12,
            "{wanted}: {found}"
        );
        let inside = |stiffness: &f64| (range.least..=range.greatest).contains(stiffness);
        for other in [0.99 * found, 1.01 * found].into_iter().filter(inside) {
            assert!(left(&energy, found) < left(&energy, other), "{wanted}");
        }
    }
    // Without barriers, the balance is the least κ.
    assert_eq!(range.balance(&across, &[Vector3::zeros(); 3]), range.least);
}

/// κ doubles if a critical distance decreases, up to the greatest κ. A κ above the greatest one is kept.
#[test]
fn the_stiffness_doubles_if_a_critical_distance_decreases() {
    let (range, _) = range();
    let (near, nearer, far) = (1e-10 * SIZE, 0.9e-10 * SIZE, 1e-8 * SIZE);
    assert_eq!(range.adapt(range.least, near, nearer), 2.0 * range.least);
    for (before, after) in [
        (nearer, near),
        (near, near),
        (far, near),
        (near, far),
        (far, 0.9 * far),
    ] {
        assert_eq!(
            range.adapt(range.least, before, after),
            range.least,
            "{before} {after}"
        );
    }
    let stiff = 0.7 * range.greatest;
    assert_eq!(range.adapt(stiff, near, nearer), range.greatest);
    let stiffer = 3.0 * range.greatest;
    assert_eq!(range.adapt(stiffer, near, nearer), stiffer);
}

/// If scripts move all vertices, no vertex is free.
#[test]
fn the_barrier_acts_without_free_vertices() {
    let cloth = shapes::cloth([2, 2], [1.0, 1.0]);
    let ceiling = shapes::floor([1, 1], [3.0, 3.0]).placed(|[x, y, z]| [x - 1.0, y + 0.05, z - 1.0]);
    let up = Script::Moving {
        velocity: [0.0, 1.0, 0.0],
        until: None,
    };
    let system = System::new(&[cloth, ceiling], &[up.on(0..9)]).unwrap();
    let settings = Settings {
        time_step: 0.02,
        contact_distance: Length::Absolute(2e-3),
        ..Settings::default()
    };
    let mut simulation = Simulation::new(system, settings).unwrap();
    for step in 1..=4 {
        let statistics = simulation.step().unwrap();
        let highest = simulation.state().positions[..9]
            .iter()
            .map(|x| x[1])
            .fold(0.0, f64::max);
        assert!(highest < 0.05, "{highest}");
        if step > 2 {
            assert!(statistics.stiffness.unwrap() > 0.0 && statistics.script_lag > 0.0);
            assert!(
                !statistics.converged && statistics.minimal_distance.unwrap() > 1e-12,
                "{statistics:?}"
            );
        }
    }
}
