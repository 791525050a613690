//! The kinds of query, with curves in place of points.

use exact_ccd::{EdgeEdge, Kind, Point, VertexEdge, VertexFace, VertexVertex};

/// A kind of query between curved primitives. Sealed, as [`Kind`] is.
pub trait CurvedKind: Kind {
    /// The trajectories of the points, in the order of the kind: an array.
    type Trajectories<T>: AsRef<[T]>;

    /// The number of points of the first primitive.
    const FIRST: usize;

    /// The vertices and edges, as triples of points, whose contacts are the roots of F on the sides of
    /// its domain, those at the ends of the interval of time excepted. `None` if F maps into three
    /// dimensions from fewer: then contact is not stable.
    const BOUNDARY: Option<&'static [[usize; 3]]>;

    /// The points of a query at one time, by their index.
    fn points(at: impl FnMut(usize) -> Point) -> Self::Points;
}

impl CurvedKind for VertexFace {
    type Trajectories<T> = [T; 4];
    const FIRST: usize = 1;
    const BOUNDARY: Option<&'static [[usize; 3]]> = Some(&[[0, 1, 2], [0, 2, 3], [0, 3, 1]]);

    fn points(at: impl FnMut(usize) -> Point) -> [Point; 4] {
        std::array::from_fn(at)
    }
}

impl CurvedKind for EdgeEdge {
    type Trajectories<T> = [T; 4];
    const FIRST: usize = 2;
    const BOUNDARY: Option<&'static [[usize; 3]]> = Some(&[[0, 2, 3], [1, 2, 3], [2, 0, 1], [3, 0, 1]]);

    fn points(at: impl FnMut(usize) -> Point) -> [Point; 4] {
        std::array::from_fn(at)
    }
}

impl CurvedKind for VertexEdge {
    type Trajectories<T> = [T; 3];
    const FIRST: usize = 1;
    const BOUNDARY: Option<&'static [[usize; 3]]> = None;

    fn points(at: impl FnMut(usize) -> Point) -> [Point; 3] {
        std::array::from_fn(at)
    }
}

impl CurvedKind for VertexVertex {
    type Trajectories<T> = [T; 2];
    const FIRST: usize = 1;
    const BOUNDARY: Option<&'static [[usize; 3]]> = None;

    fn points(at: impl FnMut(usize) -> Point) -> [Point; 2] {
        std::array::from_fn(at)
    }
}
