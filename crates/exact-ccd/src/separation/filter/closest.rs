//! A guess of the closest points at one time, without bound.

use crate::filter::{dot, minus, towards};
use crate::kind::Kind;
use crate::point::Point;

/// F at the closest points, as an affine combination of its corners.
#[derive(Clone, Copy, Debug)]
pub(super) enum Closest {
    /// A corner: two vertices.
    Corner(usize),
    /// From the first corner towards the second, by a fraction in [0, 1]: a vertex and an edge.
    Between([usize; 2], f64),
    /// From corner 0 towards two others, by fractions in [0, 1], of a sum of at most 1 if there are
    /// three corners only: a vertex and a face, or two edges.
    Inner([usize; 2], [f64; 2]),
}

impl Closest {
    pub(super) fn guess<K: Kind>(corners: &[Point; 4]) -> Self {
        let features = K::FEATURES;
        let is_triangle = features.vertices.len() == 3;
        if let Some([i, j]) = features.inner
            && let Some(parameters) = inner(corners, [i, j], is_triangle)
        {
            return Self::Inner([i, j], parameters);
        }
        let mut best = (dot(corners[0], corners[0]), Self::Corner(0));
        for side in &K::SIDES[..features.sides] {
            let [i, j] = side.corners;
            let (x, e) = (corners[i], minus(corners[j], corners[i]));
            let s = -dot(x, e) / dot(e, e);
            let (at, closest) = if s >= 1.0 {
                (corners[j], Self::Corner(j))
            } else if s > 0.0 {
                let point = towards(x, e, s);
                (point, Self::Between([i, j], s))
            } else {
                (x, Self::Corner(i))
            };
            let squared = dot(at, at);
            if squared < best.0 {
                best = (squared, closest);
            }
        }
        best.1
    }

    /// F there.
    pub(super) fn point(self, corners: &[Point; 4]) -> Point {
        match self {
            Self::Corner(i) => corners[i],
            Self::Between([i, j], s) => {
                let e = minus(corners[j], corners[i]);
                towards(corners[i], e, s)
            }
            Self::Inner([i, j], [u, v]) => {
                let (a, b) = (minus(corners[i], corners[0]), minus(corners[j], corners[0]));
                towards(towards(corners[0], a, u), b, v)
            }
        }
    }
}

/// The parameters of the point of a plane that is closest to the origin, if they are inside the
/// domain.
fn inner(corners: &[Point; 4], [i, j]: [usize; 2], is_triangle: bool) -> Option<[f64; 2]> {
    let c = corners[0];
    let (a, b) = (minus(corners[i], c), minus(corners[j], c));
    let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
    let (ca, cb) = (dot(c, a), dot(c, b));
    let determinant = aa * bb - ab * ab;
    let u = (ab * cb - bb * ca) / determinant;
    let v = (ab * ca - aa * cb) / determinant;
    let is_inside = u > 0.0
        && v > 0.0
        && if is_triangle {
            u + v < 1.0
        } else {
            u < 1.0 && v < 1.0
        };
    (determinant > 0.0 && is_inside).then_some([u, v])
}
