//! The tables of a kind of query: differences, sides and features.

/// A difference of two of the four points: `(i, j)` stands for xᵢ − xⱼ.
pub(crate) type Difference = (usize, usize);

/// A vertex against the line of an edge of the other primitive.
#[derive(Clone, Copy, Debug)]
pub struct Side {
    /// The vertex q.
    pub vertex: usize,
    /// The edge from x to y.
    pub edge: [usize; 2],
    /// The corners of the domain of (u, v) at which F is q − x and q − y, or x − q and y − q.
    pub corners: [usize; 2],
    /// The direction of (x − q) × (y − q) when the primitives meet: along the normal if true,
    /// against it if false.
    pub along: bool,
    /// The edge of the domain of (u, v) on which the vertex meets the edge: (u, v) where it meets
    /// x, and where it meets y.
    pub domain: [[f64; 2]; 2],
}

impl Side {
    /// (u, v) where the vertex meets the point (1 − s) x + s y of the edge.
    pub(crate) fn parameters(&self, s: f64) -> [f64; 2] {
        let [start, end] = self.domain;
        [0, 1].map(|i: usize| start[i] + s * (end[i] - start[i]))
    }
}

/// The pairs of features, one of each primitive, whose closest points can be those of the primitives.
#[derive(Clone, Copy)]
pub struct Features {
    /// Two vertices each, that of the first primitive first, and (u, v) where F is their difference.
    /// They are the first of `CORNERS`.
    pub vertices: &'static [(Difference, [f64; 2])],
    /// A vertex and an edge each.
    pub sides: &'static [Side],
    /// The corners at which (u, v) is (1, 0) and (0, 1), if inner points of the face or of both edges
    /// can be closest.
    pub inner: Option<[usize; 2]>,
}

impl Features {
    /// Returns true if the domain of (u, v) is a triangle, false if it is a square or a part of its boundary.
    pub(crate) const fn are_of_triangle(&self) -> bool {
        self.vertices.len() == 3
    }
}

/// The tables of a kind of query. By default, those of two edges. The module is private, which seals `Kind`.
///
/// The segments cross if the ends of each lie on different sides of the line of the other: with n =
/// e₁ × e₂, a₀ + u e₁ = b₀ + v e₂ gives u n = (b₀ − a₀) × e₂ and v n = (b₀ − a₀) × e₁, and the four
/// sides are u ≥ 0, u ≤ 1, v ≥ 0 and v ≤ 1.
#[expect(unnameable_types, reason = "seals the public trait `Kind`")]
pub trait Tables {
    /// F at the corners of the domain of (u, v). A face has only three; the last one is repeated.
    const CORNERS: [Difference; 4] = [(0, 2), (0, 3), (1, 2), (1, 3)];
    /// w, e₁, e₂, where w leads from the second primitive to the first. The primitives are
    /// coplanar when w · (e₁ × e₂) = 0, and e₁ × e₂ is the normal of their plane.
    const SPAN: [Difference; 3] = [(0, 2), (1, 0), (3, 2)];
    /// If the normal of the common plane does not vanish, the primitives meet there if and only
    /// if every vertex lies on the stated side of its line or on the line itself.
    const SIDES: &'static [Side] = &[
        side(0, [2, 3], [0, 1], true, [[0.0, 0.0], [0.0, 1.0]]),
        side(1, [2, 3], [2, 3], false, [[1.0, 0.0], [1.0, 1.0]]),
        side(2, [0, 1], [0, 2], false, [[0.0, 0.0], [1.0, 0.0]]),
        side(3, [0, 1], [1, 3], true, [[0.0, 1.0], [1.0, 1.0]]),
    ];
    /// The sides whose (x − q) × (y − q) are u and v times the normal, or that times −1 if not
    /// `along`.
    const PARAMETERS: [usize; 2] = [0, 2];
    /// For each of x₀ … x₃, its index among the points of the query.
    const LAYOUT: [usize; 4] = [0, 1, 2, 3];
    /// The number of points of the query.
    const COUNT: usize = Self::LAYOUT[3] + 1;
    /// The index of the first point of the second primitive among those of the query.
    const SECOND: usize = Self::LAYOUT[Self::CORNERS[0].1];
    /// The pairs of features among whose distances the least is that of the primitives.
    const FEATURES: Features;
}

pub(super) const fn side(
    vertex: usize,
    edge: [usize; 2],
    corners: [usize; 2],
    along: bool,
    domain: [[f64; 2]; 2],
) -> Side {
    Side {
        vertex,
        edge,
        corners,
        along,
        domain,
    }
}
