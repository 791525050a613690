//! The singular values of a deformation gradient.

use nalgebra::{Matrix3, Vector3};

/// The pairs of axes.
pub(super) const PAIRS: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];

/// The number of sweeps after which columns count as orthogonal. Four are usual.
const SWEEPS: usize = 30;

/// The decomposition F = U diag(σ) Vᵀ in rotations U and V, with σ₁ ≥ σ₂ ≥ |σ₃|. The last σ is negative if
/// det F < 0.
///
/// Rotations V make the columns of F V orthogonal, in pairs, up to rounding relative to their lengths: the
/// method of Jacobi in the form of M. Hestenes, *Inversion of matrices by biorthogonalization and related
/// results*, 1958, with small relative errors of small singular values too (J. Demmel, K. Veselić, *Jacobi's
/// method is more accurate than QR*, 1992). The lengths are the singular values.
pub(super) fn rotation_variant(f: &Matrix3<f64>) -> (Matrix3<f64>, Vector3<f64>, Matrix3<f64>) {
    let [mut columns, mut axes] =
        [f, &Matrix3::identity()].map(|m| [0, 1, 2].map(|i| m.column(i).into_owned()));
    for _ in 0..SWEEPS {
        let mut are_orthogonal = true;
        for pair in PAIRS {
            if let Some(rotation) = Rotation::between(&columns, pair) {
                are_orthogonal = false;
                rotation.apply(&mut columns, pair);
                rotation.apply(&mut axes, pair);
            }
        }
        if are_orthogonal {
            break;
        }
    }
    let squares = columns.map(|column| column.norm_squared());
    let mut order = [0, 1, 2];
    order.sort_unstable_by(|&i, &j| squares[j].total_cmp(&squares[i]));
    let [[along, across, _], [first, second, _]] = [&columns, &axes].map(|of| order.map(|i| of[i]));
    // Two columns have all bits of V, and of U, as long as there is an area.
    let v = Matrix3::from_columns(&[first, second, first.cross(&second)]);
    let u1 = along.try_normalize(0.0).unwrap_or_else(Vector3::x);
    let across = across - u1 * u1.dot(&across);
    // A part across u₁ of a few ulps of σ₁ is rounding, without a direction of its own.
    let least = 4.0 * f64::EPSILON * along.norm();
    let any = || u1.cross(&Vector3::ith(u1.iamin(), 1.0)).normalize();
    let u2 = across.try_normalize(least).unwrap_or_else(any);
    let u3 = u1.cross(&u2);
    let third = u3.dot(&(f * v.column(2)));
    // Not the smaller one by rounding, where both are.
    let stretches = Vector3::new(along.norm(), across.norm().max(third.abs()), third);
    (Matrix3::from_columns(&[u1, u2, u3]), stretches, v)
}

/// A rotation of two columns, by the cosine and the sine of its angle.
struct Rotation {
    cosine: f64,
    sine: f64,
}

impl Rotation {
    /// The smaller rotation that makes two columns orthogonal. `None` if they are, up to rounding.
    fn between(columns: &[Vector3<f64>; 3], [i, j]: [usize; 2]) -> Option<Self> {
        let (x, y) = (&columns[i], &columns[j]);
        let (xx, yy, xy) = (x.norm_squared(), y.norm_squared(), x.dot(y));
        // False for NaN.
        let are_oblique = xy * xy > f64::EPSILON * f64::EPSILON * xx * yy;
        if !are_oblique {
            return None;
        }
        let ratio = (yy - xx) / (2.0 * xy);
        let tangent = ratio.signum() / (ratio.abs() + (1.0 + ratio * ratio).sqrt());
        let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
        let sine = cosine * tangent;
        Some(Self { cosine, sine })
    }

    fn apply(&self, columns: &mut [Vector3<f64>; 3], [i, j]: [usize; 2]) {
        let (x, y) = (columns[i], columns[j]);
        columns[i] = x * self.cosine - y * self.sine;
        columns[j] = x * self.sine + y * self.cosine;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_product_is_the_matrix() {
        let mut random = fastrand::Rng::with_seed(6);
        let mut any = || Matrix3::from_fn(|_, _| random.f64() - 0.5);
        for number in 0..2000 {
            let (a, b) = (any(), any());
            let f = match number % 8 {
                0 => Matrix3::identity(),
                1 => Matrix3::identity() + a * 1e-3,
                2 => Matrix3::identity() + a * 1e-12,
                3 => a * Matrix3::from_diagonal(&Vector3::new(1.0, 1e-5, 1e-11)) * b,
                4 => a.column(0) * b.row(0),
                5 => a.column(0) * b.row(0) + a.column(1) * b.row(1),
                6 => Matrix3::zeros(),
                _ => a,
            };
            let (u, stretches, v) = rotation_variant(&f);
            let product = u * Matrix3::from_diagonal(&stretches) * v.transpose();
            assert!((product - f).norm() <= 1e-14 * f.norm(), "{number}: {f}{product}");
            for rotation in [u, v] {
                let unit = rotation.tr_mul(&rotation);
                assert!(
                    (unit - Matrix3::identity()).norm() < 1e-14,
                    "{number}: {rotation}"
                );
                assert!(rotation.determinant() > 0.0);
            }
            let [x, y, z] = stretches.into();
            assert!(x >= y * (1.0 - 1e-14) && y >= z.abs(), "{number}: {stretches}");
        }
    }
}
