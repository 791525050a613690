//! Repairs two rings that overlap, and prints the change.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;
use std::f64::consts::TAU;
use std::sync::Arc;

use exact_ccd_mesh::{Point, TriangleMesh};
use exact_ccd_repair::{Outcome, RepairOptions, repair};

/// The cells of a ring along and across.
const CELLS: [u32; 2] = [48, 16];

fn main() -> Result<(), Box<dyn Error>> {
    let (mut positions, mut faces) = (Vec::new(), Vec::new());
    for centre in [[0.0, 0.0, 0.0], [0.1, 0.2, 0.45]] {
        let first = positions.len() as u32;
        let index = |i: u32, j: u32| first + i % CELLS[0] * CELLS[1] + j % CELLS[1];
        for (i, j) in (0..CELLS[0]).flat_map(|i| (0..CELLS[1]).map(move |j| (i, j))) {
            positions.push(place(centre, i, j));
            let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    let mesh = Arc::new(TriangleMesh::new(positions.len(), faces)?);
    match repair(&mesh, &positions, &RepairOptions::default())? {
        Outcome::Repaired(repaired) => {
            println!(
                "{} pairs of an edge and a face crossed, and none do now",
                repaired.crossings
            );
            println!("{:#?}", repaired.change);
            Ok(())
        }
        Outcome::Unrepaired(unrepaired) => Err(format!("not repaired: {:?}", unrepaired.reason).into()),
    }
}

fn place(centre: Point, i: u32, j: u32) -> Point {
    let [(sine, cosine), (up, out)] =
        [(i, CELLS[0]), (j, CELLS[1])].map(|(i, n)| (TAU * f64::from(i) / f64::from(n)).sin_cos());
    let radius = 1.0 + 0.3 * out;
    [
        centre[0] + radius * cosine,
        centre[1] + radius * sine,
        centre[2] + 0.3 * up,
    ]
}
