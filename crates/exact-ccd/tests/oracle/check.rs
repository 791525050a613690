//! The answers of the crate, by all paths, are those of the definition.

use exact_ccd::batch::Trajectories;
use exact_ccd::separation::Separation;
use exact_ccd::{
    ContactTime, ContactTimes, EdgeEdge, Kind, Point, Query, VertexEdge, VertexFace, VertexVertex, exact,
};

use crate::definition::{self, Moment, Primitives};

/// A kind of query that the definition knows.
pub(crate) trait Defined: Kind {
    const PRIMITIVES: Primitives;
    /// The points of the primitives among the four of a query.
    const POINTS: &'static [usize];
}

impl Defined for VertexFace {
    const PRIMITIVES: Primitives = Primitives::VertexFace;
    const POINTS: &'static [usize] = &[0, 1, 2, 3];
}

impl Defined for EdgeEdge {
    const PRIMITIVES: Primitives = Primitives::EdgeEdge;
    const POINTS: &'static [usize] = &[0, 1, 2, 3];
}

impl Defined for VertexEdge {
    const PRIMITIVES: Primitives = Primitives::VertexEdge;
    const POINTS: &'static [usize] = &[0, 2, 3];
}

impl Defined for VertexVertex {
    const PRIMITIVES: Primitives = Primitives::VertexVertex;
    const POINTS: &'static [usize] = &[0, 2];
}

fn points<K: Defined>(query: &Query<K>) -> [Vec<Point>; 2] {
    query
        .points()
        .map(|now| K::POINTS.iter().map(|&i| now[i]).collect())
}

fn truth<K: Defined>(query: &Query<K>, d: f64) -> Vec<([Moment; 2], bool)> {
    let [start, end] = points(query);
    definition::intervals(K::PRIMITIVES, [&start, &end], d)
}

fn moment(time: ContactTime) -> Moment {
    (time.lower(), time.is_exact())
}

/// The earliest contact of a batch of one query.
fn first_of_batch<K: Defined>(query: &Query<K>, d: Separation) -> Option<Moment> {
    let [start, end] = points(query);
    let mut vertices = K::Vertices::default();
    (0..).zip(vertices.as_mut()).for_each(|(i, vertex)| *vertex = i);
    let trajectories = Trajectories::new(&start, &end).expect("the points are finite");
    let mut first = None;
    let found = |_: usize, collision: exact_ccd::Collision<'_, K>| {
        first = Some(moment(collision.first_contact_time()));
    };
    let result = trajectories.collisions_within::<K>(&[vertices], d.into(), found);
    result.expect("the vertices exist");
    first
}

/// Compares contact, all contact times, and the earliest of a batch; returns true for contact.
pub(crate) fn assert_contact<K: Defined>(query: &Query<K>) -> bool {
    let truth = truth(query, 0.0);
    let first = truth.first().map(|(ends, _)| ends[0]);
    let is_finite = truth.iter().all(|(_, is_moment)| *is_moment);
    for times in [query.contact_times(), exact::contact_times(query)] {
        assert_eq!(times.first().map(moment), first, "{query:?}");
        match times {
            ContactTimes::Finite(times) => {
                assert!(is_finite, "{query:?}");
                let times: Vec<Moment> = times.iter().map(|&time| moment(time)).collect();
                let truth: Vec<Moment> = truth.iter().map(|(ends, _)| ends[0]).collect();
                assert_eq!(times, truth, "{query:?}");
            }
            ContactTimes::Interval { .. } => assert!(!is_finite, "{query:?}"),
        }
    }
    assert_eq!(query.collides(), first.is_some(), "{query:?}");
    assert_eq!(exact::collides(query), first.is_some(), "{query:?}");
    assert_eq!(query.time_of_impact(), first.map(|time| time.0), "{query:?}");
    assert_eq!(first_of_batch(query, Separation::default()), first, "{query:?}");
    first.is_some()
}

/// Compares the decision within d, its intervals, and the first time, also of a batch; returns true if the
/// primitives come within d.
pub(crate) fn assert_within<K: Defined>(query: &Query<K>, d: Separation) -> bool {
    let truth: Vec<[Moment; 2]> = truth(query, d.get()).iter().map(|(ends, _)| *ends).collect();
    let first = truth.first().map(|ends| ends[0]);
    for intervals in [
        query.intervals_within(d),
        exact::separation::intervals_within(query, d),
    ] {
        let ends: Vec<_> = intervals
            .iter()
            .map(|interval| [moment(interval.start), moment(interval.end)])
            .collect();
        assert_eq!(ends, truth, "{d:?}: {query:?}");
    }
    let firsts = [query.first_within(d), exact::separation::first_within(query, d)];
    assert_eq!(
        firsts.map(|time| time.map(moment)),
        [first; 2],
        "{d:?}: {query:?}"
    );
    let decisions = [query.comes_within(d), exact::separation::comes_within(query, d)];
    assert_eq!(decisions, [first.is_some(); 2], "{d:?}: {query:?}");
    assert_eq!(first_of_batch(query, d), first, "{d:?}: {query:?}");
    first.is_some()
}
