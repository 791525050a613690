//! The kinds of queries, and their arrays.

use exact_ccd::{EdgeEdge, Kind, Point, VertexEdge, VertexFace, VertexVertex};

use crate::positions::Rows;

/// The names of the kinds in Python, and the numbers of points of a query. The place of a kind is its number.
pub(crate) const KINDS: [(&str, usize); 4] = [("vf", 4), ("ee", 4), ("ve", 3), ("vv", 2)];

/// A kind of queries in arrays.
pub(crate) trait ArrayKind: Kind + Send + Sync {
    /// The place in [`KINDS`].
    const NUMBER: u8;

    /// The points of a query.
    fn points(rows: &Rows<'_>, row: usize) -> Self::Points;

    /// Queries as their vertices.
    fn vertices(indices: &[u32]) -> &[Self::Vertices];
}

/// A kind of queries by its number.
macro_rules! array_kind {
    ($kind:ident, $number:literal) => {
        impl ArrayKind for $kind {
            const NUMBER: u8 = $number;

            fn points(rows: &Rows<'_>, row: usize) -> [Point; KINDS[$number].1] {
                rows.query(row)
            }

            fn vertices(indices: &[u32]) -> &[[u32; KINDS[$number].1]] {
                indices.as_chunks().0
            }
        }
    };
}

array_kind!(VertexFace, 0);
array_kind!(EdgeEdge, 1);
array_kind!(VertexEdge, 2);
array_kind!(VertexVertex, 3);

/// Evaluates an expression for the kind of a number.
macro_rules! for_kind {
    ($number:expr, $kind:ident => $value:expr) => {{
        macro_rules! evaluate {
            ($one:ident) => {{
                type $kind = exact_ccd::$one;
                $value
            }};
        }
        match $number {
            0 => evaluate!(VertexFace),
            1 => evaluate!(EdgeEdge),
            2 => evaluate!(VertexEdge),
            3 => evaluate!(VertexVertex),
            number => Err($crate::error::refused(format_args!("there is no kind {number}"))),
        }
    }};
}
pub(crate) use for_kind;
