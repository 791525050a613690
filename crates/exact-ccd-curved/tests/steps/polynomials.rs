//! Vertices on cubic curves, against the distance of the mesh at many times.

use exact_ccd::{Options, Point};
use exact_ccd_curved::{CurvedStepOptions, End, Polynomial, SearchOptions, curved_step};
use exact_ccd_mesh::{Detector, TriangleMesh};

use crate::within;

/// Coordinates are below 64, and the errors of de Casteljau's algorithm far below this.
const ROUNDING: f64 = 1e-11;

/// Of times and of distances.
const TOLERANCE: f64 = 1e-7;

/// Above the relative speed of two vertices: 3 times the largest difference of control points, on both sides.
const SPEED: f64 = 3.0 * 2.0 * 32.0;

const SAMPLES: u32 = 200;

/// The point of a curve by de Casteljau's algorithm.
fn place(curve: &[Point; 4], time: f64) -> Point {
    let mut points = curve.to_vec();
    while points.len() > 1 {
        let between =
            |ends: &[Point]| [0, 1, 2].map(|k: usize| ends[0][k] + time * (ends[1][k] - ends[0][k]));
        points = points.windows(2).map(between).collect();
    }
    points[0]
}

#[test]
fn the_free_part_is_farther_than_d_and_the_end_is_near() {
    let mut random = fastrand::Rng::with_seed(21);
    let (mut free, mut near) = (0, 0);
    for case in 0..60 {
        let count = 12;
        let faces = (0..4).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let mesh = TriangleMesh::new(count, faces).unwrap();
        let mut point = |size: f64| [0; 3].map(|_| size * (2.0 * random.f64() - 1.0));
        let curves: Vec<[Point; 4]> = (0..count)
            .map(|vertex| {
                // Four triangles, far enough apart at first.
                let center = [12.0 * f64::from(vertex as u32 / 3), 0.0, 0.0];
                let offset = point(5.0);
                let start = [0, 1, 2].map(|k: usize| center[k] + offset[k]);
                let moves = [[0.0; 3], point(8.0), point(8.0), point(8.0)];
                moves.map(|v| [0, 1, 2].map(|k: usize| start[k] + v[k]))
            })
            .collect();
        let trajectories: Vec<_> = curves.iter().map(|&points| Polynomial::new(points)).collect();
        let d = [0.25, 1.0][case % 2];
        let search = SearchOptions::default()
            .with_time_tolerance(TOLERANCE)
            .with_distance_tolerance(within(TOLERANCE));
        let options = CurvedStepOptions::default().with_search(search);
        let step = curved_step(&mesh, &trajectories, within(d), &options).unwrap();

        let is_beyond = |time: f64, d: f64| {
            let at: Vec<Point> = curves.iter().map(|curve| place(curve, time)).collect();
            let mut detector = Detector::new(mesh.clone());
            !detector.collides(&at, &at, Options::within(within(d))).unwrap()
        };
        for sample in 0..SAMPLES {
            let time = step.answer.free_until * f64::from(sample) / f64::from(SAMPLES);
            assert!(is_beyond(time, d - ROUNDING), "{case}: {time} {step:?}");
        }
        match step.answer.end {
            End::Free => free += 1,
            End::Tolerance => {
                near += 1;
                let by = step.answer.within.unwrap().by;
                assert!(by - step.answer.free_until <= TOLERANCE, "{case}: {step:?}");
                let reach = d + TOLERANCE + SPEED * TOLERANCE + ROUNDING;
                assert!(!is_beyond(by, reach), "{case}: {step:?}");
            }
            end => panic!("{case}: {end:?}"),
        }
    }
    assert!(free > 5 && near > 5, "{free} free, {near} near");
}
