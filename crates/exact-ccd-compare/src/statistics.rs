//! Statistics of times over a sample whose classes are weighted by their shares of the data set.

use serde::Serialize;

/// The errors of times of impact, in units of the time step.
#[derive(Clone, Copy, Debug, Serialize, PartialEq)]
pub struct TimeError {
    /// The median of the absolute errors.
    pub median: f64,
    /// The largest absolute error.
    pub worst: f64,
    /// The number of times after the true one: a step of this length ends in contact.
    pub late: usize,
}

/// The arithmetic mean; `None` if there are no values.
pub(super) fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// The mean over a data set from the means over its two classes and their sizes. `None` if the data
/// set is empty, or if a class that is not empty has no mean.
pub(super) fn weighted_mean(population: [usize; 2], means: [Option<f64>; 2]) -> Option<f64> {
    let total: usize = population.iter().sum();
    let mut weighted = 0.0;
    for (count, mean) in population.into_iter().zip(means) {
        if count > 0 {
            weighted += mean? * count as f64 / total as f64;
        }
    }
    (total > 0).then_some(weighted)
}

/// The times of both classes in increasing order, each with its share of the data set. Empty if a
/// class of the data set has no time.
pub(super) fn distribution(population: [usize; 2], times: &[Vec<f64>; 2]) -> Vec<(f64, f64)> {
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

/// The least time that is not exceeded by this share of a distribution.
pub(super) fn quantile(distribution: &[(f64, f64)], share: f64) -> Option<f64> {
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

impl TimeError {
    /// The errors of pairs of a true time and an answer. Either can be missing. `None` if no pair is
    /// complete.
    pub(super) fn new(times: impl Iterator<Item = (Option<f64>, Option<f64>)>) -> Option<Self> {
        let pairs: Vec<(f64, f64)> = times.filter_map(|(first, time)| first.zip(time)).collect();
        let mut errors: Vec<f64> = pairs.iter().map(|(first, time)| (time - first).abs()).collect();
        errors.sort_by(f64::total_cmp);
        Some(Self {
            median: *errors.get(errors.len() / 2)?,
            worst: *errors.last()?,
            // The true time is rounded down: only a time above the next f64 is late for certain.
            late: pairs
                .iter()
                .filter(|(first, time)| *time > first.next_up())
                .count(),
        })
    }
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
        let error = TimeError::new(
            [
                (Some(0.5), Some(0.25)),
                (Some(0.5), Some(0.5f64.next_up())),
                (Some(0.5), Some(0.625)),
                (Some(0.5), None),
                (None, Some(0.0)),
            ]
            .into_iter(),
        );
        let expected = TimeError {
            median: 0.125,
            worst: 0.25,
            late: 1,
        };
        assert_eq!(error, Some(expected));
        assert_eq!(TimeError::new([(Some(0.5), None)].into_iter()), None);
    }
}
