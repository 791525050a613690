//! Runs a step with a custom broad phase and prints its progress.
//!
//! ```sh
//! cargo run --release --example broad_phase -p exact-ccd-files -- \
//!     examples/drape_start.ply examples/drape_contact.ply
//! ```

#![expect(clippy::print_stdout, reason = "an example prints its result")]

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};

use exact_ccd_files::read_motion;
use exact_ccd_mesh::{Aabb, BoxPairs, Boxes, PairSink, StepReport};

/// Sorts the boxes along x and visits each with the boxes that begin before it ends. This finds a
/// superset of the overlapping pairs.
struct SortedAlongX;

impl<const T: usize> BoxPairs<T> for SortedAlongX {
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        let [of_a, of_b] = [a, b].map(intervals);
        for [lower, upper, i] in of_a {
            let overlapping = of_b
                .iter()
                .take_while(|other| other[0] <= upper)
                .filter(|other| lower <= other[1]);
            let pairs: Vec<[u32; 2]> = overlapping.map(|other| [i as u32, other[2] as u32]).collect();
            sink(&pairs)?;
        }
        ControlFlow::Continue(())
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        self.between(boxes, boxes, &|pairs| {
            let once: Vec<[u32; 2]> = pairs.iter().copied().filter(|[i, j]| i < j).collect();
            sink(&once)
        })
    }
}

/// The extent of each box along x during the step, and its index, sorted.
fn intervals<const T: usize>(boxes: &Boxes<T>) -> Vec<[f64; 3]> {
    let interval = |(id, places): (u32, [Aabb; T])| {
        let swept = places.iter().fold(Aabb::EMPTY, |all, place| all.union(place));
        [swept.lower[0], swept.upper[0], f64::from(id)]
    };
    let mut intervals: Vec<_> = boxes.iter().map(interval).collect();
    intervals.sort_by(|a, b| a[0].total_cmp(&b[0]));
    intervals
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut files = std::env::args_os().skip(1);
    let (start, end) = files.next().zip(files.next()).ok_or("expected START END")?;

    let motion = read_motion(start, end)?;
    let done = AtomicUsize::new(0);
    let report = StepReport::new(motion.step()?, &SortedAlongX, &|count| {
        let done = done.fetch_add(count, Ordering::Relaxed) + count;
        if count > 0 {
            println!("{done} candidates");
        }
    });
    println!("{report:#?}");
    Ok(())
}
