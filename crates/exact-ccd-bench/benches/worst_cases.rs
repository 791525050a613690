//! The cost of queries that are as costly as possible: exponents over the whole range, near-double roots,
//! motion in a plane, equal points.
//!
//! `cargo bench -p exact-ccd-bench --bench worst_cases [-- QUERIES]`, on one thread; 100 queries of
//! each family if no number is given. The queries are generated with fixed seeds. The time of a query is
//! the least of five attempts. A row covers families of one kind. The exact path alone is timed on all
//! families, for contact, and within the distance that the primitives have at t = 0, 1/2 or 1. With the
//! filters, only the families of coincident points are timed, for contact.

#![expect(clippy::print_stdout, reason = "this is its output")]

use exact_ccd::{EdgeEdge, Kind, Query, Separation, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_bench::nanoseconds;

use exact_ccd_testing::hard_cases::extremes::families;
use exact_ccd_testing::hard_cases::hard::Hard;
use exact_ccd_testing::hard_cases::{Family, coincident, queries};

/// The answers that are timed.
const ANSWERS: [&str; 4] = ["collides", "time_of_impact", "intervals", "impact"];

fn main() {
    let argument = |argument: String| argument.parse().ok();
    let count = std::env::args().skip(1).find_map(argument).unwrap_or(100);
    println!("Mean and worst ms, and the costliest family.\n");
    println!(
        "| query | {} mean | worst | family |",
        ANSWERS.join(" mean | worst | ")
    );
    println!("|---|{}---|", "---:|".repeat(2 * ANSWERS.len()));
    let (of_vf, of_ee) = (&families::<VertexFace>(), &families::<EdgeEdge>());
    let (of_ve, of_vv) = (&families::<VertexEdge>(), &families::<VertexVertex>());
    Rows::<VertexFace>::of(of_vf, count).print("vf, contact", contact, exactly);
    Rows::<EdgeEdge>::of(of_ee, count).print("ee, contact", contact, exactly);
    Rows::<VertexFace>::of(of_vf, count).print("vf, distance", distance, exactly);
    Rows::<EdgeEdge>::of(of_ee, count).print("ee, distance", distance, exactly);
    Rows::<VertexEdge>::of(of_ve, count).print("ve, distance", distance, exactly);
    Rows::<VertexVertex>::of(of_vv, count).print("vv, distance", distance, exactly);
    let equal = &coincident::FAMILIES;
    Rows::<VertexFace>::of(equal, count).print("vf, equal points", contact, with_filters);
    Rows::<EdgeEdge>::of(equal, count).print("ee, equal points", contact, with_filters);
}

/// The queries of some families, each with the index of its family.
struct Rows<'a, K: Kind> {
    families: &'a [(&'static str, Family)],
    queries: Vec<(usize, Query<K>)>,
}

impl<'a, K: Hard> Rows<'a, K> {
    /// Queries of each family.
    fn of(families: &'a [(&'static str, Family)], count: usize) -> Self {
        let of_family = |(index, (_, family)): (usize, &(_, Family))| {
            queries::<K>(*family, count).map(move |query| (index, query))
        };
        let queries = families.iter().enumerate().flat_map(of_family).collect();
        Self { families, queries }
    }

    fn print(
        &self,
        name: &str,
        separation: fn(usize, &Query<K>) -> Separation,
        times_of: fn(&Query<K>, Separation) -> [f64; ANSWERS.len()],
    ) {
        let queries = self.queries.iter().enumerate();
        let times =
            queries.map(|(index, (family, query))| (*family, times_of(query, separation(index, query))));
        let times: Vec<_> = times.collect();
        let cells = (0..ANSWERS.len()).map(|answer| {
            let of_answer = || times.iter().map(|(_, times)| times[answer]);
            let mean = of_answer().sum::<f64>() / times.len() as f64;
            format!("{mean:.3} | {:.3}", of_answer().fold(0.0, f64::max))
        });
        let cells = cells.collect::<Vec<_>>().join(" | ");
        let total = |times: &[f64]| times.iter().sum::<f64>();
        let worst = times
            .iter()
            .max_by(|(_, a), (_, b)| total(a).total_cmp(&total(b)));
        let family = worst.map_or("", |(family, _)| self.families[*family].0);
        println!("| {name} | {cells} | {family} |");
    }
}

fn contact<K: Kind>(_: usize, _: &Query<K>) -> Separation {
    Separation::ZERO
}

fn distance<K: Kind>(index: usize, query: &Query<K>) -> Separation {
    let at = query.distance_at([0.0, 0.5, 1.0][index % 3]);
    let d = at.expect("it is a time of the step").lower;
    Separation::new(d).expect("a lower bound of a distance is finite")
}

fn exactly<K: Kind>(query: &Query<K>, d: Separation) -> [f64; ANSWERS.len()] {
    [
        milliseconds(|| query.exactly().collides(d)),
        milliseconds(|| query.exactly().time_of_impact(d)),
        milliseconds(|| query.exactly().intervals(d)),
        milliseconds(|| query.exactly().impact(d)),
    ]
}

fn with_filters<K: Kind>(query: &Query<K>, d: Separation) -> [f64; ANSWERS.len()] {
    [
        milliseconds(|| query.collides(d)),
        milliseconds(|| query.time_of_impact(d)),
        milliseconds(|| query.intervals(d)),
        milliseconds(|| query.impact(d)),
    ]
}

fn milliseconds<T>(task: impl Fn() -> T) -> f64 {
    1e-6 * nanoseconds(task)
}
