//! The parity of a query by the definition of contact: smaller queries on the boundary of the
//! domain, and the roots in its interior, counted with multiplicity.
//!
//! If the four points are always coplanar, the edges parallel or the face flat, contact holds for a
//! line of parameters or for an interval of time, and reaches the boundary. All other contact is at
//! roots of the coplanarity, and counts with their multiplicity.

mod double_root;
pub mod integers;
pub mod laws;

use exact_ccd::{CONTACT, EdgeEdge, Kind, Point, Query, VertexFace};
use exact_ccd_methods::parity::Parity;

use double_root::double_root;

/// The vertices and edges of a kind of query that meet on the boundary of (u, v).
pub trait Rim: Kind<Points = [Point; 4]> {
    /// A vertex, and the ends of an edge of the other primitive.
    const MEETINGS: &'static [[usize; 3]];
}

impl Rim for VertexFace {
    const MEETINGS: &'static [[usize; 3]] = &[[0, 1, 2], [0, 2, 3], [0, 3, 1]];
}

impl Rim for EdgeEdge {
    const MEETINGS: &'static [[usize; 3]] = &[[0, 2, 3], [1, 2, 3], [2, 0, 1], [3, 0, 1]];
}

/// The parity of the number of contact times, or that a contact is on the boundary of the domain.
pub fn expected<K: Rim>(query: &Query<K>) -> Parity {
    let times = query.exactly().intervals(CONTACT);
    if times.is_empty() {
        return Parity::Even;
    }
    if touches_on_boundary(query) {
        return Parity::Boundary;
    }
    assert!(
        times.count().is_some(),
        "contact that lasts does not reach the boundary: {query:?}"
    );
    let grazes =
        double_root(query.points()).is_some_and(|root| times.iter().any(|moment| root.may_be(moment.start)));
    if (times.len() + usize::from(grazes)).is_multiple_of(2) {
        Parity::Even
    } else {
        Parity::Odd
    }
}

/// Returns true if there is a contact at an end of the step, or of a vertex with an edge.
fn touches_on_boundary<K: Rim>(query: &Query<K>) -> bool {
    let is_met = |[vertex, x, y]: &[usize; 3]| {
        let [start, end] = query
            .points()
            .map(|now| [now[*vertex], now[*vertex], now[*x], now[*y]]);
        Query::<EdgeEdge>::new(start, end).unwrap().collides(CONTACT)
    };
    let touches_at = |now: &[Point; 4]| Query::<K>::new(*now, *now).unwrap().collides(CONTACT);
    query.points().iter().any(touches_at) || K::MEETINGS.iter().any(is_met)
}
