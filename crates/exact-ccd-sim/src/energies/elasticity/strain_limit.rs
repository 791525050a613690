//! The limit of the stretches of a shell.
//!
//! The barrier follows codimensional incremental potential contact (M. Li, D. Kaufman, C. Jiang, 2021),
//! with another function. For a principal stretch σ = 1 + e, the limit ε > 0 of the strain e and Young's
//! modulus E, the energy by volume is
//!
//! ```text
//! f(σ) = −E e² ln(1 − e/ε)  for 0 < e < ε,   0 for e ≤ 0,   ∞ for e ≥ ε.
//! ```
//!
//! It begins as E e³/ε, so that f is twice continuously differentiable and does not change the moduli of the
//! material at small strains. Both derivatives are positive for e > 0:
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
//! s(λ) = f′(σ)/σ, because dλ = v · dC v for the unit eigenvector v. In the frame of the eigenvectors, dS has
//! the entries of dC, times the derivatives of s on the diagonal and the quotient of its differences beside
//! it (J. Daleckii, M. Krein, 1965).

use nalgebra::{Matrix2, Vector2};

/// The limit of the principal stretches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StrainLimit {
    /// ε.
    limit: f64,
    /// E, in Pa.
    young: f64,
}

/// The difference of the squares λ of both stretches, relative to the larger one, up to which the quotient of
/// the differences of s and λ counts as the mean of both derivatives.
///
/// A difference Δ loses digits in the quotient: its relative error is some 4 u λ/Δ, with u = 2⁻⁵³. The mean
/// has the error Δ² s‴/(12 s′), which is Δ²/(2 γ²) near the limit, where s grows as 1/γ with the distance γ
/// of
/// λ from it. For the least limit, 1e-6, γ is 1e-6 at half of it: both errors are then about 5e-7 at Δ =
/// 1e-9 λ. For larger limits the error of the mean is smaller.
const NEARLY_EQUAL: f64 = 1e-9;

/// The principal stresses s(λ) at the squares λ of both stretches.
pub(crate) struct Principal {
    pub(crate) stresses: Vector2<f64>,
    /// ds/dλ.
    pub(crate) slopes: Vector2<f64>,
    /// The quotient of the differences of s and λ.
    pub(crate) quotient: f64,
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

    /// The principal stresses and their derivatives, at the squares of both stretches, the larger one first.
    pub(crate) fn principal(&self, squares: &Vector2<f64>) -> Principal {
        let [[s, ds], [t, dt]] = [squares.x, squares.y].map(|square| self.derivatives(square));
        let difference = squares.x - squares.y;
        let quotient = if difference > NEARLY_EQUAL * squares.x {
            (s - t) / difference
        } else {
            0.5 * (ds + dt)
        };
        Principal {
            stresses: Vector2::new(s, t),
            slopes: Vector2::new(ds, dt),
            quotient,
        }
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

/// The eigenvalues of a symmetric matrix, the larger one first, and the frame of its eigenvectors. The
/// smaller eigenvalue is set to 0 if rounding makes it negative: C has none below 0.
///
/// With the half difference d of the diagonal, the entry o beside it and r² = d² + o², the frame is turned by
/// θ with cos 2θ = d / r and sin 2θ = o / r. The larger of cos θ and sin θ is the square root of (r + |d|) /
/// (2 r), a sum without cancellation; the other one follows from 2 sin θ cos θ = o / r.
pub(super) fn principal(c: &Matrix2<f64>) -> (Vector2<f64>, Matrix2<f64>) {
    let (mean, half) = (0.5 * (c.m11 + c.m22), 0.5 * (c.m11 - c.m22));
    let radius = half.hypot(c.m12);
    let frame = if radius > 0.0 {
        let larger = (0.5 * (radius + half.abs()) / radius).sqrt();
        let smaller = 0.5 * c.m12 / (radius * larger);
        let [cos, sin] = if half >= 0.0 {
            [larger, smaller]
        } else {
            [smaller, larger]
        };
        Matrix2::new(cos, -sin, sin, cos)
    } else {
        Matrix2::identity()
    };
    (Vector2::new(mean + radius, (mean - radius).max(0.0)), frame)
}
