//! Meshes of shells that are too soft in twist.

use exact_ccd_sim::{Body, BodyKind, Settings, Simulation, System, Warning, shapes};

/// The part of the inner vertices in the warning about a grid of 6 × 6 cells, some with the other diagonal.
fn part(is_other: impl Fn(u32) -> bool) -> Option<f64> {
    let Body { points, kind, .. } = shapes::cloth([6, 6], [1.0, 1.0]);
    let BodyKind::Shell { mut faces, material } = kind else {
        panic!("a cloth is a shell");
    };
    for (cell, pair) in (0..).zip(faces.as_chunks_mut::<2>().0) {
        let ([a, c, b], [_, d, _]) = (pair[0], pair[1]);
        if is_other(cell) {
            *pair = [[a, d, b], [b, d, c]];
        }
    }
    let system = System::new(&[Body::new(points, BodyKind::Shell { faces, material })], &[]).unwrap();
    let simulation = Simulation::new(system, Settings::default()).unwrap();
    simulation.warnings().iter().find_map(|warning| match warning {
        Warning::Twist { part, .. } => Some(*part),
        _ => None,
    })
}

/// With alternating diagonals, 12 or 13 of 25 inner vertices have four edges. With parallel ones, none has.
#[test]
fn alternating_diagonals_are_a_warning() {
    assert_eq!(part(|_| false), None);
    assert_eq!(part(|_| true), None);
    assert_eq!(part(|cell| (cell % 6 + cell / 6) % 2 == 1), Some(12.0 / 25.0));
}
