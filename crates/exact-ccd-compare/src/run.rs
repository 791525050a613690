//! A comparison, data set by data set.

use std::time::Duration;

use exact_ccd::{Ccd, Decide, Kind, Query};
use exact_ccd_data::DataKind;

use crate::contestant::Contestant;
use crate::peer::PeerError;
use crate::sampling::{Subject, Subjects};
use crate::table::Table;
use crate::timed::Timed;

/// A comparison of contestants with the same time budget.
pub struct Comparison {
    contestants: Vec<Contestant>,
    budget: Duration,
    /// The contestants that have failed. They receive no more queries.
    failures: Vec<(usize, PeerError)>,
}

/// The number of queries that a contestant answers in one turn.
const TURN: usize = 128;

/// The answers of a contestant to the queries of a data set, and the rest of its budget.
struct Standing {
    answers: Vec<Timed>,
    left: Duration,
}

impl Comparison {
    /// Each contestant answers the queries of a data set one after the other until it has spent its
    /// budget of time on them.
    #[must_use]
    pub fn new(contestants: Vec<Contestant>, budget: Duration) -> Self {
        Self {
            contestants,
            budget,
            failures: Vec::new(),
        }
    }

    /// The contestants.
    #[must_use]
    pub fn contestants(&self) -> &[Contestant] {
        &self.contestants
    }

    /// The peers that have failed, by name, in the order of their failures.
    pub fn failures(&self) -> impl ExactSizeIterator<Item = (&str, &PeerError)> {
        self.failures
            .iter()
            .map(|(index, error)| (self.contestants[*index].name(), error))
    }

    /// Runs all contestants on the sample of a data set. They take turns, so that the load of the
    /// machine is the same for all of them. `progress` is called from time to time with the part of
    /// the work that is done.
    ///
    /// A peer that [fails](Self::failures) receives no more queries, in this data set and later ones.
    pub fn run<K: DataKind>(
        &mut self,
        data_set: &str,
        subjects: &Subjects<K>,
        progress: &dyn Fn(f64),
    ) -> Table
    where
        dyn Ccd: Decide<K>,
    {
        let sample = subjects.sample();
        let mut standings: Vec<Standing> = (0..self.contestants.len())
            .map(|index| Standing {
                answers: Vec::new(),
                left: if self.has_failed(index) {
                    Duration::ZERO
                } else {
                    self.budget
                },
            })
            .collect();
        for (turn, chunk) in sample.chunks(TURN).enumerate() {
            let queries: Vec<Query<K>> = chunk.iter().map(|subject| subject.query).collect();
            for place in 0..standings.len() {
                // For the first contestant of a turn the queries are not in the cache, so the order rotates.
                let index = (turn + place) % standings.len();
                let standing = &mut standings[index];
                if standing.answers.len() == turn * TURN && !self.has_failed(index) {
                    match self.contestants[index].answer(&queries, standing.left) {
                        Ok(answers) => standing.spend(&answers, queries.len()),
                        Err(error) => {
                            standing.left = Duration::ZERO;
                            self.failures.push((index, error));
                        }
                    }
                }
                progress(self.done(&standings, &sample));
            }
        }
        let answers: Vec<_> = standings.into_iter().map(|standing| standing.answers).collect();
        Table::new(
            data_set,
            K::KIND.short(),
            subjects,
            &sample,
            &self.contestants,
            &answers,
        )
    }

    /// Ends the comparison.
    ///
    /// # Errors
    /// The first failure of a peer.
    pub fn finish(self) -> Result<(), PeerError> {
        self.failures
            .into_iter()
            .next()
            .map_or(Ok(()), |(_, error)| Err(error))
    }

    fn has_failed(&self, contestant: usize) -> bool {
        self.failures.iter().any(|(index, _)| *index == contestant)
    }

    /// The part of the work that is done.
    fn done<K: Kind>(&self, standings: &[Standing], sample: &[Subject<K>]) -> f64 {
        let done = |standing: &Standing| {
            let answered = standing.answers.len() as f64 / sample.len() as f64;
            let spent = 1.0 - standing.left.as_secs_f64() / self.budget.as_secs_f64();
            answered.max(spent)
        };
        standings.iter().map(done).sum::<f64>() / standings.len() as f64
    }
}

impl Standing {
    /// Adds the answers to the first of `requested` queries. Fewer answers than queries use up the time.
    fn spend(&mut self, answers: &[Timed], requested: usize) {
        let spent: f64 = answers.iter().map(|timed| timed.nanoseconds).sum();
        self.left = self.left.saturating_sub(Duration::from_nanos(spent as u64));
        if answers.len() < requested {
            self.left = Duration::ZERO;
        }
        self.answers.extend(answers);
    }
}
