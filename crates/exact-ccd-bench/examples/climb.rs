//! A search by hill climbing for the costliest query within a distance.
//!
//! `cargo run --release -p exact-ccd-bench --example climb [-- STEPS [SEED [first|intervals|impact]]]`
//!
//! A step changes a coordinate, its exponent, a whole point, or the distance, and is kept if the answer, by
//! default the first time within the distance, costs no less. A climb that does not rise for a while begins
//! anew. The cost is the least wall time of three attempts, so that another run may climb elsewhere.

#![expect(clippy::print_stdout, reason = "this is its output")]

use std::hint::black_box;

use exact_ccd::{EdgeEdge, Kind, Point, Query, Separation, VertexFace};
use exact_ccd_bench::fastest;

const ATTEMPTS: usize = 3;
/// The number of steps without a rise after which a climb begins anew.
const PATIENCE: usize = 150;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut numbers = arguments.iter().filter_map(|argument| argument.parse().ok());
    let steps = numbers.next().unwrap_or(2_000);
    let seed = numbers.next().unwrap_or(1);
    let answer = match arguments.last().map(String::as_str) {
        Some("intervals") => Answer::Intervals,
        Some("impact") => Answer::Impact,
        _ => Answer::First,
    };
    println!("{steps} steps for each start, seed {seed}, {answer:?}\n");
    println!("| kind | coordinates | worst ms | mean ms of the starts | d |");
    println!("|---|---|---:|---:|---:|");
    for start in [Start::Ordinary, Start::Powers, Start::Any] {
        climb::<VertexFace>("vf", start, answer, steps, seed);
        climb::<EdgeEdge>("ee", start, answer, steps, seed);
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

fn climb<K: Kind<Points = [Point; 4]>>(kind: &str, start: Start, answer: Answer, steps: u64, seed: u64) {
    let mut random = fastrand::Rng::with_seed(seed);
    let (mut worst, mut at) = (0.0, 0.0);
    let (mut begun, mut total) = (0_u32, 0.0);
    let mut climber: Option<(f64, Candidate, usize)> = None;
    for _ in 0..steps {
        let (cost, candidate, rested) = match climber.take() {
            Some((least, candidate, rested)) if rested < PATIENCE => {
                let changed = start.change(candidate.clone(), &mut random);
                match milliseconds::<K>(&changed, answer) {
                    Some(cost) if cost >= least => {
                        (cost, changed, if cost > 1.02 * least { 0 } else { rested + 1 })
                    }
                    _ => (least, candidate, rested + 1),
                }
            }
            _ => {
                let candidate = start.begin(&mut random);
                let cost = milliseconds::<K>(&candidate, answer).unwrap_or_default();
                begun += 1;
                total += cost;
                (cost, candidate, 0)
            }
        };
        if cost > worst {
            (worst, at) = (cost, candidate.d);
        }
        climber = Some((cost, candidate, rested));
    }
    let mean = total / f64::from(begun.max(1));
    println!("| {kind} | {start:?} | {worst:.3} | {mean:.4} | {at:e} |");
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
    fn begin(self, random: &mut fastrand::Rng) -> Candidate {
        let mut candidate = Candidate {
            points: [[[0.0; 3]; 4]; 2],
            d: self.distance(random),
        };
        for coordinate in candidate.points.as_flattened_mut().as_flattened_mut() {
            *coordinate = self.coordinate(random);
        }
        candidate
    }

    fn coordinate(self, random: &mut fastrand::Rng) -> f64 {
        let sign = if random.bool() { 1.0 } else { -1.0 };
        sign * match self {
            Self::Ordinary => random.f64(),
            Self::Powers if random.u8(0..3) == 0 => 0.0,
            Self::Powers => power(random.i32(-1074..=1000)),
            Self::Any => random.f64() * power(random.i32(-1074..=1000)),
        }
    }

    fn distance(self, random: &mut fastrand::Rng) -> f64 {
        let least = power(random.i32(-1074..=-100)).max(5e-324);
        match self {
            Self::Ordinary => least,
            Self::Powers | Self::Any if random.bool() => least,
            Self::Powers | Self::Any => power(random.i32(-1074..=1000)),
        }
    }

    fn change(self, mut candidate: Candidate, random: &mut fastrand::Rng) -> Candidate {
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
