//! The barrier function.

/// The smoothly clamped logarithmic barrier between two surfaces.
///
/// Without thickness, it is b(D) = −(D − D̂)² ln(D/D̂) for D < D̂, else 0, with the squared distance D = d²
/// and D̂ = d̂² of the activation distance d̂. Source: M. Li, Z. Ferguson, T. Schneider, T. Langlois, D.
/// Zorin, D. Panozzo, C. Jiang, D. Kaufman, *Incremental Potential Contact*, ACM Transactions on Graphics
/// 39(4), 2020, equation 6, with squared distances as in the supplement of the paper.
///
/// With a thickness ξ, which is the sum of the offsets of both surfaces, the barrier is (d̂²/D̂)² b(D) of D
/// = d² − ξ² and D̂ = (ξ + d̂)² − ξ² = 2 ξ d̂ + d̂². D vanishes at d = ξ and equals D̂ at d = ξ + d̂, both
/// with a positive slope 2 d, so that the barrier is infinite at the distance ξ, ends smoothly at ξ + d̂,
/// and needs no square root. Source of D and D̂: M. Li, D. Kaufman, C. Jiang, *Codimensional Incremental
/// Potential Contact*, ACM Transactions on Graphics 40(4), 2021. The factor is an addition: b grows as D̂²,
/// that is as (2 ξ d̂)² for ξ ≫ d̂. With the factor, the barrier is d̂⁴ times a function of D/D̂ ≈ (d −
/// ξ)/d̂, and one stiffness serves pairs of any thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Barrier {
    /// d̂, in m.
    activation_distance: f64,
    /// ξ², in m².
    thickness_squared: f64,
    /// D̂, in m².
    range: f64,
    /// (d̂²/D̂)².
    scale: f64,
}

impl Barrier {
    /// The barrier of surfaces without thickness, with this activation distance, in m.
    pub(crate) fn new(activation_distance: f64) -> Self {
        Self {
            activation_distance,
            thickness_squared: 0.0,
            range: activation_distance * activation_distance,
            scale: 1.0,
        }
    }

    /// The barrier with the same activation distance and another thickness, in m.
    pub(crate) fn with_thickness(self, thickness: f64) -> Self {
        let plain = Self::new(self.activation_distance);
        let range = plain.range + 2.0 * thickness * plain.activation_distance;
        Self {
            thickness_squared: thickness * thickness,
            range,
            scale: (plain.range / range).powi(2),
            ..plain
        }
    }

    /// d̂: the distance between the surfaces, beyond the thickness, at which the barrier ends, in m.
    pub(crate) fn activation_distance(&self) -> f64 {
        self.activation_distance
    }

    /// Returns true if the barrier is positive at a squared distance d².
    pub(crate) fn is_active(&self, squared: f64) -> bool {
        self.reduced(squared) < self.range
    }

    /// The distance between the surfaces, d − ξ, in m. Without cancellation, it is D / (d + ξ).
    pub(crate) fn gap(&self, squared: f64) -> f64 {
        let distance = squared.sqrt();
        if self.thickness_squared == 0.0 {
            distance
        } else {
            self.reduced(squared) / (distance + self.thickness_squared.sqrt())
        }
    }

    /// The value at a squared distance d², in m⁴. Infinite for d ≤ ξ.
    pub(crate) fn value(&self, squared: f64) -> f64 {
        let reduced = self.reduced(squared);
        if reduced >= self.range {
            0.0
        } else if reduced <= 0.0 {
            f64::INFINITY
        } else {
            let gap = reduced - self.range;
            -gap * gap * (reduced / self.range).ln() * self.scale
        }
    }

    /// The first derivative by the squared distance, in m².
    pub(crate) fn slope(&self, squared: f64) -> f64 {
        let reduced = self.reduced(squared);
        if reduced >= self.range {
            return 0.0;
        }
        let gap = self.range - reduced;
        gap * (2.0 * (reduced / self.range).ln() - gap / reduced) * self.scale
    }

    /// The second derivative by the squared distance.
    pub(crate) fn curvature(&self, squared: f64) -> f64 {
        let reduced = self.reduced(squared);
        if reduced >= self.range {
            return 0.0;
        }
        let ratio = self.range / reduced;
        ((ratio + 2.0) * ratio - 2.0 * (reduced / self.range).ln() - 3.0) * self.scale
    }

    /// D = d² − ξ².
    fn reduced(&self, squared: f64) -> f64 {
        squared - self.thickness_squared
    }
}
