//! The methods of a comparison, and the timing of their answers.

use std::hint::black_box;
use std::time::{Duration, Instant};

use exact_ccd::{Ccd, Decide, Guarantees, Query, TimeGuarantee};
use exact_ccd_data::DataKind;

use crate::peer::{Peer, PeerError};
use crate::timed::Timed;

/// A method in a comparison.
pub enum Contestant {
    /// A method that runs in this process.
    Method(Box<dyn Ccd>),
    /// A method that runs in a process of its own.
    Peer(Peer),
}

/// The number of times that the same queries are answered. The least time counts: longer ones are
/// due to the scheduler.
const ATTEMPTS: usize = 3;

/// Queries that together take longer than this are answered only once.
const PATIENCE: Duration = Duration::from_millis(20);

impl Contestant {
    /// The name of the method.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Method(method) => method.name(),
            Self::Peer(peer) => peer.name(),
        }
    }

    /// The guarantees of the method's answers.
    #[must_use]
    pub fn guarantees(&self) -> Guarantees {
        match self {
            Self::Method(method) => method.guarantees(),
            Self::Peer(peer) => peer.guarantees(),
        }
    }

    /// Answers queries in order until the time limit, but at least the first.
    pub(super) fn answer<K: DataKind>(
        &mut self,
        queries: &[Query<K>],
        limit: Duration,
    ) -> Result<Vec<Timed>, PeerError>
    where
        dyn Ccd: Decide<K>,
    {
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

    fn attempt<K: DataKind>(&mut self, queries: &[Query<K>], limit: Duration) -> Result<Vec<Timed>, PeerError>
    where
        dyn Ccd: Decide<K>,
    {
        match self {
            Self::Method(method) => {
                let has_times = method.guarantees().time != TimeGuarantee::Absent;
                Ok(time_all(method.as_ref(), has_times, queries, limit))
            }
            Self::Peer(peer) => peer.answer(queries, limit),
        }
    }
}

fn time_all<K: DataKind>(
    method: &(impl Decide<K> + ?Sized),
    has_times: bool,
    queries: &[Query<K>],
    limit: Duration,
) -> Vec<Timed> {
    let overhead = clock_overhead();
    let begin = Instant::now();
    let mut answers = Vec::with_capacity(queries.len());
    for query in queries {
        let clock = Instant::now();
        let time = black_box(method.time_of_impact(black_box(query)));
        let elapsed = clock.elapsed().as_secs_f64() * 1e9;
        answers.push(Timed {
            collides: time.is_some(),
            time: time.filter(|_| has_times),
            nanoseconds: (elapsed - overhead).max(0.0),
        });
        if begin.elapsed() > limit {
            break;
        }
    }
    answers
}

/// The time that a reading of the clock takes, in nanoseconds: the least of some attempts.
fn clock_overhead() -> f64 {
    let attempt = |_| {
        let clock = Instant::now();
        clock.elapsed().as_secs_f64() * 1e9
    };
    (0..20).map(attempt).fold(f64::INFINITY, f64::min)
}
