//! The published queries of curved motion: the share that the filters leave to integers, and times of a
//! query, with filters and in integers alone; near misses; steps of two meshes; and a recording.
//!
//! `cargo bench -p exact-ccd-bench --bench curved`, on one thread. Times are means over the queries of a
//! file, in microseconds. The motion of a pair of bodies is prepared before, as for many queries.

#![expect(clippy::print_stdout, reason = "this is its output")]

mod bodies;
mod nonlinear;

use std::hint::black_box;

use exact_ccd::motion::{BodyPair, Chain, CurvedQuery, RigidMotion};
use exact_ccd::{CONTACT, EdgeEdge, Kind, Point, Query, VertexFace};
use exact_ccd_bench::fastest;
use exact_ccd_data::DataError;
use fastrand::Rng;

use nonlinear::{files, query};

const RUNS: usize = 3;

/// The number of near misses of each kind.
const NEAR: usize = 2000;

fn main() -> Result<(), DataError> {
    println!(
        "| queries | collide, % | integers, % | collides | time of impact | integers: collides | time of impact |"
    );
    println!("|---|{}", "---:|".repeat(6));
    for (name, lines) in files()? {
        if lines.iter().all(|line| line.kind == "vf") {
            print_row(&name, &lines.iter().map(query::<VertexFace>).collect::<Vec<_>>());
        } else {
            print_row(&name, &lines.iter().map(query::<EdgeEdge>).collect::<Vec<_>>());
        }
    }
    println!("\n| near misses | integers, % | one body turns | straight |");
    println!("|---|{}", "---:|".repeat(3));
    print_near::<VertexFace>("vf");
    print_near::<EdgeEdge>("ee");
    bodies::print();
    Ok(())
}

fn microseconds_each<T>(queries: &[T], answer: impl Fn(&T) -> bool) -> f64 {
    let all = || queries.iter().filter(|query| answer(black_box(query))).count();
    1e6 * fastest(RUNS, all) / queries.len() as f64
}

fn percent(count: usize, all: usize) -> f64 {
    100.0 * count as f64 / all as f64
}

fn print_row<K: Kind>(name: &str, queries: &[CurvedQuery<K>]) {
    let count = |is_counted: &dyn Fn(&CurvedQuery<K>) -> bool| {
        percent(
            queries.iter().filter(|query| is_counted(query)).count(),
            queries.len(),
        )
    };
    println!(
        "| {name} | {:.0} | {:.1} | {:.1} | {:.1} | {:.1} | {:.1} |",
        count(&|query| query.collides(CONTACT)),
        count(&|query| query.bracket(CONTACT).is_none()),
        microseconds_each(queries, |query| query.collides(CONTACT)),
        microseconds_each(queries, |query| query.time_of_impact(CONTACT).is_some()),
        microseconds_each(queries, |query| query.exactly().collides(CONTACT)),
        microseconds_each(queries, |query| query.exactly().time_of_impact(CONTACT).is_some()),
    );
}

/// Primitives of a body that turns by about 90° near others at rest, and straight motion between the same
/// ends. Half of the former touch or miss by less than a hundredth.
fn print_near<K: Kind<Points = [Point; 4]>>(name: &str) {
    let mut random = Rng::with_seed(1);
    let quaternions = [[1.0, 0.1, -0.2, 0.3], [0.8, -0.4, 0.5, 0.9]];
    let motion = RigidMotion::new(quaternions, &[[0.0; 3], [0.3, -0.2, 0.1]]).expect("a motion");
    let pair = BodyPair::new(motion.into(), Chain::default());
    let mut point = |scale: f64| [(); 3].map(|()| scale * (random.f64() - 0.5));
    let (mut curved, mut straight) = (Vec::new(), Vec::new());
    for _ in 0..NEAR {
        let center = point(2.0);
        let mut points = [(); 4].map(|()| {
            let offset = point(0.2);
            [0, 1, 2].map(|axis: usize| center[axis] + offset[axis])
        });
        let end = points.map(|p| path_end(&pair, p));
        let shift: Point = point(0.02);
        // The second primitive is near the path of the first one.
        for (target, end) in points[K::FIRST..].iter_mut().zip(&end[K::FIRST..]) {
            *target = [0, 1, 2].map(|axis: usize| 0.5 * (target[axis] + end[axis]) + shift[axis]);
        }
        let mut ends = points;
        ends[..K::FIRST].copy_from_slice(&end[..K::FIRST]);
        curved.push(pair.query::<K>(points).expect("finite points"));
        straight.push(Query::<K>::new(points, ends).expect("finite points"));
    }
    let integers = curved
        .iter()
        .filter(|query| query.bracket(CONTACT).is_none())
        .count();
    println!(
        "| {name} | {:.2} | {:.2} | {:.2} |",
        percent(integers, curved.len()),
        microseconds_each(&curved, |query| query.collides(CONTACT)),
        microseconds_each(&straight, |query| query.collides(CONTACT)),
    );
}

/// The place of a point at the end, about.
fn path_end(pair: &BodyPair, point: Point) -> Point {
    let motion = &pair.chains()[0].motions()[0];
    let ([_, [a, b, c, d]], [x, y, z]) = (motion.quaternions(), point);
    let [aa, bb, cc, dd] = [a * a, b * b, c * c, d * d];
    let turned = [
        (aa + bb - cc - dd) * x + 2.0 * (b * c - a * d) * y + 2.0 * (b * d + a * c) * z,
        2.0 * (b * c + a * d) * x + (aa - bb + cc - dd) * y + 2.0 * (c * d - a * b) * z,
        2.0 * (b * d - a * c) * x + 2.0 * (c * d + a * b) * y + (aa - bb - cc + dd) * z,
    ];
    let place = motion.places()[1];
    [0, 1, 2].map(|axis: usize| turned[axis] / (aa + bb + cc + dd) + place[axis])
}
