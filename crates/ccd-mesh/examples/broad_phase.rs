//! Puts another broad phase under a step, and shows progress.
//!
//! ```sh
//! cargo run --release --example broad_phase -p ccd-mesh -- examples/drape_start.ply examples/drape_contact.ply
//! ```

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::error::Error;
use std::sync::atomic::{AtomicUsize, Ordering};

use ccd_mesh::{Bounds, BroadPhase, Candidates, Motion, StepReport};

/// Sorts the boxes along x, and compares each with those that begin before it ends.
struct SortAndSweep;

impl BroadPhase for SortAndSweep {
    fn between(&self, a: &[Bounds], b: &[Bounds], keep: impl Fn(u32, u32) -> bool + Sync) -> Vec<[u32; 2]> {
        let mut sorted: Vec<(u32, &Bounds)> = (0..).zip(b).collect();
        sorted.sort_unstable_by(|(_, p), (_, q)| p.lower[0].total_cmp(&q.lower[0]));
        let mut pairs = Vec::new();
        for (i, query) in (0..).zip(a) {
            let begin_before_its_end = sorted
                .iter()
                .take_while(|(_, other)| other.lower[0] <= query.upper[0]);
            for &(j, other) in begin_before_its_end {
                if query.overlaps(other) && keep(i, j) {
                    pairs.push([i, j]);
                }
            }
        }
        pairs.sort_unstable();
        pairs
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut files = std::env::args_os().skip(1);
    let (start, end) = files.next().zip(files.next()).ok_or("expected START END")?;

    let motion = Motion::read(start, end)?;
    let candidates = Candidates::new(motion.step()?, &SortAndSweep);
    let total = candidates.counts().total();
    let done = AtomicUsize::new(0);
    let report = StepReport::new(&candidates, &|count| {
        let done = done.fetch_add(count, Ordering::Relaxed) + count;
        println!("{done} of {total} candidates");
    });
    println!("{report:#?}");
    Ok(())
}
