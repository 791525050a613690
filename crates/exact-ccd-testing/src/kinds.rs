//! Queries of all kinds from four points.

use exact_ccd::{EdgeEdge, Kind, Point, Query, VertexEdge, VertexFace, VertexVertex};

/// The query of the first and the last of four points, as many as each primitive has. They are finite.
pub fn query<K: Kind>(points: &[[Point; 4]; 2]) -> Query<K> {
    let [start, end] = points.map(points_of::<K>);
    Query::new(start, end).unwrap()
}

/// The points of a query among four: the first primitive takes the first ones, the second primitive the last.
pub fn points_of<K: Kind>(four: [Point; 4]) -> K::Points {
    let mut points = K::Points::default();
    let (first, second) = points.as_mut().split_at_mut(K::FIRST);
    first.copy_from_slice(&four[..first.len()]);
    second.copy_from_slice(&four[4 - second.len()..]);
    points
}

/// The orders of the four points that leave the primitives the same.
pub trait Renamed: Kind + 'static {
    /// The orders, each as the indices of the points that replace them.
    const RENAMINGS: &'static [[usize; 4]];
}

impl Renamed for VertexFace {
    const RENAMINGS: &'static [[usize; 4]] = &[
        [0, 1, 2, 3],
        [0, 1, 3, 2],
        [0, 2, 1, 3],
        [0, 2, 3, 1],
        [0, 3, 1, 2],
        [0, 3, 2, 1],
    ];
}

impl Renamed for EdgeEdge {
    const RENAMINGS: &'static [[usize; 4]] = &[
        [0, 1, 2, 3],
        [1, 0, 2, 3],
        [0, 1, 3, 2],
        [1, 0, 3, 2],
        [2, 3, 0, 1],
        [3, 2, 0, 1],
        [2, 3, 1, 0],
        [3, 2, 1, 0],
    ];
}

impl Renamed for VertexEdge {
    const RENAMINGS: &'static [[usize; 4]] = &[[0, 1, 2, 3], [0, 1, 3, 2]];
}

impl Renamed for VertexVertex {
    const RENAMINGS: &'static [[usize; 4]] = &[[0, 1, 2, 3], [3, 1, 2, 0]];
}
