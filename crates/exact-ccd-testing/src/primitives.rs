//! F by its definition, independent of the algebra of the kernel.

use exact_ccd::{EdgeEdge, Kind, Point, VertexFace};

/// The four points of a query at t = 0 and at t = 1.
pub type Points = [[Point; 4]; 2];

/// A kind of query, as the linear combination of its four points that vanishes in contact.
pub trait Primitives: Kind<Points = [Point; 4], Vertices = [u32; 4]> + 'static {
    /// The corners of the domain of (u, v).
    const DOMAIN: &'static [[f64; 2]];
    /// Returns true if (u / one, v / one) lies in the domain.
    fn contains(parameters: [f64; 2], one: f64) -> bool;
    /// The factors of the four points in F(·, u, v).
    fn weights(u: f64, v: f64) -> [f64; 4];
    /// A point of the domain for a point of the unit square.
    fn in_domain(u: f64, v: f64) -> [f64; 2];
}

impl Primitives for VertexFace {
    const DOMAIN: &'static [[f64; 2]] = &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

    fn contains([u, v]: [f64; 2], one: f64) -> bool {
        u >= 0.0 && v >= 0.0 && u + v <= one
    }

    fn weights(u: f64, v: f64) -> [f64; 4] {
        [1.0, u + v - 1.0, -u, -v]
    }

    fn in_domain(u: f64, v: f64) -> [f64; 2] {
        if u + v > 1.0 { [1.0 - u, 1.0 - v] } else { [u, v] }
    }
}

impl Primitives for EdgeEdge {
    const DOMAIN: &'static [[f64; 2]] = &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];

    fn contains(parameters: [f64; 2], one: f64) -> bool {
        parameters.iter().all(|x| (0.0..=one).contains(x))
    }

    fn weights(u: f64, v: f64) -> [f64; 4] {
        [1.0 - u, u, v - 1.0, -v]
    }

    fn in_domain(u: f64, v: f64) -> [f64; 2] {
        [u, v]
    }
}

/// Σ wᵢ xᵢ.
pub fn combine<const N: usize>(weights: [f64; N], points: [Point; N]) -> Point {
    [0, 1, 2].map(|axis: usize| (0..N).map(|i| weights[i] * points[i][axis]).sum())
}

/// The scalar product.
pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The points at time t.
pub fn at(points: &Points, t: f64) -> [Point; 4] {
    [0, 1, 2, 3].map(|i: usize| combine([1.0 - t, t], [points[0][i], points[1][i]]))
}
