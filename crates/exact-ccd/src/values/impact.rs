//! The earliest contact: time, parameters and normal, as contact solvers need them.

use super::time::ContactTime;
use crate::tables::Point;

/// The earliest contact of a query: time, parameters and normal.
///
/// The time is exact, as everywhere in this crate. The parameters and the components of the normal
/// are within 2⁻³² of the exact ones.
///
/// Let n be the normal of the plane in which the primitives meet: v₂ − v₁ times v₃ − v₁, or a₁ − a₀
/// times b₁ − b₀. There are three cases.
///
/// - *Crossing*: n does not vanish, and the four points are coplanar at isolated times only. The
///   contact has one pair of parameters. The normal is ±n / |n|, on the side on which the first
///   primitive is just before the contact. (If that is before t = 0, the motion is extended to
///   earlier times.)
/// - *Vertex on edge*: the face is flat or the edges are parallel at the contact, or the four
///   points are coplanar at all times; and a vertex of one primitive lies on an edge of the other.
///   The parameters belong to that point; if the primitives have more points in common, or the
///   same point has many parameters, of the first such pair in the order p on v₁v₂, v₂v₃, v₃v₁, or
///   a₀ and a₁ on b, b₀ and b₁ on a. The normal is the velocity of that point on the second
///   primitive relative to the first, projected orthogonally to the line of the edge. There is none
///   if that projection vanishes: the primitives rest on each other, or slide along the line.
/// - *Overlapping* from t = 0 on, coplanar at all times, and no vertex on an edge: the parameters
///   are the only ones, and the normal is n / |n|, with an arbitrary sign.
///
/// With a separation above 0, the parameters belong to the closest points at that time, and the normal is
/// the direction from the closest point of the second primitive to the closest point of the first; there is
/// none if the two coincide. Where several pairs of points are the closest, it is one of them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Impact {
    /// The earliest contact time.
    pub time: ContactTime,
    /// u and v, in [0, 1]: the primitives meet at (1 − u − v) v₁ + u v₂ + v v₃, or at (1 − u) a₀ +
    /// u a₁ and (1 − v) b₀ + v b₁. With a face, u + v may be larger than 1 by rounding.
    pub parameters: [f64; 2],
    /// The unit normal of the contact, from the second primitive (the face, or the edge b) towards
    /// the first.
    pub normal: Option<Point>,
}

impl Impact {
    /// Returns true if the primitives touch at t = 0.
    #[must_use]
    pub fn touching_at_start(&self) -> bool {
        self.time.is_start()
    }
}

/// The unit vector in the direction of a vector whose largest component is neither tiny nor huge.
pub(crate) fn unit(vector: Point) -> Point {
    let [x, y, z] = vector;
    let length = libm::sqrt(x * x + y * y + z * z);
    vector.map(|component| component / length)
}
