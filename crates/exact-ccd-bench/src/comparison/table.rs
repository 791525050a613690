//! What a comparison finds on one data set.

use exact_ccd::Kind;
use exact_ccd_methods::Answer;
use serde::Serialize;

use super::contestant::{Contestant, Timed};
use super::sampling::{Subject, Subjects};

/// The answers of all contestants on one data set and kind of query.
#[derive(Clone, Debug, Serialize)]
#[non_exhaustive]
pub struct Table {
    /// The name of the data set.
    pub data_set: String,
    /// `vf` or `ee`.
    pub kind: &'static str,
    /// How many queries the data set has.
    pub queries: usize,
    /// How many of them collide.
    pub colliding: usize,
    /// How many of these are in the sample, and how many of the others.
    pub sample: Sizes,
    /// A row for each contestant.
    pub rows: Vec<Row>,
}

/// How many queries collide, and how many do not.
#[derive(Clone, Copy, Debug, Serialize, PartialEq, Eq)]
pub struct Sizes {
    /// Those that collide.
    pub colliding: usize,
    /// Those that do not.
    pub free: usize,
}

/// The answers of one contestant. Times are in microseconds.
#[derive(Clone, Debug, Serialize)]
#[non_exhaustive]
pub struct Row {
    /// The name of the method.
    pub method: String,
    /// How many queries it answered before its time was up.
    pub answered: Sizes,
    /// The mean time, each class weighed by its share of the data set; the paper's T.
    pub mean: Option<f64>,
    /// The mean time on queries that collide; the paper's TP.
    pub mean_colliding: Option<f64>,
    /// The mean time on those that do not; the paper's TN.
    pub mean_free: Option<f64>,
    /// The time that half of the queries take at most, each class weighed as in the mean.
    pub median: Option<f64>,
    /// The time that 99 % take at most.
    pub percentile_99: Option<f64>,
    /// The longest.
    pub worst: Option<f64>,
    /// How many queries that do not collide it says do.
    pub false_positives: usize,
    /// How many queries that collide it says do not.
    pub false_negatives: usize,
    /// How far its times of impact are from the true ones, if it tells any.
    pub time_error: Option<TimeError>,
    /// Time, and share of the data set that took as long, by increasing time.
    #[serde(skip)]
    pub(super) distribution: Vec<(f64, f64)>,
}

/// How far times of impact, in units of the time step, are from the true ones.
#[derive(Clone, Copy, Debug, Serialize, PartialEq)]
pub struct TimeError {
    /// Of half of them, at most.
    pub median: f64,
    /// The largest.
    pub worst: f64,
    /// How many are after the true time: a step of this length ends in contact.
    pub late: usize,
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
    /// The answers are to the first subjects.
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
                subject.collides == collides && timed.answer.is_contact() != collides
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
            time_error: time_error(judged().map(|(subject, timed)| (subject.first, timed.answer))),
            distribution,
        }
    }
}

fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// The mean over the data set; `None` if no query was answered of a class of which it has some.
fn weighted_mean(population: [usize; 2], means: [Option<f64>; 2]) -> Option<f64> {
    let total: usize = population.iter().sum();
    let mut weighted = 0.0;
    for (count, mean) in population.into_iter().zip(means) {
        if count > 0 {
            weighted += mean? * count as f64 / total as f64;
        }
    }
    (total > 0).then_some(weighted)
}

/// The times of both classes in order, each with its share of the data set; none if a class was not answered.
fn distribution(population: [usize; 2], times: &[Vec<f64>; 2]) -> Vec<(f64, f64)> {
    if population
        .iter()
        .zip(times)
        .any(|(&count, times)| count > 0 && times.is_empty())
    {
        return Vec::new();
    }
    let mut all: Vec<_> = population
        .iter()
        .zip(times)
        .flat_map(|(&count, times)| {
            let weight = count as f64 / times.len() as f64;
            times.iter().map(move |&time| (time, weight))
        })
        .collect();
    all.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let total: f64 = all.iter().map(|(_, weight)| weight).sum();
    all.iter_mut().for_each(|(_, weight)| *weight /= total);
    all
}

fn quantile(distribution: &[(f64, f64)], share: f64) -> Option<f64> {
    let mut below = 0.0;
    let reaches = |(_, weight): &&(f64, f64)| {
        below += weight;
        below >= share
    };
    distribution
        .iter()
        .find(reaches)
        .or(distribution.last())
        .map(|(time, _)| *time)
}

fn time_error(answers: impl Iterator<Item = (Option<f64>, Answer)>) -> Option<TimeError> {
    // The true time is rounded down: only what is above the next f64 is late for certain.
    let told: Vec<[f64; 2]> = answers
        .filter_map(|(first, answer)| first.zip(answer.time()))
        .map(|(first, time)| [first, time])
        .collect();
    let mut errors: Vec<f64> = told.iter().map(|[first, time]| (time - first).abs()).collect();
    errors.sort_by(f64::total_cmp);
    Some(TimeError {
        median: *errors.get(errors.len() / 2)?,
        worst: *errors.last()?,
        late: told
            .iter()
            .filter(|[first, time]| *time > first.next_up())
            .count(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn classes_count_by_their_share_of_the_data_set() {
        let distribution = distribution([90, 10], &[vec![1.0, 2.0, 3.0], vec![100.0]]);
        assert_eq!(quantile(&distribution, 0.29), Some(1.0));
        assert_eq!(quantile(&distribution, 0.5), Some(2.0));
        assert_eq!(quantile(&distribution, 0.89), Some(3.0));
        assert_eq!(quantile(&distribution, 0.99), Some(100.0));
        assert_eq!(quantile(&[], 0.5), None);
        assert_eq!(weighted_mean([90, 10], [Some(2.0), Some(100.0)]), Some(11.8));
        assert_eq!(weighted_mean([90, 10], [Some(2.0), None]), None);
        assert_eq!(weighted_mean([90, 0], [Some(2.0), None]), Some(2.0));
    }

    #[test]
    fn a_time_after_the_first_contact_is_late() {
        let at = |time| Answer::Contact { time: Some(time) };
        let error = time_error(
            [
                (Some(0.5), at(0.25)),
                (Some(0.5), at(0.5f64.next_up())),
                (Some(0.5), at(0.625)),
                (Some(0.5), Answer::Free),
                (None, at(0.0)),
            ]
            .into_iter(),
        );
        let expected = TimeError {
            median: 0.125,
            worst: 0.25,
            late: 1,
        };
        assert_eq!(error, Some(expected));
        assert_eq!(time_error([(Some(0.5), Answer::Free)].into_iter()), None);
    }
}
