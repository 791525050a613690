//! The cost of queries that are as costly as possible: exponents over the whole range, near-double roots,
//! motion in a plane, equal points.
//!
//! `cargo bench -p exact-ccd-bench --bench worst_cases [-- QUERIES]`, on one thread; 100 queries of
//! each family if no number is given. The queries are generated with fixed seeds. The time of a query
//! is the least of five attempts.

#![expect(clippy::print_stdout, reason = "this is its output")]

#[path = "../../exact-ccd/tests/worst_cases/coincident.rs"]
mod coincident;
#[path = "../../exact-ccd/tests/worst_cases/families.rs"]
mod families;

use std::hint::black_box;
use std::time::Instant;

use exact_ccd::{CONTACT, EdgeEdge, Kind, Query, Separation, VertexEdge, VertexFace, VertexVertex, exact};

use families::{Family, Points, Primitives, Random, families};

const ATTEMPTS: usize = 5;

fn main() {
    let count = std::env::args()
        .skip(1)
        .find_map(|argument| argument.parse().ok())
        .unwrap_or(100);
    println!("The exact path alone, mean and worst ms of the queries of a family.\n");
    print_head(["`collides`", "`intervals`", "`impact`"]);
    print_contact::<VertexFace>("vf", count);
    print_contact::<EdgeEdge>("ee", count);

    println!("\nThe same within the distance that the primitives have at t = 0, 1/2 or 1.\n");
    print_head(["`collides`", "`time_of_impact`", "`intervals`", "`impact`"]);
    print_within::<VertexFace>("vf", &families::<VertexFace>(), count, |now| now);
    print_within::<EdgeEdge>("ee", &families::<EdgeEdge>(), count, |now| now);
    print_within::<VertexEdge>("ve", &families::<EdgeEdge>(), count, |[p, _, a, b]| [p, a, b]);
    print_within::<VertexVertex>("vv", &families::<EdgeEdge>(), count, |[p, _, q, _]| [p, q]);

    println!("\nPoints that coincide, with the filters, mean and worst ms.\n");
    print_head(["`collides`", "`intervals`", "`impact`"]);
    print_coincident::<VertexFace>("vf", count);
    print_coincident::<EdgeEdge>("ee", count);
}

/// The queries of a family; a coordinate may be out of range.
fn queries<K: Kind>(
    family: Family,
    count: usize,
    points: fn(<VertexFace as Kind>::Points) -> K::Points,
) -> impl Iterator<Item = Query<K>> {
    let mut random = Random(1);
    let generated = (0..count).map(move |_| -> Points { family(&mut random) });
    generated.filter_map(move |[start, end]| Query::new(points(start), points(end)).ok())
}

fn print_contact<K: Primitives>(kind: &str, count: usize) {
    for (name, family) in families::<K>() {
        let times = queries::<K>(family, count, |now| now).map(|query| {
            [
                milliseconds(|| exact::collides(&query, CONTACT)),
                milliseconds(|| exact::intervals(&query, CONTACT)),
                milliseconds(|| exact::impact(&query, CONTACT)),
            ]
        });
        print_row(kind, name, times);
    }
}

fn print_within<K: Kind>(
    kind: &str,
    families: &[(&str, Family)],
    count: usize,
    points: fn(<VertexFace as Kind>::Points) -> K::Points,
) {
    for &(name, family) in families {
        let queries = queries::<K>(family, count, points).enumerate();
        let times = queries.map(|(index, query)| {
            let at = query.distance_at([0.0, 0.5, 1.0][index % 3]);
            let d = at.expect("it is a time of the step").lower;
            let d = Separation::new(d).expect("a lower bound of a distance is finite");
            [
                milliseconds(|| exact::collides(&query, d)),
                milliseconds(|| exact::time_of_impact(&query, d)),
                milliseconds(|| exact::intervals(&query, d)),
                milliseconds(|| exact::impact(&query, d)),
            ]
        });
        print_row(kind, name, times);
    }
}

fn print_coincident<K: Primitives>(kind: &str, count: usize) {
    for (name, family) in coincident::FAMILIES {
        let times = queries::<K>(family, count, |now| now).map(|query| {
            [
                milliseconds(|| query.collides(CONTACT)),
                milliseconds(|| query.intervals(CONTACT)),
                milliseconds(|| query.impact(CONTACT)),
            ]
        });
        print_row(kind, name, times);
    }
}

fn print_head<const N: usize>(functions: [&str; N]) {
    println!("| family | {} mean | worst |", functions.join(" mean | worst | "));
    println!("|---|{}", "---:|".repeat(2 * N));
}

fn print_row<const N: usize>(kind: &str, name: &str, times: impl Iterator<Item = [f64; N]>) {
    let times: Vec<_> = times.collect();
    let cells = (0..N).map(|function| {
        let of_function = || times.iter().map(|times| times[function]);
        let mean = of_function().sum::<f64>() / times.len() as f64;
        format!("{mean:.4} | {:.4}", of_function().fold(0.0, f64::max))
    });
    println!("| {kind}: {name} | {} |", cells.collect::<Vec<_>>().join(" | "));
}

fn milliseconds<T>(task: impl Fn() -> T) -> f64 {
    let attempt = |_| {
        let clock = Instant::now();
        black_box(task());
        clock.elapsed().as_secs_f64() * 1e3
    };
    (0..ATTEMPTS).map(attempt).fold(f64::INFINITY, f64::min)
}
