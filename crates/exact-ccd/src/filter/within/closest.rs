//! A guess of the closest points at one time, without bound.

use core::ops::Mul;

use crate::numbers::number::Number;
use crate::numbers::vector::{add, dot, minus, scaled, towards};
use crate::tables::{Point, Tables};

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
    pub(super) fn guess<K: Tables>(corners: &[Point; 4]) -> Self {
        let features = K::FEATURES;
        if let Some(inner) = features.inner {
            let parameters = from_plane(corners, inner, corners[0]);
            if is_inside::<K>(parameters) {
                return Self::Inner(inner, parameters);
            }
        }
        let mut best = (dot(corners[0], corners[0]), Self::Corner(0));
        for side in features.sides {
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

    /// The same with better parameters, for corners in twice the precision, which are given in f64 too: one
    /// step of iterative refinement. The parameters of nearly parallel edges have lost digits, and the
    /// distance with them. Parameters that would leave the domain stay as they are.
    pub(super) fn refined<K: Tables, T>(self, corners: &[[T; 3]; 4], rounded: &[Point; 4]) -> Self
    where
        T: Number<Real = f64> + Mul<f64, Output = T>,
    {
        let Self::Inner(inner, [u, v]) = self else {
            return self;
        };
        let [along_u, along_v] = from_plane(rounded, inner, self.point(corners).map(Number::value));
        let parameters = [u + along_u, v + along_v];
        if is_inside::<K>(parameters) {
            Self::Inner(inner, parameters)
        } else {
            self
        }
    }

    /// F there.
    pub(super) fn point<T: Number + Mul<f64, Output = T>>(self, corners: &[[T; 3]; 4]) -> [T; 3] {
        match self {
            Self::Corner(i) => corners[i],
            Self::Between([i, j], s) => {
                let e = minus(corners[j], corners[i]);
                towards(corners[i], e, s)
            }
            Self::Inner([i, j], [u, v]) => {
                let (a, b) = (minus(corners[i], corners[0]), minus(corners[j], corners[0]));
                add(corners[0], towards(scaled(a, u), b, v))
            }
        }
    }
}

/// The steps along two sides from F at a place of a plane to the point that is closest to the origin,
/// as fractions of the sides; NaN for parallel sides.
fn from_plane(corners: &[Point; 4], [i, j]: [usize; 2], place: Point) -> [f64; 2] {
    let (a, b) = (minus(corners[i], corners[0]), minus(corners[j], corners[0]));
    let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
    let (pa, pb) = (dot(place, a), dot(place, b));
    let determinant = aa * bb - ab * ab;
    let scale = if determinant > 0.0 {
        1.0 / determinant
    } else {
        f64::NAN
    };
    [(ab * pb - bb * pa) * scale, (ab * pa - aa * pb) * scale]
}

/// True for parameters of inner points of the domain.
fn is_inside<K: Tables>([u, v]: [f64; 2]) -> bool {
    u > 0.0
        && v > 0.0
        && if K::FEATURES.are_of_triangle() {
            u + v < 1.0
        } else {
            u < 1.0 && v < 1.0
        }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numbers::double_double::DoubleDouble;
    use crate::tables::{EdgeEdge, VertexFace};

    /// Two vectors of length 4 along the first two axes, from a corner.
    fn corners(x: f64, y: f64) -> [Point; 4] {
        [
            [x, y, 1.0],
            [x + 4.0, y, 1.0],
            [x, y + 4.0, 1.0],
            [x + 4.0, y + 4.0, 1.0],
        ]
    }

    #[test]
    fn refined_parameters_are_those_of_the_closest_point_or_stay() {
        fn refined<K: Tables>(at: [f64; 2], corners: [Point; 4]) -> [f64; 2] {
            let precise = corners.map(|corner| corner.map(|high| DoubleDouble { high, low: 0.0 }));
            match Closest::Inner([1, 2], at).refined::<K, _>(&precise, &corners) {
                Closest::Inner(_, parameters) => parameters,
                other => panic!("{other:?}"),
            }
        }
        let at = [0.5, 0.125];
        for x in [-5.0, -4.0, -3.0, -2.0, -1.0, 0.0, 1.0] {
            for y in [-5.0, -4.0, -3.0, -1.0, 0.0, 1.0] {
                let closest = [-0.25 * x, -0.25 * y];
                let is_inside = closest.iter().all(|parameter| (0.125..0.875).contains(parameter));
                let expected = |is_of_domain: bool| if is_of_domain { closest } else { at };
                assert_eq!(refined::<EdgeEdge>(at, corners(x, y)), expected(is_inside));
                let is_of_face = is_inside && closest[0] + closest[1] < 1.0;
                assert_eq!(refined::<VertexFace>(at, corners(x, y)), expected(is_of_face));
            }
        }
    }
}
