//! The earliest contact, with what a solver needs to know about it.

use crate::query::Point;
use crate::time::ContactTime;

/// The earliest contact of a query: when, where, and across which direction.
///
/// The time is exact, as everywhere in this crate. The parameters and the components of the normal are within 2⁻³² of
/// the exact ones.
///
/// Let n be the normal of the plane in which the primitives meet: v₂ − v₁ times v₃ − v₁, or a₁ − a₀ times b₁ − b₀.
/// There are three cases.
///
/// - *Crossing*: n does not vanish, and the four points are coplanar only for moments. The contact has one pair of
///   parameters. The normal is ±n / |n|, on the side on which the first primitive is just before the contact. (If
///   that is before t = 0, where it would have been.)
/// - *Vertex on edge*: the face is flat or the edges are parallel at the contact, or the four points are coplanar at
///   all times; and a vertex of one primitive lies on an edge of the other. The parameters are those of that point; if
///   the primitives have more points in common, or the same point has many parameters, of the first such pair in the
///   order p on v₁v₂, v₂v₃, v₃v₁, or a₀ and a₁ on b, b₀ and b₁ on a. The normal is the velocity of that point on
///   the second primitive relative to the first, made orthogonal to the line of the edge. There is none if nothing
///   of that velocity is left: the primitives rest on each other, or slide along the line.
/// - *Overlapping* from t = 0 on, coplanar at all times, and no vertex on an edge: the parameters are the only
///   ones, and the normal is n / |n|, whose sign means nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Impact {
    /// The earliest contact time.
    pub time: ContactTime,
    /// u and v, in [0, 1]: the primitives meet at (1 − u − v) v₁ + u v₂ + v v₃, or at (1 − u) a₀ + u a₁ and
    /// (1 − v) b₀ + v b₁. With a face, u + v may be larger than 1 by rounding.
    pub parameters: [f64; 2],
    /// The unit normal of the contact, from the second primitive (the face, or the edge b) towards the first.
    pub normal: Option<Point>,
}

impl Impact {
    /// Whether the primitives touch at t = 0 already.
    #[must_use]
    pub fn touching_at_start(&self) -> bool {
        self.time.is_exact() && self.time.lower() == 0.0
    }
}

/// A vector of length one in the direction of one whose largest component is neither tiny nor huge.
pub(crate) fn unit(vector: Point) -> Point {
    let [x, y, z] = vector;
    let length = libm::sqrt(x * x + y * y + z * z);
    vector.map(|component| component / length)
}
