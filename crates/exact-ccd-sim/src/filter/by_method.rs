//! Any method of [`exact_ccd_methods`] as a filter.

use std::sync::Arc;

use exact_ccd::{Ccd, EdgeEdge, Query, TimeGuarantee, VertexFace};
use exact_ccd_mesh::{Decision, Point};

use super::bisection::Bisection;
use super::increment::Increment;
use super::{LAST, StepFilter};

/// A method of [`exact_ccd_methods`]: by its times of impact, if it has times, else by [`Bisection`] with its decision.
///
/// A method with [false negatives](exact_ccd::Guarantees::false_negatives) lets contacts pass.
pub struct ByMethod {
    method: DecidingMethod,
    bisection: Bisection,
}

impl ByMethod {
    /// The filter of a method, by a name.
    #[must_use]
    pub fn new(name: &str, method: Box<dyn Ccd>) -> Self {
        let method = DecidingMethod(method.into());
        let bisection = Bisection::new(name, Box::new(method.clone()));
        Self { method, bisection }
    }
}

impl StepFilter for ByMethod {
    fn name(&self) -> &str {
        self.bisection.name()
    }

    fn largest(&self, increment: &Increment<'_>) -> f64 {
        let DecidingMethod(method) = &self.method;
        if method.guarantees().time == TimeGuarantee::Absent {
            return self.bisection.largest(increment);
        }
        let clamped = |time: Option<f64>| time.map(|time| time.clamp(0.0, LAST));
        let earliest = increment.earliest(
            |query| clamped(method.time_of_impact(query)),
            |query| clamped(method.time_of_impact(query)),
        );
        match earliest {
            None => 1.0,
            Some(time) if time > 0.0 => time,
            // A conservative time of 0 means no more than that there is a contact.
            Some(_) => self.bisection.largest(increment),
        }
    }

    fn is_free(&self, increment: &Increment<'_>, end: &[Point]) -> bool {
        self.bisection.is_free(increment, end)
    }
}

/// The decision of a method.
#[derive(Clone)]
struct DecidingMethod(Arc<dyn Ccd>);

impl Decision for DecidingMethod {
    fn vertex_face(&self, query: &Query<VertexFace>) -> bool {
        self.0.collides(query)
    }
}

    fn edge_edge(&self, query: &Query<EdgeEdge>) -> bool {
        self.0.collides(query)
    }
}

impl Ccd for DecidingMethod {
    fn name(&self) -> &str {
        self.0.name()
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: self.0.promise().may_miss,
            false_positives: self.0.promise().may_invent,
            time: TimeGuarantee::Absent,
        }
    }
}
