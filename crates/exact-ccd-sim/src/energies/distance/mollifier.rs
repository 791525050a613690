//! The mollifier for nearly parallel edges.

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::{Matrix12, Vector12};

/// The mollifier m(c) = (2 − c/ε) c/ε for c = |e₁ × e₂|² < ε, else 1. As a factor of the barrier of two
/// edges, it removes the barrier of parallel edges, whose distance is not differentiable.
///
/// Source: *Incremental Potential Contact*, section 3.3, equation 24.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mollifier {
    threshold: f64,
}

impl Mollifier {
    /// The mollifier with ε = 10⁻³ |e₁|² |e₂|², from the squared lengths of the edges at rest.
    pub(crate) fn new(squared_lengths: [f64; 2]) -> Self {
        let threshold = 1e-3 * squared_lengths[0] * squared_lengths[1];
        Self { threshold }
    }

    /// Returns true if m < 1, for these positions of the edges' ends.
    pub(crate) fn is_active(&self, points: &[Vector3<f64>; 4]) -> bool {
        cross(points).norm_squared() < self.threshold
    }

    /// The value of m.
    pub(crate) fn value(&self, points: &[Vector3<f64>; 4]) -> f64 {
        let ratio = cross(points).norm_squared() / self.threshold;
        if ratio < 1.0 { (2.0 - ratio) * ratio } else { 1.0 }
    }

    /// The gradient and the Hessian of m.
    pub(crate) fn derivatives(&self, points: &[Vector3<f64>; 4]) -> (Vector12, Matrix12) {
        let [u, v] = edges(points);
        let normal = u.cross(&v);
        let ratio = normal.norm_squared() / self.threshold;
        if ratio >= 1.0 {
            return (Vector12::zeros(), Matrix12::zeros());
        }
        // Derivatives by e₁ and e₂ first; each edge is the difference of its ends.
        let by_u = v.cross(&normal) * 2.0;
        let by_v = normal.cross(&u) * 2.0;
        let mut squared = SMatrix::<f64, 6, 6>::zeros();
        let identity = Matrix3::identity();
        let block_uu = (identity * v.norm_squared() - v * v.transpose()) * 2.0;
        let block_vv = (identity * u.norm_squared() - u * u.transpose()) * 2.0;
        let block_uv = (u * v.transpose() * 2.0 - v * u.transpose() - identity * u.dot(&v)) * 2.0;
        squared.fixed_view_mut::<3, 3>(0, 0).copy_from(&block_uu);
        squared.fixed_view_mut::<3, 3>(3, 3).copy_from(&block_vv);
        squared.fixed_view_mut::<3, 3>(0, 3).copy_from(&block_uv);
        squared
            .fixed_view_mut::<3, 3>(3, 0)
            .copy_from(&block_uv.transpose());
        let mut slope = SMatrix::<f64, 6, 1>::zeros();
        slope.fixed_rows_mut::<3>(0).copy_from(&by_u);
        slope.fixed_rows_mut::<3>(3).copy_from(&by_v);

        let first = 2.0 * (1.0 - ratio) / self.threshold;
        let second = -2.0 / (self.threshold * self.threshold);
        let hessian = squared * first + slope * slope.transpose() * second;
        let ends = SMatrix::<f64, 6, 12>::from_fn(|row, column| {
            match (row % 3 == column % 3, row / 3, column / 3) {
                (true, 0, 0) | (true, 1, 2) => -1.0,
                (true, 0, 1) | (true, 1, 3) => 1.0,
                _ => 0.0,
            }
        });
        (ends.tr_mul(&slope) * first, ends.tr_mul(&(hessian * ends)))
    }
}

fn edges(points: &[Vector3<f64>; 4]) -> [Vector3<f64>; 2] {
    [points[1] - points[0], points[3] - points[2]]
}

fn cross(points: &[Vector3<f64>; 4]) -> Vector3<f64> {
    let [u, v] = edges(points);
    u.cross(&v)
}
