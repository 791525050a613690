//! The cost of the exact path on queries that are as costly as possible: exponents over the whole
//! range, near-double roots, motion in a plane, equal points.
//!
//! `cargo bench -p exact-ccd-bench --bench worst_cases [-- QUERIES]`, on one thread; 100 queries of
//! each family if no number is given. The queries are generated with fixed seeds. The time of a query
//! is the least of three attempts.

#![expect(clippy::print_stdout, reason = "this is its output")]

#[path = "../../exact-ccd/tests/worst_cases/families.rs"]
mod families;

use std::hint::black_box;
use std::time::Instant;

use exact_ccd::separation::Separation;
use exact_ccd::{EdgeEdge, Query, VertexFace, exact};

use families::{Primitives, Random, families};

const ATTEMPTS: usize = 3;

fn main() {
    let count = std::env::args()
        .skip(1)
        .find_map(|argument| argument.parse().ok());
    println!("The exact path alone, mean and worst ms of the queries of a family.\n");
    println!("| family | `collides` mean | worst | `contact_times` mean | worst | `impact` mean | worst |");
    println!("|---|{}", "---:|".repeat(6));
    print_rows::<VertexFace>("vf", count.unwrap_or(100));
    print_rows::<EdgeEdge>("ee", count.unwrap_or(100));
    println!("\nThe same within the distance that the primitives have at t = 0, 1/2 or 1.\n");
    println!(
        "| family | `comes_within` mean | worst | `first_within` mean | worst | `impact_within` mean | worst |"
    );
    println!("|---|{}", "---:|".repeat(6));
    print_rows_within::<VertexFace>("vf", count.unwrap_or(100));
    print_rows_within::<EdgeEdge>("ee", count.unwrap_or(100));
}

fn print_rows<K: Primitives>(kind: &str, count: usize) {
    for (name, family) in families::<K>() {
        let mut random = Random(1);
        let mut times = [const { Vec::new() }; 3];
        for [start, end] in (0..count).map(|_| family(&mut random)) {
            // A sum may overflow.
            let Ok(query) = Query::<K>::new(start, end) else {
                continue;
            };
            times[0].push(milliseconds(|| exact::collides(&query)));
            times[1].push(milliseconds(|| exact::contact_times(&query)));
            times[2].push(milliseconds(|| exact::impact(&query)));
        }
        print_row(kind, name, times);
    }
}

fn print_rows_within<K: Primitives>(kind: &str, count: usize) {
    for (name, family) in families::<K>() {
        let mut random = Random(1);
        let mut times = [const { Vec::new() }; 3];
        for (index, [start, end]) in (0..count).map(|index| (index, family(&mut random))) {
            let Ok(query) = Query::<K>::new(start, end) else {
                continue;
            };
            let at = query.distance_at([0.0, 0.5, 1.0][index % 3]);
            let d = at.expect("it is a time of the step").lower;
            let d = Separation::new(d).expect("a lower bound of a distance is finite");
            times[0].push(milliseconds(|| exact::separation::comes_within(&query, d)));
            times[1].push(milliseconds(|| exact::separation::first_within(&query, d)));
            times[2].push(milliseconds(|| exact::separation::impact_within(&query, d)));
        }
        print_row(kind, name, times);
    }
}

fn print_row(kind: &str, name: &str, times: [Vec<f64>; 3]) {
    let cells = times.map(|times| {
        let mean = times.iter().sum::<f64>() / times.len() as f64;
        format!(
            "{mean:.3} | {:.3}",
            times.iter().fold(0.0, |worst: f64, &time| worst.max(time))
        )
    });
    println!("| {kind}: {name} | {} |", cells.join(" | "));
}

fn milliseconds<T>(task: impl Fn() -> T) -> f64 {
    let attempt = |_| {
        let clock = Instant::now();
        black_box(task());
        clock.elapsed().as_secs_f64() * 1e3
    };
    (0..ATTEMPTS).map(attempt).fold(f64::INFINITY, f64::min)
}
