//! Values that differ between the kinds of pairs.

/// One value for each kind of pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ByKind<T> {
    /// The value of pairs of a vertex and a face.
    pub vertex_face: T,
    /// The value of pairs of two edges.
    pub edge_edge: T,
    /// The value of pairs of a vertex and a loose edge.
    pub vertex_edge: T,
    /// The value of pairs of two loose vertices.
    pub vertex_vertex: T,
}

/// Numbers of pairs, by their kind.
pub type PairCounts = ByKind<usize>;

impl<T> ByKind<T> {
    /// The values of a function.
    pub(crate) fn map<U>(self, mut f: impl FnMut(T) -> U) -> ByKind<U> {
        ByKind {
            vertex_face: f(self.vertex_face),
            edge_edge: f(self.edge_edge),
            vertex_edge: f(self.vertex_edge),
            vertex_vertex: f(self.vertex_vertex),
        }
    }

    /// References to the values.
    pub(crate) fn as_ref(&self) -> ByKind<&T> {
        ByKind {
            vertex_face: &self.vertex_face,
            edge_edge: &self.edge_edge,
            vertex_edge: &self.vertex_edge,
            vertex_vertex: &self.vertex_vertex,
        }
    }

    /// The values, in the order of the kinds.
    pub(crate) fn into_array(self) -> [T; 4] {
        [
            self.vertex_face,
            self.edge_edge,
            self.vertex_edge,
            self.vertex_vertex,
        ]
    }
}

impl PairCounts {
    /// The number of pairs of all kinds.
    #[must_use]
    pub fn total(&self) -> usize {
        self.into_array().into_iter().sum()
    }
}
