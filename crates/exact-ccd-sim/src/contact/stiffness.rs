//! How stiff the barrier is.

use nalgebra::Vector3;

use super::barrier::Barrier;

/// The range of the barrier's stiffness κ, in kg/m², and its adaptation: *Incremental Potential Contact*, section 4.3, and
/// section 3 of its supplement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StiffnessRange {
    /// The least κ.
    pub least: f64,
    /// The greatest κ.
    pub greatest: f64,
    /// The distance in m below which the barrier is too soft.
    critical: f64,
}

/// How stiff the least barrier is at a distance of 10⁻⁸ of the scene's size, in masses of an average vertex.
const LEAST_SCALE: f64 = 1e11;

impl StiffnessRange {
    /// The range for a scene of a size (its bounding box's diagonal, in m) whose vertices have a mean mass (in kg).
    #[must_use]
    pub fn new(size: f64, mean_mass: f64, barrier: &Barrier) -> Self {
        let near = (1e-16 * size * size).min(0.25 * barrier.reach());
        let least = LEAST_SCALE * mean_mass / (4.0 * near * barrier.curvature(near));
        Self {
            least,
            greatest: 100.0 * least,
            critical: 1e-9 * size,
        }
    }

    /// Whether there is such a range, among positive f64.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        self.least > 0.0 && self.greatest.is_finite()
    }

    /// The κ with which the barriers balance the other forces best, in the range.
    #[must_use]
    pub fn balance(&self, energy: &[Vector3<f64>], barriers: &[Vector3<f64>]) -> f64 {
        let pairs = energy.iter().zip(barriers);
        let (along, squared) = pairs.fold((0.0, 0.0), |(along, squared), (energy, barrier)| {
            (along + energy.dot(barrier), squared + barrier.norm_squared())
        });
        // NaN, of barriers that are infinite or none, is the least.
        (-along / squared).max(self.least).min(self.greatest)
    }

    /// κ after an iteration that took the least distance from `before` to `after`: twice as stiff if both are critical and
    /// it shrinks.
    #[must_use]
    pub fn adapt(&self, stiffness: f64, before: f64, after: f64) -> f64 {
        if before < self.critical && after < self.critical && after < before {
            (2.0 * stiffness).min(self.greatest).max(stiffness)
        } else {
            stiffness
        }
    }
}
