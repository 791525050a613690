//! The cost of the border: the same queries through the functions of C and through Rust, in turns. Each
//! round takes about a millisecond, and the least time counts: other programs disturb it least.
//!
//! `cargo bench --package exact-ccd-c`

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::hint::black_box;
use std::time::Instant;

use exact_ccd::batch::Trajectories;
use exact_ccd::{Point, Query, Separation, Separations, VertexFace};
use exact_ccd_c::{Kind, Status, exact_ccd_batch_time_of_impact, exact_ccd_time_of_impact};
use rayon::prelude::*;

const ROUNDS: usize = 1001;

fn main() {
    single();
    batch();
}

/// One colliding query, called many times.
fn single() {
    const CALLS: usize = 1_000;
    let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [0.0, 1.0, 0.2]];
    let at = |z: f64| [[0.25, 0.3, z], face[0], face[1], face[2]];
    let (t0, t1) = (at(1.0), at(-1.3));
    let by_rust = || {
        for _ in 0..CALLS {
            let (t0, t1) = (black_box(t0), black_box(t1));
            let d = Separation::new(black_box(0.0)).expect("0 is a separation");
            black_box(
                Query::<VertexFace>::new(t0, t1)
                    .expect("finite")
                    .time_of_impact(d),
            );
        }
    };
    let by_c = || {
        let mut time = 0.0;
        for _ in 0..CALLS {
            let (t0, t1) = (black_box(&t0), black_box(&t1));
            let (t0, t1) = (t0.as_ptr().cast(), t1.as_ptr().cast());
            // SAFETY: both arrays have four points.
            let status = unsafe {
                exact_ccd_time_of_impact(
                    Kind::VertexFace as u32,
                    t0,
                    t1,
                    black_box(0.0),
                    1.0,
                    &raw mut time,
                )
            };
            assert_eq!(status, Status::Ok);
            black_box(time);
        }
    };
    let [rust, c] = in_turns([&by_rust, &by_c]).map(|seconds| 1e9 * seconds / CALLS as f64);
    println!(
        "one colliding query: Rust {rust:.1} ns, C {c:.1} ns, difference {:.1} ns",
        c - rust
    );
}

/// Many queries by indices, on all threads.
fn batch() {
    const COUNT: usize = 50_000;
    let mut random = Random(1);
    let x0: Vec<Point> = (0..30_000).map(|_| [0; 3].map(|_| random.unit())).collect();
    let x1: Vec<Point> = x0.iter().map(|x| x.map(|x| x + 0.1 * random.unit())).collect();
    let queries: Vec<[u32; 4]> = (0..COUNT)
        .map(|_| [0; 4].map(|_| (random.unit() * 30_000.0) as u32))
        .collect();
    let by_rust = || {
        let trajectories = Trajectories::new(&x0, &x1).expect("finite");
        let mut times = vec![f64::NAN; COUNT];
        let chunks = queries.par_chunks(4096).zip(times.par_chunks_mut(4096));
        chunks.for_each(|(queries, times)| {
            let separations = Separations::Uniform(Separation::default());
            trajectories
                .collisions::<VertexFace>(queries, separations, |index, collision| {
                    times[index] = collision.time_of_impact();
                })
                .expect("the vertices exist");
        });
        black_box(times);
    };
    let by_c = || {
        let mut times = vec![0.0; COUNT];
        // SAFETY: the arrays have the lengths that are passed on.
        let status = unsafe {
            exact_ccd_batch_time_of_impact(
                Kind::VertexFace as u32,
                x0.as_ptr().cast(),
                x1.as_ptr().cast(),
                x0.len(),
                queries.as_ptr().cast(),
                COUNT,
                0.0,
                1.0,
                0,
                times.as_mut_ptr(),
            )
        };
        assert_eq!(status, Status::Ok);
        black_box(times);
    };
    let [rust, c] = in_turns([&by_rust, &by_c]).map(|seconds| 1e3 * seconds);
    println!(
        "{COUNT} queries: Rust {rust:.3} ms, C {c:.3} ms, ratio {:.3}",
        c / rust
    );
}

/// The least seconds that each computation takes, in turns.
fn in_turns(computations: [&dyn Fn(); 2]) -> [f64; 2] {
    let mut least = [f64::INFINITY; 2];
    for _ in 0..ROUNDS {
        for (least, computation) in least.iter_mut().zip(computations) {
            let clock = Instant::now();
            computation();
            *least = least.min(clock.elapsed().as_secs_f64());
        }
    }
    least
}

/// Marsaglia's xorshift generator.
struct Random(u64);

impl Random {
    /// A number in [0, 1).
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}
