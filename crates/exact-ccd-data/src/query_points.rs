//! The points of a query in the order of query files.

use exact_ccd::{Kind, NonFinite, Point, Query};

/// The points of a query in the order of the files: all at t = 0, then all at t = 1.
pub(crate) fn points<K: Kind>(query: &Query<K>) -> impl Iterator<Item = Point> {
    query.points().iter().flat_map(AsRef::as_ref).copied()
}

/// The query of these points, in the order of [`points`].
///
/// # Errors
/// [`NonFinite`] names the first coordinate that is infinite or not a number.
///
/// # Panics
/// If the kind has another number of points.
pub(crate) fn query<K: Kind>(points: &[Point]) -> Result<Query<K>, NonFinite> {
    let (start, end) = points.split_at(K::KIND.point_names().len());
    let [t0, t1] = [start, end].map(|points| {
        let mut all = K::Points::default();
        all.as_mut().copy_from_slice(points);
        all
    });
    Query::new(t0, t1)
}

#[cfg(test)]
mod tests {
    use exact_ccd::{EdgeEdge, VertexEdge, VertexFace, VertexVertex};

    use super::*;

    fn assert_inverse<K: Kind + PartialEq>(count: usize) {
        let row = |i: usize| [0.0, 1.0, 2.0].map(|axis| 3.0 * i as f64 + axis);
        let rows: Vec<Point> = (0..2 * count).map(row).collect();
        let query = query::<K>(&rows).unwrap();
        assert_eq!(points(&query).collect::<Vec<_>>(), rows, "{}", K::KIND.short());
    }

    #[test]
    fn each_point_of_a_query_is_one_row() {
        assert_inverse::<VertexFace>(4);
        assert_inverse::<EdgeEdge>(4);
        assert_inverse::<VertexEdge>(3);
        assert_inverse::<VertexVertex>(2);
    }
}
