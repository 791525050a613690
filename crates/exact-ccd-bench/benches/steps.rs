//! The time of a whole step of each published scene, with each broad phase, on one and two threads.
//!
//! `cargo bench -p exact-ccd-bench --bench steps [-- SCENE...]`
//!
//! All contestants take turns for some rounds; a figure is the median over the rounds, in
//! milliseconds. The free step goes from the start to 0.9 times the earliest contact. For
//! comparison, the speed of copying memory is printed at the end.

#![expect(clippy::print_stdout, reason = "this is its output")]

mod published;

use std::hint::black_box;
use std::sync::Arc;

use exact_ccd::CONTACT;
use exact_ccd_bench::{median, seconds};
use exact_ccd_data::DataError;
use exact_ccd_mesh::{BroadPhase, Bvh, Detector, Motion, Point, Step, StepReport, Sweep, advance};
use rayon::{ThreadPool, ThreadPoolBuilder};

const ROUNDS: usize = 9;
const FREE_FRACTION: f64 = 0.9;

fn main() -> Result<(), DataError> {
    println!("| scene | question | Bvh, 1 thread | Bvh, 2 threads | Sweep, 1 thread | Sweep, 2 threads |");
    println!("|---|---|---:|---:|---:|---:|");
    for (scene, motion) in published::motions()? {
        print_rows(&scene, &motion);
    }
    println!("\nCopying memory: {:.1} GB/s read and written", bandwidth() / 1e9);
    Ok(())
}

fn print_rows(name: &str, motion: &Motion) {
    let step = motion.step().expect("the frames of a scene are sound");
    let end = free_end(motion, Detector::new(motion.mesh.clone()));
    let free = Step::new(&motion.mesh, &motion.x0, &end).expect("it is between two sound frames");
    print_row(name, "all contacts", &Question::Report, step);
    print_row(name, "earliest contact", &Question::Earliest, step);
    print_row(name, "yes or no", &Question::Free, step);
    print_row(name, "yes or no, free", &Question::Free, free);
}

/// Positions of the mesh before the earliest contact of the step.
fn free_end(motion: &Motion, mut detector: Detector) -> Vec<Point> {
    let time = detector
        .collision(&motion.x0, &motion.x1, CONTACT)
        .expect("the frames of a scene are sound")
        .map_or(1.0, |contact| contact.impact.time.lower());
    let ends = motion.x0.iter().zip(&motion.x1);
    let direction: Vec<Point> = ends.map(|(a, b)| [0, 1, 2].map(|k: usize| b[k] - a[k])).collect();
    advance(&motion.x0, &direction, FREE_FRACTION * time)
}

enum Question {
    Report,
    Earliest,
    Free,
}

impl Question {
    /// Answers with a detector that has no memory of earlier steps.
    fn answer(&self, step: Step<'_>, broad_phase: &dyn BroadPhase, mut detector: Detector) {
        let [x0, x1] = step.positions();
        match self {
            Self::Report => {
                black_box(StepReport::new(step, broad_phase, &|_| ()));
            }
            Self::Earliest => {
                let _ = black_box(detector.collision(x0, x1, CONTACT));
            }
            Self::Free => {
                let _ = black_box(detector.collides(x0, x1, CONTACT));
            }
        }
    }
}

fn print_row(scene: &str, name: &str, question: &Question, step: Step<'_>) {
    let pools = [1, 2].map(|threads| {
        ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("two threads can be had")
    });
    let bvh = Detector::new(step.mesh().clone());
    let sweep = Detector::with_broad_phase(bvh.mesh().clone(), Arc::new(Sweep));
    let mut times = [const { Vec::new() }; 4];
    for _ in 0..ROUNDS {
        for (pool, index) in pools.iter().zip(0..) {
            times[index].push(milliseconds(pool, || question.answer(step, &Bvh, bvh.clone())));
            times[2 + index].push(milliseconds(pool, || {
                question.answer(step, &Sweep, sweep.clone());
            }));
        }
    }
    let medians = times.map(|times| format!("{:.1}", median(&times)));
    println!("| {scene} | {name} | {} |", medians.join(" | "));
}

fn milliseconds(pool: &ThreadPool, task: impl Fn() + Sync) -> f64 {
    1e3 * seconds(|| pool.install(&task))
}

/// The bytes read and written in a second by a copy that is larger than any cache.
fn bandwidth() -> f64 {
    let from = vec![1u64; 1 << 25];
    let mut to = vec![0u64; 1 << 25];
    let copies = [(); ROUNDS].map(|()| {
        seconds(|| {
            to.copy_from_slice(black_box(&from));
            black_box(&to);
        })
    });
    2.0 * size_of_val(&from[..]) as f64 / median(&copies)
}
