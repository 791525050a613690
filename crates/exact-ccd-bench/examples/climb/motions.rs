//! Queries of two rigid bodies, and of points on quadratic Bézier curves.

use std::hint::black_box;

use exact_ccd::motion::{Bezier, BodyPair, Chain, CurvedQuery, RigidMotion};
use exact_ccd::{CONTACT, Kind, Point};
use exact_ccd_bench::fastest;
use fastrand::Rng;

use crate::climber::{Found, climb};
use crate::{ATTEMPTS, Answer, Start};

/// The motion of a candidate.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Motion {
    OneBody,
    TwoBodies,
    Quadratic,
}

/// The numbers of a candidate: four points; and two motions, each two quaternions and two places, or the
/// other control points of the points.
type Numbers = [f64; 40];

pub(crate) fn climb_motions<K: Kind<Points = [Point; 4]>>(
    motion: Motion,
    start: Start,
    answer: Answer,
    steps: u64,
    random: &mut Rng,
) -> Found<Numbers> {
    climb(
        random,
        steps,
        |random| [(); 40].map(|()| start.coordinate(random)),
        |numbers, random| change(start, numbers, random),
        |numbers| milliseconds::<K>(motion, numbers, answer),
    )
}

fn change(start: Start, mut numbers: Numbers, random: &mut Rng) -> Numbers {
    for _ in 0..random.u32(1..=3) {
        let [at, from] = [(); 2].map(|()| random.usize(0..40));
        numbers[at] = match random.u8(0..6) {
            0 | 1 => start.coordinate(random),
            2 => numbers[at].next_up(),
            3 => -numbers[at],
            4 => numbers[from],
            _ => 0.0,
        };
    }
    numbers
}

fn query<K: Kind<Points = [Point; 4]>>(motion: Motion, numbers: &Numbers) -> Option<CurvedQuery<K>> {
    let points = numbers.as_chunks::<3>().0;
    let four = |i: usize| [0, 1, 2, 3].map(|k: usize| points[4 * i + k]);
    if let Motion::Quadratic = motion {
        return Bezier::new(&[0, 1, 2].map(four)).ok().map(CurvedQuery::from);
    }
    let body = |from: usize| {
        let number = |i: usize| numbers[from + i];
        let quaternions = [0, 4].map(|i: usize| [0, 1, 2, 3].map(|k: usize| number(i + k)));
        let places = [8, 11].map(|i: usize| [0, 1, 2].map(|k: usize| number(i + k)));
        RigidMotion::new(quaternions, &places).ok().map(Chain::from)
    };
    let second = match motion {
        Motion::TwoBodies => body(26)?,
        _ => Chain::default(),
    };
    BodyPair::new(body(12)?, second).query(four(0)).ok()
}

fn milliseconds<K: Kind<Points = [Point; 4]>>(
    motion: Motion,
    numbers: &Numbers,
    answer: Answer,
) -> Option<f64> {
    let query = query::<K>(motion, numbers)?;
    let attempt = || {
        let query = black_box(&query);
        match answer {
            Answer::First => drop(black_box(query.time_of_impact(CONTACT))),
            Answer::Intervals => drop(black_box(query.intervals(CONTACT))),
            Answer::Impact => drop(black_box(query.impact(CONTACT))),
        }
    };
    Some(1e3 * fastest(ATTEMPTS, attempt))
}
