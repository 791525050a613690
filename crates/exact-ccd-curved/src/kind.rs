//! The kinds of query, with curves in place of points.

use exact_ccd::{EdgeEdge, Kind, Point, VertexEdge, VertexFace, VertexVertex};

/// A kind of query between curved primitives.
pub trait CurvedKind: Kind {
    /// The trajectories of the points, in the order of the kind: an array.
    type Trajectories<T>: AsRef<[T]>;

    /// The vertices and edges, as triples of points, whose contacts are the roots of F on the boundary of
    /// the domain of (u, v). `None` if that domain has less than two dimensions: then small changes of
    /// the motion can undo any contact.
    const BOUNDARY: Option<&'static [[usize; 3]]>;
}

impl CurvedKind for VertexFace {
    type Trajectories<T> = [T; 4];
    const BOUNDARY: Option<&'static [[usize; 3]]> = Some(&[[0, 1, 2], [0, 2, 3], [0, 3, 1]]);
}

impl CurvedKind for EdgeEdge {
    type Trajectories<T> = [T; 4];
    const BOUNDARY: Option<&'static [[usize; 3]]> = Some(&[[0, 2, 3], [1, 2, 3], [2, 0, 1], [3, 0, 1]]);
}

impl CurvedKind for VertexEdge {
    type Trajectories<T> = [T; 3];
    const BOUNDARY: Option<&'static [[usize; 3]]> = None;
}

impl CurvedKind for VertexVertex {
    type Trajectories<T> = [T; 2];
    const BOUNDARY: Option<&'static [[usize; 3]]> = None;
}

/// The points of a query at one time, by their index.
pub(crate) fn points<K: Kind>(at: impl Fn(usize) -> Point) -> K::Points {
    let mut points = K::Points::default();
    for (index, point) in points.as_mut().iter_mut().enumerate() {
        *point = at(index);
    }
    points
}
