//! The results of a comparison on one data set.

use exact_ccd::Kind;
use serde::Serialize;

use crate::contestant::Contestant;
use crate::sampling::{Subject, Subjects};
use crate::statistics::{TimeError, distribution, mean, quantile, weighted_mean};
use crate::timed::Timed;

/// The answers of all contestants on one data set and kind of query.
#[derive(Clone, Debug, Serialize)]
#[non_exhaustive]
pub struct Table {
    /// The name of the data set.
    pub data_set: String,
    /// `vf` or `ee`.
    pub kind: &'static str,
    /// The number of queries in the data set.
    pub queries: usize,
    /// The number of queries in the data set that collide.
    pub colliding: usize,
    /// The number of queries in the sample.
    pub sample: Sizes,
    /// A row for each contestant.
    pub rows: Vec<Row>,
}

/// Numbers of queries.
#[derive(Clone, Copy, Debug, Serialize, PartialEq, Eq)]
pub struct Sizes {
    /// The number of queries that collide.
    pub colliding: usize,
    /// The number of queries that do not collide.
    pub free: usize,
}

/// The answers of one contestant. Times are in microseconds.
#[derive(Clone, Debug, Serialize)]
#[non_exhaustive]
pub struct Row {
    /// The name of the method.
    pub method: String,
    /// The number of queries that it answered within its time limit.
    pub answered: Sizes,
    /// The mean time, each class weighted by its share of the data set; the paper's T.
    pub mean: Option<f64>,
    /// The mean time on queries that collide; the paper's TP.
    pub mean_colliding: Option<f64>,
    /// The mean time on queries that do not collide; the paper's TN.
    pub mean_free: Option<f64>,
    /// The median time, each class weighted as in the mean.
    pub median: Option<f64>,
    /// The time that 99 % of the queries do not exceed.
    pub percentile_99: Option<f64>,
    /// The longest time.
    pub worst: Option<f64>,
    /// The number of free queries that the method reports as colliding.
    pub false_positives: usize,
    /// The number of colliding queries that the method reports as free.
    pub false_negatives: usize,
    /// The errors of its times of impact, if it has times.
    pub time_error: Option<TimeError>,
    /// Times in increasing order, each with its share of the data set.
    #[serde(skip)]
    pub(super) distribution: Vec<(f64, f64)>,
}

impl Table {
    pub(super) fn new<K: Kind>(
        data_set: &str,
        kind: &'static str,
        subjects: &Subjects<K>,
        sample: &[Subject<K>],
        contestants: &[Contestant],
        answers: &[Vec<Timed>],
    ) -> Self {
        let [free, colliding] = subjects.population();
        let of = |collides: bool| {
            sample
                .iter()
                .filter(|subject| subject.collides == collides)
                .count()
        };
        Self {
            data_set: data_set.to_owned(),
            kind,
            queries: free + colliding,
            colliding,
            sample: Sizes {
                colliding: of(true),
                free: of(false),
            },
            rows: contestants
                .iter()
                .zip(answers)
                .map(|(contestant, answers)| Row::new(contestant.name(), [free, colliding], sample, answers))
                .collect(),
        }
    }
}

impl Row {
    /// The row of a contestant with these answers to the first subjects of the sample.
    fn new<K: Kind>(name: &str, population: [usize; 2], sample: &[Subject<K>], answers: &[Timed]) -> Self {
        let judged = || sample.iter().zip(answers);
        let times = [false, true].map(|collides| {
            let times = judged().filter(move |(subject, _)| subject.collides == collides);
            times
                .map(|(_, timed)| timed.nanoseconds / 1e3)
                .collect::<Vec<_>>()
        });
        let [mean_free, mean_colliding] = [mean(&times[0]), mean(&times[1])];
        let distribution = distribution(population, &times);
        let wrong = |collides: bool| {
            let wrong = |(subject, timed): &(&Subject<K>, &Timed)| {
                subject.collides == collides && timed.collides != collides
            };
            judged().filter(wrong).count()
        };
        Self {
            method: name.to_owned(),
            answered: Sizes {
                colliding: times[1].len(),
                free: times[0].len(),
            },
            mean: weighted_mean(population, [mean_free, mean_colliding]),
            mean_colliding,
            mean_free,
            median: quantile(&distribution, 0.5),
            percentile_99: quantile(&distribution, 0.99),
            worst: times.iter().flatten().copied().reduce(f64::max),
            false_positives: wrong(false),
            false_negatives: wrong(true),
            time_error: TimeError::new(judged().map(|(subject, timed)| (subject.first, timed.time))),
            distribution,
        }
    }
}
