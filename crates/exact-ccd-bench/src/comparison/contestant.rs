//! Who answers, and what an answer takes.

use std::hint::black_box;
use std::time::{Duration, Instant};

use exact_ccd::Query;
use exact_ccd_methods::{Answer, Method, Promise};

use super::peer::{Peer, PeerError};
use crate::kind::DataKind;

/// A method in a comparison: one behind the trait, or one of another program.
pub enum Contestant {
    /// It runs in this process.
    Method(Box<dyn Method>),
    /// It runs in a process of its own.
    Peer(Peer),
}

/// An answer and the time that it took, in nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Timed {
    pub(super) answer: Answer,
    pub(super) nanoseconds: f64,
}

/// How often the same queries are answered, of which the least time counts: what is longer tells of the scheduler.
const ATTEMPTS: usize = 3;

/// Answers that take longer than this, for some queries together, are not repeated.
const PATIENCE: Duration = Duration::from_millis(20);

impl Contestant {
    /// The name in tables.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Method(method) => method.name(),
            Self::Peer(peer) => peer.name(),
        }
    }

    /// What its answers are worth.
    #[must_use]
    pub fn promise(&self) -> Promise {
        match self {
            Self::Method(method) => method.promise(),
            Self::Peer(peer) => peer.promise(),
        }
    }

    /// Answers some queries, the first of them at least, until the time is up.
    pub(super) fn answer<K: DataKind>(
        &mut self,
        queries: &[Query<K>],
        limit: Duration,
    ) -> Result<Vec<Timed>, PeerError> {
        let clock = Instant::now();
        let mut best = self.attempt(queries, limit)?;
        for _ in 1..ATTEMPTS {
            if clock.elapsed() > PATIENCE.min(limit) {
                break;
            }
            let again = self.attempt(queries, limit)?;
            for (best, again) in best.iter_mut().zip(again) {
                best.nanoseconds = best.nanoseconds.min(again.nanoseconds);
            }
        }
        Ok(best)
    }

    fn attempt<K: DataKind>(
        &mut self,
        queries: &[Query<K>],
        limit: Duration,
    ) -> Result<Vec<Timed>, PeerError> {
        match self {
            Self::Method(method) => Ok(time_all(method.as_ref(), queries, limit)),
            Self::Peer(peer) => peer.answer(queries, limit),
        }
    }
}

fn time_all<K: DataKind>(method: &dyn Method, queries: &[Query<K>], limit: Duration) -> Vec<Timed> {
    let reading = reading_the_clock();
    let begin = Instant::now();
    let mut answers = Vec::with_capacity(queries.len());
    for query in queries {
        let clock = Instant::now();
        let answer = black_box(K::ask(method, black_box(query)));
        let elapsed = clock.elapsed().as_secs_f64() * 1e9;
        answers.push(Timed {
            answer,
            nanoseconds: (elapsed - reading).max(0.0),
        });
        if begin.elapsed() > limit {
            break;
        }
    }
    answers
}

/// What it takes to read the clock, in nanoseconds: the least of some attempts.
fn reading_the_clock() -> f64 {
    let attempt = |_| {
        let clock = Instant::now();
        clock.elapsed().as_secs_f64() * 1e9
    };
    (0..20).map(attempt).fold(f64::INFINITY, f64::min)
}
