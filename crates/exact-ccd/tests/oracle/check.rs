//! The answers of the crate, by all paths, are those of the definition.

use exact_ccd::batch::Trajectories;
use exact_ccd::{
    ContactTime, EdgeEdge, Interval, Kind, Point, Query, Separation, VertexEdge, VertexFace, VertexVertex,
};

use crate::definition::{self, Moment, Primitives};

/// A kind of query that the definition knows.
pub(crate) trait Defined: Kind {
    const PRIMITIVES: Primitives;
}

impl Defined for VertexFace {
    const PRIMITIVES: Primitives = Primitives::VertexFace;
}

impl Defined for EdgeEdge {
    const PRIMITIVES: Primitives = Primitives::EdgeEdge;
}

impl Defined for VertexEdge {
    const PRIMITIVES: Primitives = Primitives::VertexEdge;
}

impl Defined for VertexVertex {
    const PRIMITIVES: Primitives = Primitives::VertexVertex;
}

fn points<K: Defined>(query: &Query<K>) -> [Vec<Point>; 2] {
    query.points().map(|now| now.as_ref().to_vec())
}

fn moment(time: ContactTime) -> Moment {
    (time.lower(), time.is_exact())
}

/// The first time of a batch of one query.
fn first_of_batch<K: Defined>(query: &Query<K>, d: Separation) -> Option<Moment> {
    let [start, end] = points(query);
    let mut vertices = K::Vertices::default();
    (0..).zip(vertices.as_mut()).for_each(|(i, vertex)| *vertex = i);
    let trajectories = Trajectories::new(&start, &end).expect("the points are finite");
    let mut first = None;
    let result = trajectories.collisions::<K>(&[vertices], d, |_, collision| {
        first = Some(moment(collision.time()));
    });
    result.expect("the vertices exist");
    first
}

/// Compares the decision, all times of touching, and the first one, also of a batch; returns true if there
/// are any.
pub(crate) fn assert_defined<K: Defined>(query: &Query<K>, d: Separation) -> bool {
    let [start, end] = points(query);
    let truth = definition::intervals(K::PRIMITIVES, [&start, &end], d.get());
    let first = truth.first().map(|(ends, _)| ends[0]);
    for intervals in [query.intervals(d), query.exactly().intervals(d)] {
        let found: Vec<_> = intervals
            .into_iter()
            .map(
                |Interval {
                     start,
                     end,
                     is_moment,
                 }| ([moment(start), moment(end)], is_moment),
            )
            .collect();
        assert_eq!(found, truth, "{d:?}: {query:?}");
    }
    let lower = first.map(|(lower, _)| lower);
    let times = [query.time_of_impact(d), query.exactly().time_of_impact(d)];
    assert_eq!(times, [lower; 2], "{d:?}: {query:?}");
    let decisions = [query.collides(d), query.exactly().collides(d)];
    assert_eq!(decisions, [first.is_some(); 2], "{d:?}: {query:?}");
    assert_eq!(first_of_batch(query, d), first, "{d:?}: {query:?}");
    first.is_some()
}
