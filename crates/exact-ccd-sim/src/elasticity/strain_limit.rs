//! The limit of the stretches of a shell.
//!
//! The barrier is that of codimensional incremental potential contact (M. Li, D. Kaufman, C. Jiang, 2021)
//! with another function. For a principal stretch σ = 1 + e, the limit ε > 0 of the strain e and Young's
//! modulus E, the energy by volume is
//!
//! ```text
//! f(σ) = −E e² ln(1 − e/ε)  for 0 < e < ε,   0 for e ≤ 0,   ∞ for e ≥ ε.
//! ```
//!
//! It begins as E e³/ε, so that f is twice continuously differentiable and the moduli at small strains are
//! those of the material. Both derivatives are positive for e > 0:
//!
//! ```text
//! f′ = E (−2 e ln(1 − e/ε) + e²/(ε − e)),
//! f″ = E (−2 ln(1 − e/ε) + 4 e/(ε − e) + e²/(ε − e)²).
//! ```
//!
//! So the sum over both stretches is a convex function of the deformation gradient F: a convex function of
//! singular values that does not decrease. The largest singular value is convex too. F is linear in the
//! positions, so that a motion in straight lines between two shapes below the limit stays below it: the line
//! search has to test its end only.
//!
//! With C = FᵀF and its eigenvalues λ = σ², the energy is a function of C. The stress is F S with S = s(C),
//! s(λ) = f′(σ)/σ, because dλ = v · dC v for the unit eigenvector v. The differential of S has the entries of
//! dC in the frame of the eigenvectors, times the divided differences of s (J. Daleckii, M. Krein, 1965).

use nalgebra::{Matrix2, Rotation2, Vector2};

/// The limit of the principal stretches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StrainLimit {
    /// ε.
    limit: f64,
    /// E, in Pa.
    young: f64,
}

impl StrainLimit {
    /// The limit of the strain of a material with this Young's modulus.
    pub(crate) fn new(limit: f64, young: f64) -> Self {
        Self { limit, young }
    }

    /// The energy by volume at C = FᵀF. Infinite at the limit and above.
    pub(crate) fn value(&self, c: &Matrix2<f64>) -> f64 {
        let of_stretch = |square: f64| {
            let strain = square.sqrt() - 1.0;
            if strain <= 0.0 {
                0.0
            } else if strain < self.limit {
                -self.young * strain * strain * (-strain / self.limit).ln_1p()
            } else {
                f64::INFINITY
            }
        };
        principal(c).0.map(of_stretch).sum()
    }

    /// The second Piola-Kirchhoff stress S at C.
    pub(crate) fn stress(&self, c: &Matrix2<f64>) -> Matrix2<f64> {
        let (squares, frame) = principal(c);
        let stresses = squares.map(|square| self.derivatives(square)[0]);
        frame * Matrix2::from_diagonal(&stresses) * frame.transpose()
    }

    /// The differential of S at C along dC.
    pub(crate) fn differential(&self, c: &Matrix2<f64>, change: &Matrix2<f64>) -> Matrix2<f64> {
        let (squares, frame) = principal(c);
        let [[s, ds], [t, dt]] = [squares.x, squares.y].map(|square| self.derivatives(square));
        let difference = squares.x - squares.y;
        // The quotient of nearly equal numbers is the mean of the derivatives, up to the second order.
        let quotient = if difference > 1e-7 * squares.x {
            (s - t) / difference
        } else {
            0.5 * (ds + dt)
        };
        let quotients = Matrix2::new(ds, quotient, quotient, dt);
        let in_frame = frame.tr_mul(change) * frame;
        frame * in_frame.component_mul(&quotients) * frame.transpose()
    }

    /// s and ds/dλ at λ = σ²: ds/dλ = (f″ − s) / (2 λ).
    fn derivatives(&self, square: f64) -> [f64; 2] {
        let stretch = square.sqrt();
        let strain = stretch - 1.0;
        if strain <= 0.0 {
            return [0.0; 2];
        }
        let log = (-strain / self.limit).ln_1p();
        let ratio = strain / (self.limit - strain);
        let stress = self.young * strain * (ratio - 2.0 * log) / stretch;
        let second = self.young * (ratio * (4.0 + ratio) - 2.0 * log);
        [stress, 0.5 * (second - stress) / square]
    }
}

/// The eigenvalues of a symmetric matrix, the larger one first, and the frame of its eigenvectors. No
/// eigenvalue is negative: those of C are none, up to rounding.
fn principal(c: &Matrix2<f64>) -> (Vector2<f64>, Matrix2<f64>) {
    let (mean, half) = (0.5 * (c.m11 + c.m22), 0.5 * (c.m11 - c.m22));
    let radius = half.hypot(c.m12);
    let frame = Rotation2::new(0.5 * c.m12.atan2(half));
    (
        Vector2::new(mean + radius, (mean - radius).max(0.0)),
        frame.into_inner(),
    )
}
