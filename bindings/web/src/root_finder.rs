//! The floating-point root finder beside the exact method.

use exact_ccd::{Decide, InvalidSeparation, Kind, Query, Separation};
use exact_ccd_methods::FloatingPointRootFinder;
use serde::Serialize;

/// A floating-point root finder, with the distance that it counts as contact.
#[derive(Clone, Copy)]
pub(crate) struct RootFinder(FloatingPointRootFinder);

/// Its answer, in the shape of the JSON object.
#[derive(Clone, Copy, Serialize)]
pub(crate) struct Verdict {
    contact: bool,
    /// None without contact, or if it is not finite.
    time: Option<f64>,
}

impl RootFinder {
    pub(crate) fn new(distance: f64) -> Result<Self, InvalidSeparation> {
        let distance = Separation::new(distance)?.get();
        Ok(Self(FloatingPointRootFinder { distance }))
    }

    pub(crate) fn method(&self) -> &FloatingPointRootFinder {
        &self.0
    }
}

impl Verdict {
    pub(crate) fn new(time: Option<f64>) -> Self {
        let contact = time.is_some();
        Self { contact, time }
    }

    /// The answer of a method for queries of one kind.
    pub(crate) fn of<K: Kind>(method: &dyn Decide<K>, query: &Query<K>) -> Self {
        Self::new(method.time_of_impact(query))
    }
}
