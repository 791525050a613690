//! The polynomials of a query, in Bernstein form over the time step.

use exact_ccd::{EdgeEdge, Kind, Point, Query, VertexFace};

use super::number::Number;
use crate::vector::{Vector, cross, dot, minus, plus};

/// Four moving points a, b, c, d that are coplanar at contact, and the sides on which d then lies.
///
/// For a vertex and a face, a, b, c are the corners of the face and d the vertex; for two edges, a
/// and b are the ends of one, c and d of the other.
pub(super) struct Configuration {
    /// At t = 0 and at t = 1.
    pub(super) points: [[Point; 4]; 2],
    /// Points x, y with (x − d) × (y − d) along (b − a) × (c − a), or zero, at contact.
    sides: [[usize; 2]; 3],
}

/// The configuration of a kind of query.
pub(super) trait Configured: Kind<Points = [Point; 4]> {
    /// The points of the query that are a, b, c and d.
    const POINTS: [usize; 4];
    /// The pairs x, y of [`Configuration::sides`].
    const PAIRS: [[usize; 2]; 3];
}

impl Configured for VertexFace {
    const POINTS: [usize; 4] = [1, 2, 3, 0];
    const PAIRS: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];
}

/// c and d lie on different sides of ab, and a and b on different sides of cd.
impl Configured for EdgeEdge {
    const POINTS: [usize; 4] = [0, 1, 2, 3];
    const PAIRS: [[usize; 2]; 3] = [[1, 2], [2, 0], [1, 0]];
}

impl Configuration {
    pub(super) fn new<K: Configured>(query: &Query<K>) -> Self {
        Self {
            points: query.points().map(|points| K::POINTS.map(|point| points[point])),
            sides: K::PAIRS,
        }
    }
}

/// The polynomials of a configuration in some arithmetic.
pub(super) struct Polynomials<N> {
    points: [[Vector<N>; 4]; 2],
    sides: [[usize; 2]; 3],
    /// (b − a) × (c − a), with the coefficient of degree one doubled.
    normal: [Vector<N>; 3],
}

impl<N: Number> Polynomials<N> {
    /// The polynomials of a configuration with these points.
    #[inline]
    pub(super) fn new(points: [[Vector<N>; 4]; 2], configuration: &Configuration) -> Self {
        Self {
            normal: area(&points, 0, [1, 2]),
            sides: configuration.sides,
            points,
        }
    }

    /// The polynomials of a configuration whose coordinates are converted one by one.
    #[inline]
    pub(super) fn from_coordinates(configuration: &Configuration) -> Self
    where
        N: From<f64>,
    {
        let vector = |[x, y, z]: Point| [N::from(x), N::from(y), N::from(z)];
        let vectors = |[a, b, c, d]: [Point; 4]| [vector(a), vector(b), vector(c), vector(d)];
        let [start, end] = configuration.points;
        Self::new([vectors(start), vectors(end)], configuration)
    }

    /// 3 Y, where Y = (d − a) · (b − a) × (c − a).
    pub(super) fn coplanarity(&self) -> [N; 4] {
        let [p, q] = &self.points;
        let [w0, w1] = [minus(&p[3], &p[0]), minus(&q[3], &q[0])];
        let [n0, n1, n2] = &self.normal;
        [
            dot(n0, &w0).times(3),
            dot(n1, &w0) + dot(n0, &w1),
            dot(n1, &w1) + dot(n2, &w0),
            dot(n2, &w1).times(3),
        ]
    }

    /// 12 L for the three L = (x − d) × (y − d) · (b − a) × (c − a). At contact none of them is negative.
    #[inline]
    pub(super) fn insides(&self) -> impl Iterator<Item = [N; 5]> {
        self.sides.iter().map(|&side| {
            let [m0, m1, m2] = &area(&self.points, 3, side);
            let [n0, n1, n2] = &self.normal;
            [
                dot(m0, n0).times(12),
                (dot(m0, n1) + dot(m1, n0)).times(3),
                (dot(m0, n2) + dot(m1, n1) + dot(m2, n0)).times(2),
                (dot(m1, n2) + dot(m2, n1)).times(3),
                dot(m2, n2).times(12),
            ]
        })
    }
}

/// (x − o) × (y − o), with the coefficient of degree one doubled: that is the sum of the others
/// less the product of the displacements.
#[inline]
fn area<N: Number>([p, q]: &[[Vector<N>; 4]; 2], o: usize, [x, y]: [usize; 2]) -> [Vector<N>; 3] {
    let [px, py, qx, qy] = [
        minus(&p[x], &p[o]),
        minus(&p[y], &p[o]),
        minus(&q[x], &q[o]),
        minus(&q[y], &q[o]),
    ];
    let start = cross(&px, &py);
    let end = cross(&qx, &qy);
    let middle = minus(&plus(&start, &end), &cross(&minus(&qx, &px), &minus(&qy, &py)));
    [start, middle, end]
}
