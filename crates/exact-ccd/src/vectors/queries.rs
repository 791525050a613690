//! The queries of a batch, and the callbacks that receive the queries that touch.

use super::row::Row;
use crate::decide::decide;
use crate::decided::Decided;
use crate::tables::{Points, Tables};
use crate::values::{Options, Separation, Separations};

/// The number of queries that go through one filter before the next filter.
pub(crate) const CHUNK: usize = 256;

/// The callback for collisions: the index of a query, its points, and what was decided. Behind a pointer:
/// contacts are few, and the vector code is compiled only once for all callbacks.
pub(super) type Found<'f, K> = &'f mut dyn FnMut(usize, &Points<f64>, Decided<K>);

/// The queries that are passed on, in order.
pub(crate) enum Passed<'f, K: Tables> {
    /// Each that collides.
    Colliding(Found<'f, K>),
    /// Each that the first filters do not prove to stay beyond its separation, by its index.
    Unsettled(&'f mut dyn FnMut(usize)),
}

/// A batch of one kind. It passes on the queries that first touch at a time not above `until`, or may do so.
/// All indices of rows exist.
#[expect(
    unnameable_types,
    reason = "an argument of a hidden function of a sealed trait"
)]
pub struct Batch<'a, K: Tables, V> {
    pub(crate) rows: &'a [Row],
    pub(crate) queries: &'a [V],
    pub(crate) separations: Separations<'a>,
    pub(crate) until: f64,
    pub(crate) passed: Passed<'a, K>,
}

impl<K: Tables, V: AsRef<[u32]>> Batch<'_, K, V> {
    /// Passes the queries on, each decided by itself.
    pub(super) fn one_by_one(self) {
        match self.passed {
            Passed::Unsettled(unsettled) => (0..self.queries.len()).for_each(unsettled),
            Passed::Colliding(found) => {
                for (index, vertices) in self.queries.iter().enumerate() {
                    let points = points_of::<K>(self.rows, vertices.as_ref());
                    let separation = separation_of::<K>(self.separations, vertices.as_ref());
                    let options = Options::within(separation).until(self.until);
                    if let Ok(decided) = decide(&points, &options) {
                        found(index, &points, decided);
                    }
                }
            }
        }
    }
}

/// The rows of x₀ … x₃.
#[inline(always)]
pub(super) fn rows_of<'a, K: Tables>(rows: &'a [Row], vertices: &[u32]) -> [&'a Row; 4] {
    K::LAYOUT.map(|i| &rows[vertices[i] as usize])
}

/// x₀ … x₃ at t = 0 and at t = 1.
pub(crate) fn points_of<K: Tables>(rows: &[Row], vertices: &[u32]) -> Points<f64> {
    let mut points = [[[0.0; 3]; 4]; 2];
    for (place, row) in rows_of::<K>(rows, vertices).into_iter().enumerate() {
        [points[0][place], points[1][place]] = row.points();
    }
    points
}

/// The separation of a query of vertices.
#[inline(always)]
pub(super) fn separation_of<K: Tables>(separations: Separations<'_>, vertices: &[u32]) -> Separation {
    let (first, second) = vertices.split_at(K::SECOND);
    separations.between(first, second)
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
            Passed::Colliding(&mut |index, _, _| found.push(index)),
        );
        pass_on(
            &rows,
            &queries,
            Passed::Unsettled(&mut |index| unsettled.push(index)),
        );
        assert_eq!((found, unsettled), (vec![0, 2], vec![0, 1, 2]));
    }
}
