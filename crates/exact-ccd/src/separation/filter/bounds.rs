//! Proofs about the distance at one time, in twice the precision.

use super::closest::Closest;
use super::corners::Scaled;
use crate::filter::{DoubleDouble, Number, ROUNDOFF, UNDERFLOW, subtract};
use crate::kind::Kind;
use crate::query::Query;

type Vector = [DoubleDouble; 3];

/// The corners of F in twice the precision.
pub(super) struct PreciseCorners {
    /// At t = 0, and their velocities.
    motion: [([DoubleDouble; 3], [DoubleDouble; 3]); 4],
    count: usize,
    d: f64,
}

/// The corners of F at one time.
///
/// A component, of magnitude at most 1, comes from exact differences in three operations on terms of at most 1, 2 and 3:
/// off by at most 6 [`ROUNDOFF`].
pub(super) struct CornersAt {
    corners: [Vector; 4],
    count: usize,
    d: f64,
}

impl PreciseCorners {
    pub(super) fn new<K: Kind>(query: &Query<K>, scaled: &Scaled) -> Self {
        let factor = scaled.factor;
        let points = query.points().map(|now| now.map(|point| point.map(|x| x * factor)));
        let motion = K::CORNERS.map(|difference| {
            let [start, end] = subtract::<DoubleDouble>(&points, difference);
            (start, [0, 1, 2].map(|axis: usize| end[axis] - start[axis]))
        });
        Self {
            motion,
            count: K::FEATURES.vertices.len(),
            d: scaled.d,
        }
    }

    pub(super) fn at(&self, t: f64) -> CornersAt {
        let corners = self
            .motion
            .map(|(start, velocity)| [0, 1, 2].map(|axis: usize| start[axis] + velocity[axis] * t));
        CornersAt {
            corners,
            count: self.count,
            d: self.d,
        }
    }
}

impl CornersAt {
    /// The corners to within rounding.
    pub(super) fn rounded(&self) -> [[f64; 3]; 4] {
        self.corners.map(|corner| corner.map(Number::value))
    }

    /// |F|² − d² at some parameters.
    ///
    /// A component of F is off by at most 6 [`ROUNDOFF`] for each of up to five corners with factors of at most 1, and
    /// 12 for the operations on them; |F|² by twice that for each axis, with components of at most 1, and by 12 more.
    pub(super) fn excess(&self, closest: Closest) -> DoubleDouble {
        let x = self.point(closest);
        let d = DoubleDouble::difference(self.d, 0.0);
        dot(x, x) - d * d
    }

    /// True if the distance is certainly less than d, as |F| is at some parameters in the domain.
    pub(super) fn are_within(&self, closest: Closest) -> bool {
        let error = 512.0 * ROUNDOFF * (1.0 + self.d * self.d);
        self.excess(closest).value() < -error
    }

    /// F at some parameters.
    fn point(&self, closest: Closest) -> Vector {
        let corners = &self.corners;
        let towards = |i: usize, j: usize| [0, 1, 2].map(|axis: usize| corners[j][axis] - corners[i][axis]);
        match closest {
            Closest::Corner(i) => corners[i],
            Closest::Between([i, j], s) => {
                let e = towards(i, j);
                [0, 1, 2].map(|axis: usize| corners[i][axis] + e[axis] * s)
            }
            Closest::Inner([i, j], [u, v]) => {
                let (a, b) = (towards(0, i), towards(0, j));
                [0, 1, 2].map(|axis: usize| corners[0][axis] + (a[axis] * u + b[axis] * v))
            }
        }
    }

    /// A direction across the features, on the side of F: any vector proves something, and this one the most.
    pub(super) fn direction(&self, closest: Closest) -> Vector {
        let corners = &self.corners;
        let towards = |i: usize, j: usize| [0, 1, 2].map(|axis: usize| corners[j][axis] - corners[i][axis]);
        match closest {
            Closest::Corner(i) => corners[i],
            Closest::Between([i, j], _) => {
                let (x, e) = (corners[i], towards(i, j));
                let (ee, ex) = (dot(e, e), dot(e, x));
                [0, 1, 2].map(|axis: usize| ee * x[axis] - ex * e[axis])
            }
            Closest::Inner([i, j], _) => {
                let n = cross(towards(0, i), towards(0, j));
                if dot(n, corners[0]).value() < 0.0 {
                    n.map(|component| -component)
                } else {
                    n
                }
            }
        }
    }

    /// True if all corners are certainly farther than d from the plane through the origin across g, on the side to
    /// which g points.
    ///
    /// With e = |g₁| + |g₂| + |g₃|: g · x is at most e and off by (6 + 5) [`ROUNDOFF`] e, its square by 24 [`ROUNDOFF`] e²,
    /// d² g · g by 8 [`ROUNDOFF`] d² e².
    pub(super) fn are_beyond(&self, g: Vector) -> bool {
        let extent = g.iter().fold(0.0, |sum, component| sum + component.value().abs());
        let squared_extent = extent * extent;
        let d = DoubleDouble::difference(self.d, 0.0);
        let error = 64.0 * ROUNDOFF * squared_extent * (1.0 + self.d * self.d) + UNDERFLOW;
        let threshold = d * d * dot(g, g);
        let is_beyond = |&x: &Vector| {
            let along = dot(g, x);
            along.value() > 16.0 * ROUNDOFF * extent && (along * along - threshold).value() > error
        };
        self.corners[..self.count].iter().all(is_beyond)
    }
}

fn dot(a: Vector, b: Vector) -> DoubleDouble {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
