//! The four kinds, and their tables.

use super::features::{Difference, Features, Side, Tables, side};

/// Marks a query of a vertex p = x₀ against a face with corners v₁, v₂, v₃ = x₁, x₂, x₃.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct VertexFace;

/// Marks a query of an edge a₀ a₁ = x₀ x₁ against an edge b₀ b₁ = x₂ x₃.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EdgeEdge;

/// Marks a query of a vertex p against an edge a b, as points p, a, b: x₀ = x₁ = p, x₂ = a, x₃ = b.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct VertexEdge;

/// Marks a query of a vertex p against a vertex q, as points p, q: x₀ = x₁ = p, x₂ = x₃ = q.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct VertexVertex;

/// p lies in the triangle if it lies to the left of its three edges; their areas with p are its
/// barycentric coordinates.
impl Tables for VertexFace {
    const CORNERS: [Difference; 4] = [(0, 1), (0, 2), (0, 3), (0, 3)];
    const SPAN: [Difference; 3] = [(0, 1), (2, 1), (3, 1)];
    const SIDES: &'static [Side] = &[
        side(0, [1, 2], [0, 1], true, [[0.0, 0.0], [1.0, 0.0]]),
        side(0, [2, 3], [1, 2], true, [[1.0, 0.0], [0.0, 1.0]]),
        side(0, [3, 1], [2, 0], true, [[0.0, 1.0], [0.0, 0.0]]),
    ];
    const PARAMETERS: [usize; 2] = [2, 0];
    const FEATURES: Features = Features {
        vertices: &[((0, 1), [0.0, 0.0]), ((0, 2), [1.0, 0.0]), ((0, 3), [0.0, 1.0])],
        sides: Self::SIDES,
        inner: Some([1, 2]),
    };
}

impl Tables for EdgeEdge {
    const FEATURES: Features = Features {
        vertices: &[
            ((0, 2), [0.0, 0.0]),
            ((0, 3), [0.0, 1.0]),
            ((1, 2), [1.0, 0.0]),
            ((1, 3), [1.0, 1.0]),
        ],
        sides: Self::SIDES,
        inner: Some([2, 1]),
    };
}

/// Two edges, of which the first has length zero.
impl Tables for VertexEdge {
    const LAYOUT: [usize; 4] = [0, 0, 1, 2];
    const FEATURES: Features = Features {
        vertices: &[((0, 2), [0.0, 0.0]), ((0, 3), [0.0, 1.0])],
        sides: EdgeEdge::SIDES.split_at(1).0,
        inner: None,
    };
}

/// Two edges of length zero.
impl Tables for VertexVertex {
    const LAYOUT: [usize; 4] = [0, 0, 1, 1];
    const FEATURES: Features = Features {
        vertices: &[((0, 2), [0.0, 0.0])],
        sides: &[],
        inner: None,
    };
}
