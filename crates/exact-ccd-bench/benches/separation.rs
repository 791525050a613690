//! The cost of a query within a distance d, on candidates of the broad phase, with boxes inflated
//! by d: a thousandth and a tenth of the mean length of an edge.
//!
//! `cargo bench -p exact-ccd-bench --bench separation [-- SCENE...]`, on one thread, over the
//! published data sets.
//!
//! The scenes, kinds and distances take turns for some rounds; a figure is the median over the
//! rounds. The time of one query within d is the least of some attempts.

#![expect(clippy::print_stdout, reason = "this is its output")]

mod published;

use std::hint::black_box;

use exact_ccd::batch::Trajectories;
use exact_ccd::{AnyKind, CONTACT, EdgeEdge, Query, Separation, Stage, VertexFace};
use exact_ccd_bench::{mean, median, nanoseconds, nanoseconds_each, quantile};
use exact_ccd_data::{DataError, DataKind};
use exact_ccd_mesh::{Bvh, CandidateOptions, Candidates, Motion, Step};

const ROUNDS: usize = 7;
/// d as fractions of the mean length of an edge.
const FRACTIONS: [f64; 2] = [1e-3, 1e-1];
/// The largest number of candidates of a row: every so many, if there are more.
const CANDIDATES: usize = 200_000;
/// The number of queries whose intervals and impact are timed.
const SAMPLE: usize = 20_000;

fn main() -> Result<(), DataError> {
    let mut rows: Vec<Row> = Vec::new();
    for (scene, motion) in published::motions()? {
        rows.extend(
            FRACTIONS
                .map(|fraction| rows_of(&scene, &motion, fraction))
                .into_iter()
                .flatten(),
        );
    }
    for round in 1..=ROUNDS {
        eprintln!("round {round} of {ROUNDS}");
        rows.iter_mut().for_each(|row| (row.time)(&mut row.measured));
    }
    print_decisions(&rows);
    print_times(&rows);
    print_stages(&rows);
    Ok(())
}

/// Candidates of one kind in one scene for one distance.
struct Row {
    name: String,
    /// Adds the measurements of one round.
    time: Box<dyn FnMut(&mut Measured)>,
    measured: Measured,
}

/// The measurements of a row. All times are in nanoseconds.
#[derive(Default)]
struct Measured {
    candidates: usize,
    /// The number of candidates settled at each stage.
    settled: [usize; Stage::ALL.len()],
    /// The means over the candidates that do not come within d, round by round.
    contact: Vec<f64>,
    outside: Vec<f64>,
    /// The same in batches.
    contact_batch: Vec<f64>,
    outside_batch: Vec<f64>,
    /// The first time within d, of each query that comes within d, and the same without the queries that
    /// take the exact path.
    first: Vec<f64>,
    first_filtered: Vec<f64>,
    intervals: Vec<f64>,
    impacts: Vec<f64>,
}

fn rows_of(scene: &str, motion: &Motion, fraction: f64) -> [Row; 2] {
    let step = motion.step().expect("the frames of a scene are sound");
    let d = fraction * mean_edge(&step);
    let options = CandidateOptions::default().with_distance(d);
    let candidates = Candidates::with_options(step, &Bvh, &options).expect("the distance is positive");
    let d = Separation::new(d).expect("a length is finite");
    let name = |kind: &str| format!("{scene} {kind}, {fraction:e}");
    [
        row::<VertexFace>(name("vf"), step, candidates.of_kind(AnyKind::VertexFace), d),
        row::<EdgeEdge>(name("ee"), step, candidates.of_kind(AnyKind::EdgeEdge), d),
    ]
}

/// The mean length of the edges at t = 0.
fn mean_edge(step: &Step<'_>) -> f64 {
    let [x0, _] = step.positions();
    let edges = step.mesh().edges();
    let length = |edge: &[u32; 2]| {
        let [a, b] = edge.map(|vertex| x0[vertex as usize]);
        (0..3).map(|axis| (b[axis] - a[axis]).powi(2)).sum::<f64>().sqrt()
    };
    edges.iter().map(length).sum::<f64>() / edges.len() as f64
}

fn row<K: DataKind>(name: String, step: Step<'_>, pairs: &[[u32; 2]], d: Separation) -> Row {
    let mut measured = Measured::default();
    let mut outside: Vec<Query<K>> = Vec::new();
    let mut vertices: Vec<[u32; 4]> = Vec::new();
    let mut within = 0;
    let stride = pairs.len().div_ceil(CANDIDATES).max(1);
    for &pair in pairs.iter().step_by(stride) {
        measured.candidates += 1;
        let query = step.query::<K>(pair).expect("a pair of the mesh");
        let (collision, stage) = query.decide(d);
        measured.settled[stage as usize] += 1;
        if collision.is_none() {
            outside.push(query);
            vertices.extend(K::vertices(step.mesh(), pair));
            continue;
        }
        let time = nanoseconds(|| query.time_of_impact(d));
        measured.first.push(time);
        if stage != Stage::Exact {
            measured.first_filtered.push(time);
        }
        within += 1;
        if within <= SAMPLE {
            measured.intervals.push(nanoseconds(|| query.intervals(d)));
            measured.impacts.push(nanoseconds(|| query.impact(d)));
        }
    }
    let [x0, x1] = step.positions();
    let trajectories = Trajectories::new(x0, x1).expect("the frames of a scene are sound");
    let count = outside.len();
    let mean = move |count_all: &dyn Fn() -> usize| nanoseconds_each(count, count_all);
    let one_by_one = move |decide: &dyn Fn(&Query<K>) -> bool| {
        mean(&|| black_box(&outside).iter().filter(|query| decide(query)).count())
    };
    let batch = move |d: Separation| {
        mean(&|| {
            let mut count = 0;
            trajectories
                .collisions::<K>(black_box(&vertices), d, |_, _| count += 1)
                .expect("all vertices are there");
            count
        })
    };
    let time = move |measured: &mut Measured| {
        measured
            .contact
            .push(one_by_one(&|query| query.collides(CONTACT)));
        measured.outside.push(one_by_one(&|query| query.collides(d)));
        measured.contact_batch.push(batch(Separation::ZERO));
        measured.outside_batch.push(batch(d));
    };
    Row {
        name,
        time: Box::new(time),
        measured,
    }
}

fn print_decisions(rows: &[Row]) {
    println!(
        "Candidates that do not come within d, mean ns: contact, and the distance d; one by one, and in"
    );
    println!("a batch.\n");
    println!(
        "| scene, kind, d | candidates | within d | contact | distance | ratio | contact, batch | distance, batch | ratio |"
    );
    println!("|---|{}", "---:|".repeat(8));
    for Row { name, measured, .. } in rows {
        let figures = |contact: &[f64], outside: &[f64]| {
            let (contact, outside) = (median(contact), median(outside));
            format!("{contact:.1} | {outside:.1} | {:.2}", outside / contact)
        };
        println!(
            "| {name} | {} | {} | {} | {} |",
            measured.candidates,
            measured.first.len(),
            figures(&measured.contact, &measured.outside),
            figures(&measured.contact_batch, &measured.outside_batch),
        );
    }
}

fn print_times(rows: &[Row]) {
    println!("\nCandidates that come within d, in ns: the first time, all intervals, the impact.\n");
    println!(
        "| scene, kind, d | first mean | median | worst | worst without exact | intervals mean | median | impact mean | median |"
    );
    println!("|---|{}", "---:|".repeat(8));
    for Row { name, measured, .. } in rows {
        println!(
            "| {name} | {:.0} | {:.0} | {:.0} | {:.0} | {:.0} | {:.0} | {:.0} | {:.0} |",
            mean(&measured.first),
            median(&measured.first),
            quantile(&measured.first, 1.0),
            quantile(&measured.first_filtered, 1.0),
            mean(&measured.intervals),
            median(&measured.intervals),
            mean(&measured.impacts),
            median(&measured.impacts),
        );
    }
}

fn print_stages(rows: &[Row]) {
    println!("\nCandidates settled at each stage, in %.\n");
    let names: Vec<String> = Stage::ALL.iter().map(|stage| format!("{stage:?}")).collect();
    println!("| scene, kind, d | {} |", names.join(" | "));
    println!("|---|{}", "---:|".repeat(names.len()));
    for Row { name, measured, .. } in rows {
        let share = |&count: &usize| format!("{:.3}", 100.0 * count as f64 / measured.candidates as f64);
        let shares: Vec<String> = measured.settled.iter().map(share).collect();
        println!("| {name} | {} |", shares.join(" | "));
    }
}
