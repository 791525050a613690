//! Generators of motions.

use std::ops::RangeInclusive;

use exact_ccd_mesh::{Motion, Point, TriangleMesh, advance};
use proptest::prelude::*;

use super::motion;

/// Motions of a few faces, with or without area, rods and points between whole numbers, so that many
/// contacts coincide in time.
pub(crate) fn small_motion() -> impl Strategy<Value = Motion> {
    let coordinate = || (-2..=2).prop_map(f64::from);
    let positions = move |count| prop::collection::vec(prop::array::uniform3(coordinate()), count);
    let faces = |count: usize| prop::collection::vec(prop::array::uniform3(0..count as u32), 2..9);
    let rods = |count: usize| prop::collection::vec(prop::array::uniform2(0..count as u32), 0..4);
    (3_usize..20)
        .prop_flat_map(move |count| (positions(count), positions(count), faces(count), rods(count)))
        .prop_map(|(x0, x1, faces, rods)| {
            let mesh = TriangleMesh::with_edges(x0.len(), faces, &rods).unwrap();
            Motion { mesh, x0, x1 }
        })
}

/// Triangles that pass through each other, far from the origin, at speeds between powers of 2.
pub(crate) fn soup(speeds: RangeInclusive<i32>) -> impl Strategy<Value = Motion> {
    let triangle = move || {
        let vector = || prop::array::uniform3(-1.0..1.0);
        (vector(), vector(), vector(), vector(), speeds.clone()).prop_map(|(at, u, v, velocity, exponent)| {
            let (size, speed) = (0.2, 2.0_f64.powi(exponent));
            let corner = |offset: Point| -> [Point; 2] {
                let start = [0, 1, 2].map(|k: usize| 1000.0 + at[k] + size * offset[k]);
                [start, [0, 1, 2].map(|k: usize| start[k] + speed * velocity[k])]
            };
            [corner([0.0; 3]), corner(u), corner(v)]
        })
    };
    prop::collection::vec(triangle(), 2..60).prop_map(|triangles| {
        let corners: Vec<[Point; 2]> = triangles.concat();
        let faces = (0..triangles.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]);
        let at = |time: usize| corners.iter().map(|ends| ends[time]).collect();
        motion(at(0), at(1), faces.collect())
    })
}

/// Unrelated steps of one mesh, some of them slow, some of them far from the origin.
pub(crate) fn steps() -> impl Strategy<Value = (TriangleMesh, Vec<[Vec<Point>; 2]>)> {
    let coordinate = || prop_oneof![(-2..=2).prop_map(f64::from), -2.0..2.0];
    let points = move |count| prop::collection::vec(prop::array::uniform3(coordinate()), count);
    let step = move |count| (points(count), points(count), -30..=0, -3..=9);
    (3_u32..40)
        .prop_flat_map(move |count| {
            let faces = prop::collection::vec(prop::array::uniform3(0..count), 2..40);
            let steps = prop::collection::vec(step(count as usize), 1..6);
            (Just(count as usize), faces, steps)
        })
        .prop_map(|(count, faces, steps)| {
            let steps = steps.into_iter().map(|(x0, directions, speed, scale)| {
                let [speed, scale] = [speed, scale].map(|exponent| 2.0_f64.powi(exponent));
                let x0: Vec<Point> = x0.iter().map(|x| x.map(|x| scale * x)).collect();
                let x1 = advance(&x0, &directions, scale * speed);
                [x0, x1]
            });
            (TriangleMesh::new(count, faces).unwrap(), steps.collect())
        })
}

/// A square sheet of 2 n² faces with sides of length n, at a height.
pub(crate) fn sheet(n: u32, height: f64) -> (Vec<Point>, Vec<[u32; 3]>) {
    let row = n + 1;
    let positions = (0..row * row).map(|v| [f64::from(v % row), f64::from(v / row), height]);
    let squares = (0..n * n).map(|square| square / n * row + square % n);
    let faces = squares.flat_map(|v| [[v, v + 1, v + row], [v + 1, v + row + 1, v + row]]);
    (positions.collect(), faces.collect())
}

/// A sheet that falls through a parallel one, so that all pairs touch at the same time.
pub(crate) fn falling_sheet() -> Motion {
    let (lower, mut faces) = sheet(24, 0.0);
    let count = lower.len() as u32;
    faces.extend(faces.clone().iter().map(|face| face.map(|corner| corner + count)));
    let upper = |height| [lower.clone(), sheet(24, height).0].concat();
    motion(upper(0.5), upper(-1.0), faces)
}
