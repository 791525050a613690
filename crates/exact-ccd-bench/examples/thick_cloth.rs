//! The first time at which two thick sheets touch:
//! `cargo run --release -p exact-ccd-bench --example thick_cloth`.
//!
//! Two flat sheets without thickness are 2e-3 apart, move towards each other and bulge. Each stands for
//! cloth that is 1e-3 thick, half of it on either side: the cloth touches when the sheets are 1e-3 apart.
//! The last row has cloth with 1e-3 on either side, which touches at the start: its distance is exactly 2e-3.
//!
//! With the name of a folder, it writes the two frames there, as a scene that other programs can answer:
//!
//! ```sh
//! cargo run --release -p exact-ccd-bench --example thick_cloth -- target/thick-cloth
//! bench/peers/step target/thick-cloth --min-distance 1e-3 --only-step
//! ```

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::Path;

use exact_ccd::{Options, Point, Separation, Thickness};
use exact_ccd_files::write_ply;
use exact_ccd_mesh::{Detector, Frame, MinDistance, TriangleMesh};

/// The number of vertices along a side of a sheet, of length 1.
const SIDE: u32 = 40;

/// The distance of the sheets at the start.
const GAP: f64 = 2e-3;

/// The distance that the centre of each of them moves.
const FALL: f64 = 1.5e-3;

/// The sheets at time 0 or 1.
fn positions(time: f64) -> Vec<Point> {
    let sheet = |sign: f64| {
        // The sheets are turned against each other, so that no edges are parallel.
        let turn = 0.3 * sign;
        (0..SIDE * SIDE).map(move |vertex| {
            let [x, y] =
                [vertex % SIDE, vertex / SIDE].map(|index| f64::from(index) / f64::from(SIDE - 1) - 0.5);
            let (x, y) = (x - turn * y, y + turn * x);
            let fall = FALL * (1.0 - 2.0 * (x * x + y * y));
            [x, y, sign * (0.5 * GAP - fall * time)]
        })
    };
    sheet(-1.0).chain(sheet(1.0)).collect()
}

/// The two triangles of each cell of each sheet.
fn faces() -> Vec<[u32; 3]> {
    let cell =
        |corner: u32| [[0, 1, SIDE + 1], [0, SIDE + 1, SIDE]].map(|face| face.map(|vertex| corner + vertex));
    let corners = (0..2).flat_map(|sheet| {
        (0..SIDE - 1)
            .flat_map(move |row| (0..SIDE - 1).map(move |column| (sheet * SIDE + row) * SIDE + column))
    });
    corners.flat_map(cell).collect()
}

fn write(folder: &Path, frames: [&Frame; 2]) -> Result<(), Box<dyn Error>> {
    let folder = folder.join("sheets/frames");
    fs::create_dir_all(&folder)?;
    for (number, frame) in frames.into_iter().enumerate() {
        let file = File::create(folder.join(format!("{number}.ply")))?;
        write_ply(&mut BufWriter::new(file), frame)?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mesh = TriangleMesh::new(2 * (SIDE * SIDE) as usize, faces())?;
    let (x0, x1) = (positions(0.0), positions(1.0));
    if let Some(folder) = std::env::args_os().nth(1) {
        let frame = |positions: &[Point]| Frame::new(positions.to_vec(), mesh.faces().to_vec());
        write(Path::new(&folder), [&frame(&x0)?, &frame(&x1)?])?;
    }

    println!("| distance kept | first time | pair | distance then |\n|---|---|---|---|");
    let thickness = |each: f64| Thickness::new(&vec![each; x0.len()]).map(MinDistance::thickness);
    for (name, d) in [
        ("0", MinDistance::default()),
        ("1e-3", MinDistance::uniform(Separation::new(1e-3)?)),
        ("0.5e-3 + 0.5e-3", thickness(0.5e-3)?),
        ("1e-3 + 1e-3", thickness(1e-3)?),
    ] {
        let mut detector = Detector::new(mesh.clone());
        let contact = detector
            .collision(&x0, &x1, Options::within(d))?
            .ok_or("the sheets pass through each other")?;
        let (time, distance) = (contact.impact.time.lower(), contact.distance);
        println!(
            "| {name} | {time} | {:?} | {:e} to {:e} |",
            contact.pair, distance.lower, distance.upper
        );
    }
    Ok(())
}
