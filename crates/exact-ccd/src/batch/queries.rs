//! The queries of a batch, and where those are passed on that touch.

use super::row::Row;
use crate::collision::Collision;
use crate::kind::Kind;
use crate::query::Query;
use crate::values::{Options, Separations};

/// The callback for collisions. Behind a pointer: contacts are few, and the vector code is compiled
/// only once for all callbacks.
pub(super) type Found<'f, K> = &'f mut dyn for<'a> FnMut(usize, Collision<'a, K>);

/// The queries that are passed on, in order.
pub(super) enum Passed<'f, K: Kind> {
    /// Each that collides.
    Colliding(Found<'f, K>),
    /// Each that the first filters do not prove to stay beyond its separation, by its index.
    Unsettled(&'f mut dyn FnMut(usize)),
}

/// A batch of one kind: queries of rows, of which those are passed on that first touch at a time not above
/// `until`, or may do so. All indices of rows exist.
#[expect(
    unnameable_types,
    reason = "an argument of a hidden function of a sealed trait"
)]
pub struct Batch<'a, K: Kind> {
    pub(super) rows: &'a [Row],
    pub(super) queries: &'a [K::Vertices],
    pub(super) separations: Separations<'a>,
    pub(super) until: f64,
    pub(super) passed: Passed<'a, K>,
}

impl<K: Kind> Batch<'_, K> {
    /// Passes the queries on, each decided by itself.
    pub(super) fn one_by_one(self) {
        match self.passed {
            Passed::Unsettled(unsettled) => (0..self.queries.len()).for_each(unsettled),
            Passed::Colliding(found) => {
                for (index, vertices) in self.queries.iter().enumerate() {
                    let (a, b) = vertices.as_ref().split_at(K::FIRST);
                    let query: Query<K> = query_of(self.rows, vertices);
                    let options = Options::within(self.separations.between(a, b)).until(self.until);
                    if let Some(collision) = query.collision(options) {
                        found(index, collision);
                    }
                }
            }
        }
    }
}

/// The rows of x₀ … x₃.
#[inline(always)]
pub(super) fn rows_of<'a, K: Kind>(rows: &'a [Row], vertices: &K::Vertices) -> [&'a Row; 4] {
    K::LAYOUT.map(|i| &rows[vertices.as_ref()[i] as usize])
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

#[cfg(test)]
mod tests {
    use alloc::vec;
    use alloc::vec::Vec;

    use super::*;
    use crate::tables::VertexVertex;

    fn pass_on<'a>(rows: &'a [Row], queries: &'a [[u32; 2]], passed: Passed<'a, VertexVertex>) {
        let batch = Batch {
            rows,
            queries,
            separations: Separations::default(),
            until: 1.0,
            passed,
        };
        batch.one_by_one();
    }

    #[test]
    fn queries_are_passed_on_one_by_one() {
        let row = |x0: f64, x1: f64| Row::new([x0, 0.0, 0.0], [x1, 0.0, 0.0]);
        let rows = [row(0.0, 0.0), row(1.0, -1.0), row(9.0, 9.0)];
        let queries = [[0, 1], [0, 2], [1, 0]];
        let (mut found, mut unsettled) = (Vec::new(), Vec::new());
        pass_on(
            &rows,
            &queries,
            Passed::Colliding(&mut |index, _| found.push(index)),
        );
        pass_on(
            &rows,
            &queries,
            Passed::Unsettled(&mut |index| unsettled.push(index)),
        );
        assert_eq!((found, unsettled), (vec![0, 2], vec![0, 1, 2]));
    }
}
