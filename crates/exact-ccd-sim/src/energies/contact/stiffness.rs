//! The stiffness of the barrier.

use nalgebra::Vector3;

use super::barrier::Barrier;

/// The range of the barrier's stiffness κ, in kg/m², and its adaptation.
///
/// Source: *Incremental Potential Contact*, section 4.3, and section 3 of its supplement. There, the least κ
/// follows from the mean mass m of a vertex, whose inertia resists a displacement in a time step of the
/// duration h. The elastic stiffness k of a vertex resists it too, by h² k: here, a hundredth of h² k takes
/// the place of m where it is larger. So κ/h², the stiffness of the barrier as an energy, has a limit for
/// long time steps, and is constant for equilibria. A weight acts whatever the time step: the least κ is
/// also large enough for the weight of a vertex at half of the contact distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StiffnessRange {
    /// The least κ.
    pub(crate) least: f64,
    /// The greatest κ.
    pub(crate) greatest: f64,
    /// The distance in m below which the barrier counts as too soft.
    critical: f64,
}

/// The stiffness of the softest barrier at a distance of 10⁻⁸ of the scene's size, in means of m.
const LEAST_SCALE: f64 = 1e11;

impl StiffnessRange {
    /// The range for a scene of this `size` in m. `barrier` is the barrier without thickness, `inertia` the
    /// mean of m over the vertices or a hundredth of the mean of h² k, in kg, and `weight` the mean of h²
    /// times the weight, in kg m.
    pub(crate) fn new(size: f64, inertia: f64, weight: f64, barrier: &Barrier) -> Self {
        let distance = barrier.activation_distance();
        let near = (1e-16 * size * size).min(0.25 * distance * distance);
        let by_inertia = LEAST_SCALE * inertia / (4.0 * near * barrier.curvature(near));
        // The force of the barrier at the distance d is −2 d b'(d²) κ.
        let force = -distance * barrier.slope(0.25 * distance * distance);
        let least = by_inertia.max(weight / force);
        Self {
            least,
            greatest: 100.0 * least,
            critical: 1e-9 * size,
        }
    }

    /// Returns true if the range is positive and finite.
    pub(crate) fn is_valid(&self) -> bool {
        self.least > 0.0 && self.greatest.is_finite()
    }

    /// The κ in the range that minimises the norm of `energy` + κ `barriers`, which are the gradients of
    /// the energy without contact and of the barriers.
    pub(crate) fn balance(&self, energy: &[Vector3<f64>], barriers: &[Vector3<f64>]) -> f64 {
        let pairs = energy.iter().zip(barriers);
        let (along, squared) = pairs.fold((0.0, 0.0), |(along, squared), (energy, barrier)| {
            (along + energy.dot(barrier), squared + barrier.norm_squared())
        });
        // `max` replaces NaN, which follows from infinite or vanishing barriers, by the least κ.
        (-along / squared).max(self.least).min(self.greatest)
    }

    /// κ after an iteration that changed the least distance from `before` to `after`. It doubles if both
    /// distances are critical and the distance decreases.
    pub(crate) fn adapt(&self, stiffness: f64, before: f64, after: f64) -> f64 {
        if before < self.critical && after < self.critical && after < before {
            (2.0 * stiffness).min(self.greatest).max(stiffness)
        } else {
            stiffness
        }
    }
}
