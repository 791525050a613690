//! A comparison, data set by data set.

use std::time::Duration;

use exact_ccd::Query;

use super::contestant::{Contestant, Timed};
use super::peer::PeerError;
use super::sampling::{Subject, Subjects};
use super::table::Table;
use crate::kind::DataKind;

/// Contestants, and the time that each of them has.
pub struct Comparison {
    contestants: Vec<Contestant>,
    budget: Duration,
}

/// How many queries a contestant answers before the next one takes its turn.
const TURN: usize = 128;

/// How the contestants stand on one data set.
struct Standing {
    answers: Vec<Timed>,
    left: Duration,
}

impl Comparison {
    /// Each contestant answers the queries of a data set one after the other until it has spent its budget of time on
    /// them.
    #[must_use]
    pub fn new(contestants: Vec<Contestant>, budget: Duration) -> Self {
        Self { contestants, budget }
    }

    /// The contestants.
    #[must_use]
    pub fn contestants(&self) -> &[Contestant] {
        &self.contestants
    }

    /// Lets all contestants answer the sample of a data set. They take turns, so that whatever the machine does besides
    /// hits all of them alike. `progress` is told, from time to time, which part of the work is done.
    ///
    /// # Errors
    /// If a peer fails.
    pub fn run<K: DataKind>(
        &mut self,
        data_set: &str,
        subjects: &Subjects<K>,
        progress: &dyn Fn(f64),
    ) -> Result<Table, PeerError> {
        let sample = subjects.sample();
        let mut standings: Vec<Standing> = self
            .contestants
            .iter()
            .map(|_| Standing {
                answers: Vec::new(),
                left: self.budget,
            })
            .collect();
        for (turn, chunk) in sample.chunks(TURN).enumerate() {
            let queries: Vec<Query<K>> = chunk.iter().map(|subject| subject.query).collect();
            for place in 0..standings.len() {
                // Who comes first finds the queries out of the cache.
                let index = (turn + place) % standings.len();
                let standing = &mut standings[index];
                if standing.answers.len() == turn * TURN {
                    let answers = self.contestants[index].answer(&queries, standing.left)?;
                    standing.spend(&answers, queries.len());
                }
                progress(self.done(&standings, &sample));
            }
        }
        let answers: Vec<_> = standings.into_iter().map(|standing| standing.answers).collect();
        Ok(Table::new(
            data_set,
            K::SHORT,
            subjects,
            &sample,
            &self.contestants,
            &answers,
        ))
    }

    /// The part of the work that is done.
    fn done<K>(&self, standings: &[Standing], sample: &[Subject<K>]) -> f64 {
        let done = |standing: &Standing| {
            let answered = standing.answers.len() as f64 / sample.len() as f64;
            let spent = 1.0 - standing.left.as_secs_f64() / self.budget.as_secs_f64();
            answered.max(spent)
        };
        standings.iter().map(done).sum::<f64>() / standings.len() as f64
    }
}

impl Standing {
    /// Takes answers to some queries, or to the first of them, after which the time is up.
    fn spend(&mut self, answers: &[Timed], asked: usize) {
        let spent: f64 = answers.iter().map(|timed| timed.nanoseconds).sum();
        self.left = self.left.saturating_sub(Duration::from_nanos(spent as u64));
        if answers.len() < asked {
            self.left = Duration::ZERO;
        }
        self.answers.extend(answers);
    }
}
