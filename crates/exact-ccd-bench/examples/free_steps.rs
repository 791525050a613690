//! The step for every vertex beside the common step, on the published scenes, on one thread.
//!
//! `cargo run --release -p exact-ccd-bench --example free_steps`
//!
//! Both take turns; the last column is the median of the ratio of their times.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use exact_ccd_bench::median;
use exact_ccd_data::DataFolder;
use exact_ccd_mesh::{Detector, FreeStepOptions, LineSearchError, Motion};
use rayon::ThreadPoolBuilder;

const REPOSITORY: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
const TURNS: usize = 9;

fn main() -> Result<(), Box<dyn Error>> {
    println!("| scene | size of the common step | mean size | vertices at 1 | rounds | cost |");
    println!("|---|---:|---:|---:|---:|---:|");
    let pool = ThreadPoolBuilder::new().num_threads(1).build()?;
    for scene in DataFolder::find(Path::new(REPOSITORY))?.scenes()? {
        let motion = scene.motion()?;
        pool.install(|| print_row(&scene.name(), &motion))?;
    }
    Ok(())
}

fn print_row(name: &str, Motion { mesh, x0, x1, .. }: &Motion) -> Result<(), LineSearchError> {
    let mut detector = Detector::new(mesh.clone());
    let options = FreeStepOptions::default();
    let mut ratios = Vec::new();
    let mut turn = || {
        let start = Instant::now();
        let common = detector.free_step(x0, x1, &options)?;
        let between = Instant::now();
        let steps = detector.free_steps(x0, x1, &[], &options)?;
        ratios.push(between.elapsed().as_secs_f64() / (between - start).as_secs_f64());
        Ok::<_, LineSearchError>((common, steps))
    };
    let (common, steps) = turn()?;
    for _ in 1..TURNS {
        turn()?;
    }
    let count = steps.sizes.len() as f64;
    let mean = steps.sizes.iter().sum::<f64>() / count;
    let all_the_way = steps.sizes.iter().filter(|&&size| size == 1.0).count() as f64 / count;
    println!(
        "| {name} | {:.2e} | {mean:.3} | {:.1} % | {} | {:.2} |",
        common.size,
        100.0 * all_the_way,
        steps.rounds,
        median(&ratios)
    );
    Ok(())
}
