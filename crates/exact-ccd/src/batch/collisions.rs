//! The collisions that a batch finds, with their queries.

use crate::collision::Collision;
use crate::decided::Decided;
use crate::kind::Kind;
use crate::query::Query;
use crate::tables::Points;
use crate::vectors::Row;

/// A function of collisions as one of what was decided about the queries of a batch.
pub(super) fn with_queries<'a, K: Kind>(
    rows: &'a [Row],
    queries: &'a [K::Vertices],
    mut found: impl FnMut(usize, Collision<'_, K>) + 'a,
) -> impl FnMut(usize, &Points<f64>, Decided<K>) + 'a {
    move |index, _, decided| {
        let query = query_of(rows, &queries[index]);
        found(index, Collision::new(&query, decided));
    }
}

/// The query of vertices whose rows exist, with finite coordinates.
pub(super) fn query_of<K: Kind>(rows: &[Row], vertices: &K::Vertices) -> Query<K> {
    let mut points = [K::Points::default(); 2];
    for (i, &vertex) in vertices.as_ref().iter().enumerate() {
        let ends = rows[vertex as usize].points();
        for (points, end) in points.iter_mut().zip(ends) {
            points.as_mut()[i] = end;
        }
    }
    Query::from_finite(points)
}
