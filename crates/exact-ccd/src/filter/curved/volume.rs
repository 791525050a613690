//! The volume of the corners in a part of the step, whose roots are the times of contact.

use core::cmp::Ordering;

use super::piece::{Piece, of_mean, of_volume};
use super::polynomial::{Coefficient, MOST, binomials};
use crate::numbers::roundoff::{UNDERFLOW, UNIT, certain_sign, margin};
use crate::numbers::vector::{cross, dot};

/// The number of coefficients of the volume, at most.
pub(super) const COEFFICIENTS: usize = 3 * MOST;

/// The times in a part at which the volume vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Roots {
    /// None: the primitives do not touch.
    None,
    /// One, before which the volume has this sign.
    One(Ordering),
    /// The number is not certain.
    Unknown,
}

impl Piece<'_> {
    /// The roots of the volume in this part, in which it is not zero at the ends.
    ///
    /// The volume c = x₀ · (x₁ × x₂) of the first three corners equals the volume of w, e₁ and e₂ in
    /// `exact/motion.rs`: the differences of the corners are the edges. Its Bernstein coefficients of
    /// degree 3 n are means of volumes of control points, with products of binomial coefficients as
    /// weights, which are integers below 2⁵³. Without a change of sign among the coefficients there is no
    /// root, and with one there is one (Descartes' rule), whatever the sign of one between them that is not
    /// certain.
    pub(super) fn roots(&self) -> Roots {
        let points = self.curves.points;
        if self.volume_sign(0).is_none() || self.volume_sign(points - 1).is_none() {
            return Roots::Unknown;
        }
        let (coefficients, error) = self.coefficients();
        let degree = 3 * (points - 1);
        let weights: [f64; COEFFICIENTS] = binomials(degree);
        let sign = |m: usize| certain_sign(coefficients[m], error * weights[m]);
        let [Some(first), last] = [0, degree].map(sign) else {
            return Roots::Unknown;
        };
        // Certain ones at the beginning and at the end, and at most one between them that is not.
        let start = (0..=degree).take_while(|&m| sign(m) == Some(first)).count();
        if start > degree {
            return Roots::None;
        }
        let end = (0..=degree).rev().take_while(|&m| sign(m) == last).count();
        if last == Some(first.reverse()) && start + end >= degree {
            Roots::One(first)
        } else {
            Roots::Unknown
        }
    }

    /// The coefficients times binomial ones, and the bound of an error, which is to be multiplied by the
    /// latter too: the magnitudes of six terms, in a mean.
    fn coefficients(&self) -> ([f64; COEFFICIENTS], f64) {
        let corners = self.first_corners().map(|corner| self.curves.corner(corner));
        let [x, y, z] = self.corners.magnitude;
        let n = of_mean(
            self.corners.roundings + self.roundings(),
            self.curves.points as u32,
        );
        let error = x * y * z * (6.0 * margin(n) * UNIT) + UNDERFLOW;
        (weighted_volumes(corners, 0.0), error)
    }

    /// The sign of the volume of the first three corners at one end, if it is certain: six terms.
    pub(super) fn volume_sign(&self, end: usize) -> Option<Ordering> {
        let [a, b, c] = self
            .first_corners()
            .map(|corner| self.curves.corners[corner][end]);
        let [x, y, z] = self.corners.magnitude;
        let n = of_volume(self.corners.roundings + self.roundings());
        let error = x * y * z * (6.0 * margin(n) * UNIT) + UNDERFLOW;
        certain_sign(dot(a, cross(b, c)), error)
    }
}

/// The Bernstein coefficients of the volume of three curves, times binomial ones.
pub(super) fn weighted_volumes<T: Coefficient>([a, b, c]: [&[[T; 3]]; 3], zero: T) -> [T; COEFFICIENTS] {
    let weights: [f64; MOST] = binomials(a.len() - 1);
    let mut coefficients = [zero; COEFFICIENTS];
    for (j, &y) in b.iter().enumerate() {
        for (k, &z) in c.iter().enumerate() {
            let normal = cross(y, z);
            for (i, &x) in a.iter().enumerate() {
                let sum = &mut coefficients[i + j + k];
                *sum = *sum + dot(x, normal) * (weights[i] * weights[j] * weights[k]);
            }
        }
    }
    coefficients
}
