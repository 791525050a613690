//! Cases whose answers can be worked out by hand.

mod degenerate;
mod extreme_numbers;
mod impact;
mod thresholds;
mod touching;

use exact_ccd::separation::{Separation, TimeInterval};
use exact_ccd::{Kind, Point, Query, VertexFace};

use crate::laws::checked_intervals;

/// The face (0, 0), (1, 0), (0, 1) at height 0.
const FACE: [Point; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn within(d: f64) -> Separation {
    Separation::new(d).unwrap()
}

/// A vertex in motion, and a face at rest.
fn vertex_against(face: [Point; 3], from: Point, to: Point) -> Query<VertexFace> {
    let [v1, v2, v3] = face;
    Query::new([from, v1, v2, v3], [to, v1, v2, v3]).unwrap()
}

/// Within d in these intervals, whose ends are all f64.
#[track_caller]
fn is_within<K: Kind>(query: &Query<K>, d: f64, expected: &[[f64; 2]]) {
    let intervals = checked_intervals(query, within(d));
    let ends = |TimeInterval { start, end }: &TimeInterval| {
        assert!(start.is_exact() && end.is_exact(), "{intervals:?}");
        [start.lower(), end.lower()]
    };
    assert_eq!(intervals.iter().map(ends).collect::<Vec<_>>(), expected);
}
