//! The time and the memory of a whole step as its mesh grows: from 10⁴ triangles to 10⁷.
//!
//! ```sh
//! cargo run --release -p exact-ccd-bench --example scaling -- [OUT.svg]
//! cargo run --release -p exact-ccd-bench --example scaling -- --triangles 10000000
//! ```
//!
//! The first command prints a table for each question and draws them, into
//! docs/performance/scaling.svg by default. The second counts the contacts of about that number of
//! triangles, once, and prints the peak of the memory.
//!
//! The meshes are sheets of cloth that fall onto each other. Only their size differs, so that the
//! candidates are in proportion to the vertices. Each question is answered for each mesh in a
//! process of its own.

#![expect(clippy::print_stdout, reason = "this is its output")]

mod curve;
mod measurement;
mod memory;
mod plot;
mod question;
mod table;

use std::error::Error;
use std::{env, fs};

use exact_ccd_mesh::{Bvh, StepReport};

use crate::curve::{Curve, PER_DECADE};
use crate::measurement::{MEASURE, Measurement};
use crate::memory::{Memory, mebibytes, peak};
use crate::question::Question;
use crate::table::or_unknown;
use exact_ccd_bench::cloth::Cloth;
use exact_ccd_testing::meshes::cloth::SHEETS;

const DECADES: [i32; 2] = [4, 7];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        [MEASURE, word, side] => {
            let question = Question::of_word(word).ok_or_else(|| format!("no question: {word}"))?;
            let measurement = Measurement::here(question, side.parse()?);
            println!("{}", serde_json::to_string(&measurement)?);
        }
        ["--triangles", triangles] => report_once(triangles.parse()?),
        [] => scale("docs/performance/scaling.svg")?,
        [drawing] if !drawing.starts_with('-') => scale(drawing)?,
        _ => return Err("expected [OUT.svg] or --triangles COUNT".into()),
    }
    Ok(())
}

fn scale(drawing: &str) -> Result<(), Box<dyn Error>> {
    println!("# Scaling, on {} threads\n", rayon::current_num_threads());
    let mut curves = Vec::new();
    for question in Question::ALL {
        let points = sizes().map(|triangles| Measurement::apart(question, side(triangles)));
        let curve = Curve {
            question,
            points: points.collect::<Result<_, _>>()?,
        };
        println!("{}", table::markdown(&curve));
        curves.push(curve);
    }
    fs::write(drawing, plot::svg(&curves))?;
    Ok(())
}

/// The approximate numbers of triangles.
fn sizes() -> impl Iterator<Item = f64> {
    let [first, last] = DECADES;
    let steps = (last - first) * PER_DECADE as i32;
    (0..=steps).map(move |step| 10f64.powf(f64::from(first) + f64::from(step) / PER_DECADE as f64))
}

/// The side of a sheet of the cloth that has about this many triangles.
fn side(triangles: f64) -> usize {
    (triangles / (2 * SHEETS) as f64).sqrt().round() as usize + 1
}

fn report_once(triangles: f64) {
    let cloth = Cloth::new(side(triangles), Question::Report.nearest());
    let memory = Memory::now();
    let report = StepReport::new(cloth.step(), &Bvh, &|_| ());
    let mebibytes = |bytes: Option<u64>| or_unknown(bytes.map(mebibytes), 0);
    println!("candidates: {}", report.candidates.total());
    println!("colliding: {}", report.colliding.total());
    println!("peak memory of the step, in MiB: {}", mebibytes(memory.rise()));
    println!("with the mesh and all else, in MiB: {}", mebibytes(peak()));
}
