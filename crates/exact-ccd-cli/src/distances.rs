//! The distances in the reports of steps and audits.

use std::fmt;

use exact_ccd::{DistanceBounds, Separation};
use exact_ccd_mesh::MinDistance;
use serde::Serialize;

use crate::shortest::shortest;

/// The distances within which pairs touch, as a part of a JSON object.
#[derive(Clone, Copy, Serialize)]
pub(crate) struct Distances {
    min_distance: f64,
    /// That of pairs that start within the minimum distance, if it is another one.
    #[serde(skip_serializing_if = "Option::is_none")]
    inner_distance: Option<f64>,
}

/// Bounds of the distance that a pair has reached, as a JSON object.
#[derive(Clone, Copy, Default, Serialize)]
pub(crate) struct Reached {
    pub(crate) lower: f64,
    pub(crate) upper: f64,
}

impl Distances {
    pub(crate) fn new(min_distance: Separation, inner_distance: Option<Separation>) -> Self {
        Self {
            min_distance: min_distance.get(),
            inner_distance: inner_distance.map(Separation::get),
        }
    }

    /// Returns true if pairs touch only at contact.
    pub(crate) fn are_zero(&self) -> bool {
        self.min_distance == 0.0
    }
}

/// The distances of a mesh in which one holds for all pairs, or another one for those that start within it.
pub(crate) fn kept(min_distance: Separation, inner_distance: Option<Separation>) -> MinDistance {
    let kept = MinDistance::uniform(min_distance);
    match inner_distance {
        Some(inner) => kept.with_inner(inner),
        None => kept,
    }
}

impl From<DistanceBounds> for Reached {
    fn from(DistanceBounds { lower, upper }: DistanceBounds) -> Self {
        Self { lower, upper }
    }
}

/// A line of text.
impl fmt::Display for Distances {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "minimum distance: {}", shortest(self.min_distance))?;
        match self.inner_distance {
            Some(inner) => write!(f, ", and {} for pairs that start within it", shortest(inner)),
            None => Ok(()),
        }
    }
}

/// The end of the text of a pair; empty for contact.
impl fmt::Display for Reached {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [lower, upper] = [self.lower, self.upper].map(shortest);
        if self.upper == 0.0 {
            Ok(())
        } else if self.lower == self.upper {
            write!(f, ", {lower} apart")
        } else {
            write!(f, ", between {lower} and {upper} apart")
        }
    }
}
