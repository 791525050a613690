//! The answers of the crate, by all paths, agree with the definition.

use exact_ccd::batch::Trajectories;
use exact_ccd::{Kind, Point, Query, Separation};

use crate::definition::{self, Moment, found, moment};

fn points<K: Kind>(query: &Query<K>) -> [Vec<Point>; 2] {
    query.points().map(|now| now.as_ref().to_vec())
}

/// The first time of a batch of one query.
fn first_of_batch<K: Kind>(query: &Query<K>, d: Separation) -> Option<Moment> {
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
pub fn assert_defined<K: Kind>(query: &Query<K>, d: Separation) -> bool {
    let [start, end] = points(query);
    let truth = definition::intervals(K::KIND, [&start, &end], d.get());
    let first = truth.first().map(|(ends, _)| ends[0]);
    for intervals in [query.intervals(d), query.exactly().intervals(d)] {
        assert_eq!(found(&intervals), truth, "{d:?}: {query:?}");
    }
    let lower = first.map(|(lower, _)| lower);
    let times = [query.time_of_impact(d), query.exactly().time_of_impact(d)];
    assert_eq!(times, [lower; 2], "{d:?}: {query:?}");
    let decisions = [query.collides(d), query.exactly().collides(d)];
    assert_eq!(decisions, [first.is_some(); 2], "{d:?}: {query:?}");
    assert_eq!(first_of_batch(query, d), first, "{d:?}: {query:?}");
    first.is_some()
}
