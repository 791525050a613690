//! The method of this project: [`Query::contact_times`](exact_ccd::Query::contact_times).

use exact_ccd::{EdgeEdge, Kind, Query, VertexFace};

use crate::method::{Answer, Method, Promise, Time};

/// The exact decision, with the earliest contact rounded down to f64.
#[derive(Clone, Copy, Debug, Default)]
pub struct Exact;

fn answer<K: Kind>(query: &Query<K>) -> Answer {
    Answer::from_time(query.time_of_impact())
}

impl Method for Exact {
    fn name(&self) -> &str {
        "exact"
    }

    fn promise(&self) -> Promise {
        Promise {
            may_miss: false,
            may_invent: false,
            time: Time::Exact,
        }
    }

    fn vertex_face(&self, query: &Query<VertexFace>) -> Answer {
        answer(query)
    }

    fn edge_edge(&self, query: &Query<EdgeEdge>) -> Answer {
        answer(query)
    }
}
