//! The kinds of query, as index tables.
//!
//! A query has four moving points x₀ … x₃. A vertex and a face, or two edges, meet only when the four points
//! are coplanar, and the sides of lines on which vertices lie decide contact then. Hence all algorithms in
//! this crate are written once, over these tables. A vertex against an edge or a vertex is a query of two
//! edges; one or both have length zero: a point is repeated.

use core::fmt::Debug;
use core::ops::Deref;

use crate::answers;
use crate::batch::{self, Batch, Instructions};
use crate::collision::Collision;
use crate::distance::DistanceBounds;
use crate::impact::Impact;
use crate::interval::Intervals;
use crate::options::Options;
use crate::point::Point;
use crate::query::Query;
use crate::stage::Stage;
use crate::time::ContactTime;

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

/// The pairs of features, one of each primitive, that can contain the closest points of the primitives.
#[derive(Clone, Copy)]
pub struct Features {
    /// Two vertices each, first the vertex of the first primitive, and (u, v) where F is their difference.
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

/// The tables of the kinds. The module is private, which seals [`Kind`].
pub(crate) mod tables {
    use super::{Difference, Features, Side, side};

    /// The tables of a kind of query. By default, the tables of two edges.
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
        /// The pairs of features. The distance of the primitives is the least among the distances of these
        /// pairs.
        const FEATURES: Features;
    }
}
pub(crate) use tables::Tables;

/// The kind of a [`Query`](crate::Query): [`VertexFace`], [`EdgeEdge`], [`VertexEdge`] or [`VertexVertex`].
/// Sealed.
pub trait Kind: Tables + Copy {
    /// The points of a query at one time, in the order that the kind states.
    type Points: AsRef<[Point]> + AsMut<[Point]> + Copy + Debug + Default + PartialEq + Send + Sync;
    /// The indices of those points among the vertices of a mesh, in the same order.
    type Vertices: AsRef<[u32]> + AsMut<[u32]> + Copy + Debug + Default + PartialEq + Send + Sync;
    /// The number of points of the first primitive, which come first.
    const FIRST: usize;

    /// x₀ … x₃ at both ends of the step: the points themselves if they are four.
    #[doc(hidden)]
    fn four(points: &[Self::Points; 2]) -> impl Deref<Target = [[Point; 4]; 2]>;

    // The algorithms are functions of each kind, not generic ones: this crate contains their code, and the
    // crates that call them do not compile it again.
    #[doc(hidden)]
    fn run(batch: Batch<'_, Self>, instructions: Instructions);
    #[doc(hidden)]
    fn collides(query: &Query<Self>, options: Options) -> bool;
    #[doc(hidden)]
    fn decide(query: &Query<Self>, options: Options) -> Result<Collision<'_, Self>, Stage>;
    #[doc(hidden)]
    fn time(collision: &Collision<'_, Self>) -> ContactTime;
    #[doc(hidden)]
    fn intervals(collision: &Collision<'_, Self>) -> Intervals;
    #[doc(hidden)]
    fn impact(collision: &Collision<'_, Self>) -> Impact;
    #[doc(hidden)]
    fn distance(collision: &Collision<'_, Self>) -> DistanceBounds;
}

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

/// Four points of a query that has fewer: some occur twice.
struct Repeated([[Point; 4]; 2]);

impl Repeated {
    #[inline(always)]
    fn of<K: Kind>(points: &[K::Points; 2]) -> Self {
        Self(points.map(|points| K::LAYOUT.map(|i| points.as_ref()[i])))
    }
}

impl Deref for Repeated {
    type Target = [[Point; 4]; 2];

    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

/// A kind with numbers of points, of a query and of its first primitive, and x₀ … x₃ among them.
macro_rules! kind {
    ($kind:ident, $count:literal, $first:literal, |$points:ident| $four:expr) => {
        impl Kind for $kind {
            type Points = [Point; $count];
            type Vertices = [u32; $count];
            const FIRST: usize = $first;

            #[inline(always)]
            fn four($points: &[Self::Points; 2]) -> impl Deref<Target = [[Point; 4]; 2]> {
                $four
            }

            #[inline(never)]
            fn run(batch: Batch<'_, Self>, instructions: Instructions) {
                batch::run(batch, instructions);
            }

            #[inline(never)]
            fn collides(query: &Query<Self>, options: Options) -> bool {
                answers::collides(query, &options)
            }

            #[inline(never)]
            fn decide(query: &Query<Self>, options: Options) -> Result<Collision<'_, Self>, Stage> {
                answers::decide(query, &options)
            }

            #[inline(never)]
            fn time(collision: &Collision<'_, Self>) -> ContactTime {
                collision.determine_time()
            }

            #[inline(never)]
            fn intervals(collision: &Collision<'_, Self>) -> Intervals {
                collision.determine_intervals()
            }

            #[inline(never)]
            fn impact(collision: &Collision<'_, Self>) -> Impact {
                collision.determine_impact()
            }

            #[inline(never)]
            fn distance(collision: &Collision<'_, Self>) -> DistanceBounds {
                collision.determine_distance()
            }
        }
    };
}

kind!(VertexFace, 4, 1, |points| points);
kind!(EdgeEdge, 4, 2, |points| points);
kind!(VertexEdge, 3, 1, |points| Repeated::of::<Self>(points));
kind!(VertexVertex, 2, 1, |points| Repeated::of::<Self>(points));

const fn side(
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

/// Two edges; the first has length zero.
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
