//! A search by hill climbing for the costliest query within a distance, or of curved motion in contact.
//!
//! `cargo run --release -p exact-ccd-bench --example climb [-- STEPS [SEED [ANSWER]] [motions]]`;
//! the answer is `first`, `intervals` or `impact`.
//!
//! A step changes a coordinate, its exponent, a whole point, or the distance, and is kept if the answer, by
//! default the first time within the distance, costs no less. With `motions`, the queries are of curved
//! motion, and the numbers of the costliest ones go to standard error. A climb that does not rise for a
//! while begins anew. The cost is the least wall time of three attempts, so that another run may climb
//! elsewhere.

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "this is its output")]

mod climber;
mod motions;

use std::hint::black_box;

use exact_ccd::{EdgeEdge, Kind, Point, Query, Separation, VertexFace};
use exact_ccd_bench::fastest;
use fastrand::Rng;

use climber::climb;
use motions::{Motion, climb_motions};

const ATTEMPTS: usize = 3;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut numbers = arguments.iter().filter_map(|argument| argument.parse().ok());
    let steps = numbers.next().unwrap_or(2_000);
    let seed = numbers.next().unwrap_or(1);
    let has = |word: &str| arguments.iter().any(|argument| argument == word);
    let answer = match () {
        () if has("intervals") => Answer::Intervals,
        () if has("impact") => Answer::Impact,
        () => Answer::First,
    };
    println!("{steps} steps for each start, seed {seed}, {answer:?}\n");
    if has("motions") {
        print_motions(answer, steps, seed);
        return;
    }
    println!("| kind | coordinates | worst ms | mean ms of the starts | d |");
    println!("|---|---|---:|---:|---:|");
    for start in [Start::Ordinary, Start::Powers, Start::Any] {
        climb_straight::<VertexFace>("vf", start, answer, steps, seed);
        climb_straight::<EdgeEdge>("ee", start, answer, steps, seed);
    }
}

fn print_motions(answer: Answer, steps: u64, seed: u64) {
    println!("| kind | motion | coordinates | worst ms | mean ms of the starts |");
    println!("|---|---|---|---:|---:|");
    for motion in [Motion::OneBody, Motion::TwoBodies, Motion::Quadratic] {
        for start in [Start::Ordinary, Start::Powers, Start::Any] {
            let mut random = Rng::with_seed(seed);
            let vf = climb_motions::<VertexFace>(motion, start, answer, steps, &mut random);
            let ee = climb_motions::<EdgeEdge>(motion, start, answer, steps, &mut random);
            for (kind, found) in [("vf", vf), ("ee", ee)] {
                println!(
                    "| {kind} | {motion:?} | {start:?} | {:.3} | {:.4} |",
                    found.worst, found.mean
                );
                eprintln!("{:?}", found.at);
            }
        }
    }
}

/// The answer whose cost counts.
#[derive(Clone, Copy, Debug)]
enum Answer {
    First,
    Intervals,
    Impact,
}

/// The coordinates and distances with which climbs begin, and that their steps try.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Start {
    /// Coordinates from −1 to 1, and tiny distances.
    Ordinary,
    /// Zeros and powers of two of any exponent.
    Powers,
    /// Finite f64 of any exponent.
    Any,
}

#[derive(Clone, Debug)]
struct Candidate {
    points: [[Point; 4]; 2],
    d: f64,
}

fn climb_straight<K: Kind<Points = [Point; 4]>>(
    kind: &str,
    start: Start,
    answer: Answer,
    steps: u64,
    seed: u64,
) {
    let found = climb(
        &mut Rng::with_seed(seed),
        steps,
        |random| start.begin(random),
        |candidate, random| start.change(candidate, random),
        |candidate| milliseconds::<K>(candidate, answer),
    );
    println!(
        "| {kind} | {start:?} | {:.3} | {:.4} | {:e} |",
        found.worst, found.mean, found.at.d
    );
}

/// The time of an answer within the distance; none if a coordinate is not finite.
fn milliseconds<K: Kind<Points = [Point; 4]>>(candidate: &Candidate, answer: Answer) -> Option<f64> {
    let [start, end] = candidate.points;
    let query = Query::<K>::new(start, end).ok()?;
    let d = Separation::new(candidate.d).ok()?;
    let attempt = || {
        let query = black_box(&query);
        match answer {
            Answer::First => {
                black_box(query.time_of_impact(d));
            }
            Answer::Intervals => {
                black_box(query.intervals(d));
            }
            Answer::Impact => {
                black_box(query.impact(d));
            }
        }
    };
    Some(1e3 * fastest(ATTEMPTS, attempt))
}

impl Start {
    fn begin(self, random: &mut Rng) -> Candidate {
        let mut candidate = Candidate {
            points: [[[0.0; 3]; 4]; 2],
            d: self.distance(random),
        };
        for coordinate in candidate.points.as_flattened_mut().as_flattened_mut() {
            *coordinate = self.coordinate(random);
        }
        candidate
    }

    fn coordinate(self, random: &mut Rng) -> f64 {
        let sign = if random.bool() { 1.0 } else { -1.0 };
        sign * match self {
            Self::Ordinary => random.f64(),
            Self::Powers if random.u8(0..3) == 0 => 0.0,
            Self::Powers => power(random.i32(-1074..=1000)),
            Self::Any => random.f64() * power(random.i32(-1074..=1000)),
        }
    }

    fn distance(self, random: &mut Rng) -> f64 {
        let least = power(random.i32(-1074..=-100)).max(5e-324);
        match self {
            Self::Ordinary => least,
            Self::Powers | Self::Any if random.bool() => least,
            Self::Powers | Self::Any => power(random.i32(-1074..=1000)),
        }
    }

    fn change(self, mut candidate: Candidate, random: &mut Rng) -> Candidate {
        for _ in 0..random.usize(1..=3) {
            let (time, point, axis) = (random.usize(0..2), random.usize(0..4), random.usize(0..3));
            let (other_time, other) = (random.usize(0..2), random.usize(0..4));
            let copied = candidate.points[other_time][other];
            let place = &mut candidate.points[time][point];
            match random.u8(0..8) {
                0 | 1 => place[axis] = self.coordinate(random),
                2 => {
                    place[axis] = if random.bool() {
                        place[axis].next_up()
                    } else {
                        place[axis].next_down()
                    }
                }
                3 if self != Self::Ordinary => place[axis] *= power(random.i32(-60..=60)),
                3 => place[axis] = -place[axis],
                4 => place[axis] = copied[axis],
                5 => *place = copied,
                6 => place[axis] = 0.0,
                _ => candidate.d = self.distance(random),
            }
        }
        candidate
    }
}

/// 2ᵏ, 0 if that is below the least f64.
fn power(exponent: i32) -> f64 {
    2.0f64.powi(exponent / 2) * 2.0f64.powi(exponent - exponent / 2)
}
