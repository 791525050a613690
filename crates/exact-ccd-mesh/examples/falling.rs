//! A cube is thrown over a wall and falls to the ground, each vertex on its parabola, in steps of a quarter
//! of a second.
//!
//! `cargo run -p exact-ccd-mesh --example falling`
//!
//! The motion is free fall in each step, not a chord of it, and the time of contact is exact.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;

use exact_ccd::CONTACT;
use exact_ccd_mesh::{CurveDetector, Frame, Point};

/// Seconds, metres per second, metres per square second.
const STEP: f64 = 0.25;
const SPEED: Point = [2.0, 0.0, 6.0];
const GRAVITY: Point = [0.0, 0.0, -9.75];

/// A cube of side 1, and the ground and a wall at rest.
fn scene() -> Result<Frame, Box<dyn Error>> {
    let cube = (0..8).map(|i| [0, 1, 2].map(|axis| f64::from(i >> axis & 1)));
    let ground = [[-9.0, -9.0, -1.0], [30.0, -9.0, -1.0], [0.0, 30.0, -1.0]];
    let wall = [[2.0, -5.0, -1.0], [2.0, 5.0, -1.0], [2.0, 0.5, 1.5]];
    let faces = vec![
        [0, 1, 3],
        [0, 3, 2],
        [4, 6, 7],
        [4, 7, 5],
        [0, 4, 5],
        [0, 5, 1],
        [2, 3, 7],
        [2, 7, 6],
        [0, 2, 6],
        [0, 6, 4],
        [1, 5, 7],
        [1, 7, 3],
        [8, 9, 10],
        [11, 12, 13],
    ];
    let positions = cube.chain(ground).chain(wall);
    Ok(Frame::new(positions.collect(), faces)?)
}

/// The control points of the vertices in a step: x, x + v h / 2, and x + v h + g h² / 2.
fn control(positions: &[Point], speed: Point) -> [Vec<Point>; 3] {
    let moved = |by: Point| {
        let place = |(vertex, x): (usize, &Point)| {
            let by = if vertex < 8 { by } else { [0.0; 3] };
            [0, 1, 2].map(|axis: usize| x[axis] + by[axis])
        };
        positions.iter().enumerate().map(place).collect::<Vec<_>>()
    };
    let end = [0, 1, 2].map(|axis: usize| STEP * (speed[axis] + 0.5 * STEP * GRAVITY[axis]));
    [moved([0.0; 3]), moved(speed.map(|v| 0.5 * STEP * v)), moved(end)]
}

fn main() -> Result<(), Box<dyn Error>> {
    let Frame { mesh, positions } = scene()?;
    let detector = CurveDetector::new(mesh);
    let (mut positions, mut speed) = (positions, SPEED);
    for step in 0..20 {
        let control = control(&positions, speed);
        let sets = [&control[0][..], &control[1][..], &control[2][..]];
        if let Some(contact) = detector.collision(&sets, CONTACT)? {
            let time = STEP * (f64::from(step) + contact.impact.time.lower());
            println!("contact at {time:.6} s: {:?}", contact.pair);
            return Ok(());
        }
        positions.clone_from(&control[2]);
        speed = [0, 1, 2].map(|axis: usize| speed[axis] + STEP * GRAVITY[axis]);
        println!(
            "free until {:.2} s, height {:.3} m",
            STEP * f64::from(step + 1),
            positions[0][2] + 1.0
        );
    }
    Ok(())
}
