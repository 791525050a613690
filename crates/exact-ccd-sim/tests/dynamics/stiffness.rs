//! How stiff the barrier is made.

use exact_ccd_sim::contact::{Barrier, StiffnessRange};
use exact_ccd_sim::{Length, Script, Settings, Simulation, System, shapes};
use nalgebra::Vector3;

const SIZE: f64 = 3.0;
const MASS: f64 = 0.02;

fn range() -> (StiffnessRange, Barrier) {
    let barrier = Barrier::new(1e-3 * SIZE);
    (StiffnessRange::new(SIZE, MASS, &barrier), barrier)
}

/// At 10⁻⁸ of the size of the scene, the least barrier bends along a distance d as 10¹¹ masses do: there (d²)′² b″ κ.
#[test]
fn the_least_barrier_outweighs_masses() {
    let (range, barrier) = range();
    let distance = 1e-8 * SIZE;
    let curvature = 4.0 * distance * distance * barrier.curvature(distance * distance) * range.least;
    assert!((curvature / (1e11 * MASS) - 1.0).abs() < 1e-12, "{curvature}");
    assert_eq!(range.greatest, 100.0 * range.least);
}

/// Of all κ in the range, the one that leaves the least force: a little more or less leaves more of it.
#[test]
fn forces_are_balanced_as_well_as_they_can_be() {
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
        // Forces that κ of the wanted size would hold, and others across to them.
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
    // Nothing repels: there is nothing to balance.
    assert_eq!(range.balance(&across, &[Vector3::zeros(); 3]), range.least);
}

/// Twice as stiff where what is much too near comes nearer, and up to the greatest κ only; one that is above it stays.
#[test]
fn a_barrier_that_is_too_soft_is_doubled() {
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

/// Where scripts move everything, no vertex is free; the barrier repels nonetheless, and what is in the way is waited for.
#[test]
fn there_is_a_barrier_where_no_vertex_is_free() {
    let cloth = shapes::cloth([2, 2], [1.0, 1.0]);
    let ceiling = shapes::floor([1, 1], [3.0, 3.0]).placed(|[x, y, z]| [x - 1.0, y + 0.05, z - 1.0]);
    let up = Script::Moving {
        velocity: [0.0, 1.0, 0.0],
        until: None,
    };
    let system = System::new(&[cloth, ceiling], &[((0..9).collect(), up)]).unwrap();
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
                statistics.converged && statistics.minimal_distance.unwrap() > 1e-12,
                "{statistics:?}"
            );
        }
    }
}
