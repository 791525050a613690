//! The first time within a distance in integers, and the answers that follow from it.

use alloc::vec::Vec;

use super::feature::Feature;
use super::scaled::Scaled;
use super::{STEP, closest, is_within_at};
use crate::exact::instant::Instant;
use crate::exact::intervals::{Event, Passage, intervals_of};
use crate::exact::points::MovingPoints;
use crate::exact::split::Split;
#[cfg(test)]
use crate::tables::Points;
use crate::tables::Tables;
use crate::values::{ContactTime, Impact, Intervals, Separation};

/// The first time at which the primitives are within d, with the polynomials that it follows from.
#[derive(Clone, Debug)]
pub(crate) struct FirstWithin {
    scaled: Scaled,
    features: Vec<Feature>,
    /// The crossings of each feature; none if the primitives are within d at t = 0.
    crossings: Vec<Crossings>,
    time: ContactTime,
}

impl FirstWithin {
    /// The first time of a query within d, if there is one.
    #[cfg(test)]
    pub(crate) fn of<K: Tables>(points: &Points<f64>, d: Separation) -> Option<Self> {
        Self::along::<K>(&MovingPoints::along(points), d)
    }

    /// The first time within d, if there is one.
    pub(crate) fn along<K: Tables>(points: &MovingPoints, d: Separation) -> Option<Self> {
        let scaled = Scaled::new(points, d);
        let features = scaled.features::<K>();
        let starts = is_within_at(&features, &STEP[0]);
        let crossings = if starts { Vec::new() } else { crossings(&features) };
        let time = if starts {
            ContactTime::exactly(0.0)
        } else {
            // Rounding is monotone: the least of the rounded times is the least time, rounded.
            let times = first_ones(&features, &crossings).map(|instant| instant.round());
            times.min()?
        };
        Some(Self {
            scaled,
            features,
            crossings,
            time,
        })
    }

    /// The first time.
    pub(crate) fn time(&self) -> ContactTime {
        self.time
    }

    /// All times at which the primitives are within d.
    pub(crate) fn intervals(&self) -> Intervals {
        if self.time.is_start() {
            intervals(&self.features, &crossings(&self.features))
        } else {
            intervals(&self.features, &self.crossings)
        }
    }

    /// The closest points at the first time.
    pub(crate) fn impact<K: Tables>(&self) -> Impact {
        let exact = self.time.is_exact();
        let exact = exact.then(|| Instant::At(Split::from_unit(self.time.lower())));
        let earliest = || first_ones(&self.features, &self.crossings).reduce(Instant::earlier);
        // Cannot panic: the first time is a root of an excess unless it is a number.
        let first = exact.or_else(earliest).expect("a first time");
        closest::impact::<K>(&self.scaled, &self.features, &first)
    }
}

fn intervals(features: &[Feature], crossings: &[Crossings]) -> Intervals {
    let pairs = features.iter().zip(crossings);
    let mut events: Vec<_> = pairs
        .flat_map(|(feature, crossings)| crossings.all(feature))
        .collect();
    let ends = STEP.iter().filter(|end| is_within_at(features, end));
    events.extend(ends.map(|end| Event {
        time: Instant::At(end.clone()),
        passage: Passage::Unknown,
    }));
    // The distance is at most d at each of them, and nothing changes between two.
    intervals_of(events, |t| is_within_at(features, t))
}

/// The times of the step at which the excess of a feature vanishes.
#[derive(Clone, Debug)]
struct Crossings {
    /// The first one at which the feature exists.
    first: Option<Event>,
    /// The roots after it; the feature may not exist there.
    later: Vec<Instant>,
}

impl Crossings {
    fn of(feature: &Feature) -> Self {
        let mut roots = feature.roots().into_iter();
        let first = roots.find_map(|root| feature.existing(root));
        Self {
            first,
            later: roots.collect(),
        }
    }

    /// All at which the feature exists, in increasing order.
    fn all(&self, feature: &Feature) -> impl Iterator<Item = Event> {
        let later = self.later.iter().cloned();
        let later = later.filter_map(|root| feature.existing(root));
        self.first.iter().cloned().chain(later)
    }
}

fn crossings(features: &[Feature]) -> Vec<Crossings> {
    features.iter().map(Crossings::of).collect()
}

/// Times within d, among which is the first one after t = 0: the first crossing of each feature, and the end.
fn first_ones(features: &[Feature], crossings: &[Crossings]) -> impl Iterator<Item = Instant> {
    let end = is_within_at(features, &STEP[1]).then(|| Instant::At(STEP[1].clone()));
    let firsts = crossings.iter().filter_map(|crossings| crossings.first.as_ref());
    let firsts = firsts.map(|event| event.time.clone());
    end.into_iter().chain(firsts)
}
