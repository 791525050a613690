//! The exact filter.

use ccd_mesh::Point;
use exact_ccd::{ContactTime, Kind, Query};

use super::StepFilter;
use super::increment::Increment;

/// The exact time of impact of the full step, and the exact decision of the step that is taken.
#[derive(Clone, Copy, Debug, Default)]
pub struct Exact;

impl StepFilter for Exact {
    fn name(&self) -> &'static str {
        "exact"
    }

    fn largest(&self, increment: &Increment<'_>) -> f64 {
        increment.earliest(time_of_impact, time_of_impact).unwrap_or(1.0)
    }

    fn is_free(&self, increment: &Increment<'_>, end: &[Point]) -> bool {
        let step = increment.between(increment.start(), end);
        step.is_free(Query::collides, Query::collides)
    }
}

/// The earliest contact time, rounded down.
fn time_of_impact<K: Kind>(query: &Query<K>) -> Option<f64> {
    // To decide is cheaper, and most do not touch.
    let times = query.collides().then(|| query.contact_times())?;
    times.first().map(ContactTime::lower)
}
