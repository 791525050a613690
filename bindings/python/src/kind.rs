//! The kinds of queries, and their arrays.

use exact_ccd::{EdgeEdge, Kind, Point, VertexEdge, VertexFace, VertexVertex};

/// A kind of queries in arrays.
pub(crate) trait ArrayKind: Kind + Send + Sync {
    /// True if the second primitive is a face.
    const IS_FACE: bool;

    /// Queries as their points, from coordinates.
    fn points(coordinates: &[f64]) -> &[[Self::Points; 2]];

    /// Queries as their vertices.
    fn vertices(indices: &[u32]) -> &[Self::Vertices];
}

/// The kinds of queries of N points.
macro_rules! array_kind {
    ($kind:ident, $count:literal, $is_face:literal) => {
        impl ArrayKind for $kind {
            const IS_FACE: bool = $is_face;

            fn points(coordinates: &[f64]) -> &[[[Point; $count]; 2]] {
                let points = coordinates.as_chunks().0;
                points.as_chunks().0.as_chunks().0
            }

            fn vertices(indices: &[u32]) -> &[[u32; $count]] {
                indices.as_chunks().0
            }
        }
    };
}

array_kind!(VertexFace, 4, true);
array_kind!(EdgeEdge, 4, false);
array_kind!(VertexEdge, 3, false);
array_kind!(VertexVertex, 2, false);

/// Evaluates an expression for the kind of a name.
macro_rules! for_kind {
    ($name:expr, $kind:ident => $value:expr) => {
        match $name {
            "vf" => {
                type $kind = exact_ccd::VertexFace;
                $value
            }
            "ee" => {
                type $kind = exact_ccd::EdgeEdge;
                $value
            }
            "ve" => {
                type $kind = exact_ccd::VertexEdge;
                $value
            }
            "vv" => {
                type $kind = exact_ccd::VertexVertex;
                $value
            }
            name => Err(pyo3::exceptions::PyValueError::new_err(format!(
                "kind {name:?}, expected \"vf\", \"ee\", \"ve\" or \"vv\""
            ))),
        }
    };
}
pub(crate) use for_kind;
