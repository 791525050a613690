//! The published queries of curved motion: the share that the filters leave to integers, and times of a
//! query, with filters and in integers alone; and near misses.
//!
//! `cargo bench -p exact-ccd-bench --bench curved`, on one thread. Times are means over the queries of a
//! file, in microseconds. The motion of a pair of bodies is prepared before, as for many queries. Near misses
//! and straight motion take turns, and their times are medians.

#![expect(clippy::print_stdout, reason = "this is its output")]

mod nonlinear;

use std::hint::black_box;

use exact_ccd::motion::{Bezier, BodyPair, Chain, CurvedQuery, RigidMotion};
use exact_ccd::{AnyKind, CONTACT, EdgeEdge, Kind, Point, Query, VertexFace, with_kind};
use exact_ccd_bench::{fastest, median};
use exact_ccd_data::{CurvedRecord, DataError};
use fastrand::Rng;

use nonlinear::files;

const RUNS: usize = 3;

/// The number of turns of near misses and straight motion.
const ROUNDS: usize = 21;

/// The number of near misses of each kind.
const NEAR: usize = 2000;

fn main() -> Result<(), DataError> {
    println!(
        "| queries | collide, % | integers, % | collides | time of impact | integers: collides | time of impact |"
    );
    println!("|---|{}", "---:|".repeat(6));
    for (name, lines) in files()? {
        for &kind in AnyKind::ALL {
            with_kind!(kind, K => print_row(&name, &lines.iter().filter_map(CurvedRecord::query::<K>).collect::<Vec<_>>()));
        }
    }
    println!(
        "\n| near misses | integers, % | collides | straight | ratio | time of impact | straight | ratio |"
    );
    println!("|---|{}", "---:|".repeat(7));
    print_near::<VertexFace>("vf");
    print_near::<EdgeEdge>("ee");
    Ok(())
}

fn microseconds_each<T>(runs: usize, queries: &[T], answer: impl Fn(&T) -> bool) -> f64 {
    let all = || queries.iter().filter(|query| answer(black_box(query))).count();
    1e6 * fastest(runs, all) / queries.len() as f64
}

fn percent(count: usize, all: usize) -> f64 {
    100.0 * count as f64 / all as f64
}

fn print_row<K: Kind>(name: &str, queries: &[CurvedQuery<K>]) {
    if queries.is_empty() {
        return;
    }
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
        microseconds_each(RUNS, queries, |query| query.collides(CONTACT)),
        microseconds_each(RUNS, queries, |query| query.time_of_impact(CONTACT).is_some()),
        microseconds_each(RUNS, queries, |query| query.exactly().collides(CONTACT)),
        microseconds_each(RUNS, queries, |query| query
            .exactly()
            .time_of_impact(CONTACT)
            .is_some()),
    );
}

/// Primitives of a body that turns by about 90° near others: at rest, or of a body that turns by a few
/// degrees. And quadratic and straight motion between the same ends. Half of the former touch or miss by
/// less than a hundredth.
fn print_near<K: Kind<Points = [Point; 4]>>(name: &str) {
    let mut random = Rng::with_seed(1);
    let quaternions = [[1.0, 0.1, -0.2, 0.3], [0.8, -0.4, 0.5, 0.9]];
    let motion = RigidMotion::new(quaternions, &[[0.0; 3], [0.3, -0.2, 0.1]]).expect("a motion");
    let slow = [[1.0, 0.0, 0.0, 0.0], [1.0, 0.02, 0.01, -0.03]];
    let slow = RigidMotion::new(slow, &[[0.0; 3], [0.01, 0.0, -0.02]]).expect("a motion");
    let pair = BodyPair::new(motion.clone().into(), Chain::default());
    let pair_of_two = BodyPair::new(motion.into(), slow.into());
    let mut point = |scale: f64| [(); 3].map(|()| scale * (random.f64() - 0.5));
    let (mut curved, mut straight) = ([(); 3].map(|()| Vec::new()), Vec::new());
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
        let middle = [0, 1, 2, 3].map(|i: usize| {
            let bend = point(0.1);
            [0, 1, 2].map(|axis: usize| 0.5 * (points[i][axis] + ends[i][axis]) + bend[axis])
        });
        let bezier = Bezier::new(&[points, middle, ends]).expect("finite points");
        curved[0].push(CurvedQuery::<K>::from(bezier));
        curved[1].push(pair.query::<K>(points).expect("finite points"));
        curved[2].push(pair_of_two.query::<K>(points).expect("finite points"));
        straight.push(Query::<K>::new(points, ends).expect("finite points"));
    }
    let is_left = |query: &&CurvedQuery<K>| query.bracket(CONTACT).is_none();
    for (motion, queries) in ["quadratic", "one body", "two bodies"].iter().zip(&curved) {
        let [decision, of_straight] = in_turns(
            || microseconds_each(1, queries, |query| query.collides(CONTACT)),
            || microseconds_each(1, &straight, |query| query.collides(CONTACT)),
        );
        let [time, time_of_straight] = in_turns(
            || microseconds_each(1, queries, |query| query.time_of_impact(CONTACT).is_some()),
            || microseconds_each(1, &straight, |query| query.time_of_impact(CONTACT).is_some()),
        );
        println!(
            "| {name}, {motion} | {:.2} | {decision:.2} | {of_straight:.2} | {:.1} | {time:.2} | \
             {time_of_straight:.2} | {:.1} |",
            percent(queries.iter().filter(is_left).count(), queries.len()),
            decision / of_straight,
            time / time_of_straight,
        );
    }
}

/// The medians of two measurements that take turns.
fn in_turns(one: impl Fn() -> f64, other: impl Fn() -> f64) -> [f64; 2] {
    let both: Vec<_> = (0..ROUNDS).map(|_| [one(), other()]).collect();
    [0, 1].map(|i: usize| median(&both.iter().map(|turn| turn[i]).collect::<Vec<_>>()))
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
