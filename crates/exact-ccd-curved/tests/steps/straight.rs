//! Straight motion: the answer is the same as the exact step's.

use exact_ccd::Point;
use exact_ccd_curved::{CurvedStepOptions, End, Polynomial, curved_step};
use exact_ccd_mesh::{TriangleMesh, step};

use crate::within;

#[test]
fn the_times_are_those_of_the_exact_step() {
    let mut random = fastrand::Rng::with_seed(8);
    let mut free = 0;
    for _ in 0..300 {
        let count = 12;
        let faces = (0..5).map(|_| [0; 3].map(|_| random.u32(0..count))).collect();
        let mesh = TriangleMesh::new(count as usize, faces).unwrap();
        let mut positions = |size: i32| -> Vec<Point> {
            (0..count)
                .map(|_| [0; 3].map(|_| f64::from(random.i32(-size..=size))))
                .collect()
        };
        let (x0, moves) = (positions(20), positions(4));
        let x1: Vec<Point> = x0
            .iter()
            .zip(&moves)
            .map(|(p, v)| [0, 1, 2].map(|k: usize| p[k] + v[k]))
            .collect();
        let trajectories: Vec<_> = x0
            .iter()
            .zip(&x1)
            .map(|(&p, &q)| Polynomial::new([p, q]))
            .collect();
        let curved = curved_step(&mesh, &trajectories, within(0.0), &CurvedStepOptions::default()).unwrap();
        let exact = step(&mesh, &x0, &x1).unwrap();
        match exact.time_of_impact() {
            None => {
                free += 1;
                assert_eq!((curved.answer.end, curved.answer.free_until), (End::Free, 1.0));
            }
            Some(time) => assert_eq!(curved.answer.free_until, time),
        }
    }
    assert!((30..270).contains(&free), "{free}");
}

/// A rod of two edges that folds through itself. Its edges are shorter than the larger distance.
#[test]
fn a_rod_that_folds_touches_at_distance_zero_only() {
    let mesh = TriangleMesh::with_edges(3, Vec::new(), &[[0, 1], [0, 2]]).unwrap();
    let rest = |x: f64| Polynomial::new([[x, 0.0, 0.0]; 2]);
    let falling = |end: f64| Polynomial::new([[2.0, 0.0, 1.0], [2.0, 0.0, end]]);
    for d in [0.0, 100.0] {
        let until = |end: f64| {
            let trajectories = [rest(0.0), rest(4.0), falling(end)];
            let step = curved_step(&mesh, &trajectories, within(d), &CurvedStepOptions::default()).unwrap();
            step.answer.free_until
        };
        assert_eq!((until(0.25), until(-1.0)), (1.0, 0.5), "{d}");
    }
}
