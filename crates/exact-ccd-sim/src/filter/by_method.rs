//! Any method of [`exact_ccd_methods`] as a filter.

use exact_ccd::{Ccd, Decide, EdgeEdge, Guarantees, Query, TimeGuarantee, VertexFace};
use exact_ccd_mesh::Point;
use exact_ccd_methods::{Answer, Method, Time};

use super::bisection::Bisection;
use super::increment::Increment;
use super::{LAST, StepFilter};

/// A method of [`exact_ccd_methods`]: by the times that it tells, if it does, else by [`Bisection`] with what it decides.
///
/// It is worth what the method's [`Promise`](exact_ccd_methods::Promise) is: a method that may miss contacts lets them pass.
pub struct ByMethod {
    method: DecidingMethod,
    bisection: Bisection,
}

impl ByMethod {
    /// The filter of a method, by a name.
    #[must_use]
    pub fn new(name: &str, method: Box<dyn Method>) -> Self {
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
        if method.promise().time == Time::Absent {
            return self.bisection.largest(increment);
        }
        // Contact at a time that it does not know may be at once.
        let time = |answer: Answer| {
            answer
                .is_contact()
                .then(|| answer.time().unwrap_or(0.0).clamp(0.0, LAST))
        };
        let earliest = increment.earliest(
            |query| time(method.vertex_face(query)),
            |query| time(method.edge_edge(query)),
        );
        match earliest {
            None => 1.0,
            Some(time) if time > 0.0 => time,
            // A conservative time of 0 says no more than that there is contact.
            Some(_) => self.bisection.largest(increment),
        }
    }

    fn is_free(&self, increment: &Increment<'_>, end: &[Point]) -> bool {
        self.bisection.is_free(increment, end)
    }
}

/// What a method decides.
#[derive(Clone)]
struct DecidingMethod(std::sync::Arc<dyn Method>);

impl Decide<VertexFace> for DecidingMethod {
    fn collides(&self, query: &Query<VertexFace>) -> bool {
        self.0.vertex_face(query).is_contact()
    }
}

impl Decide<EdgeEdge> for DecidingMethod {
    fn collides(&self, query: &Query<EdgeEdge>) -> bool {
        self.0.edge_edge(query).is_contact()
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
