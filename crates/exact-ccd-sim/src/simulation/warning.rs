//! Warnings about a simulation that is valid, but unlikely to be intended.

use std::fmt;

use exact_ccd_mesh::Step;

use super::Simulation;
use crate::contact::Collisions;

/// The largest contact distance without a warning, relative to the diagonal of the smallest body.
const COARSE: f64 = 0.1;

/// A property of a simulation that is valid, but unlikely to be intended.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// The contact distance is large for a body, which rests visibly apart from others.
    ContactDistance {
        /// The contact distance, in m.
        distance: f64,
        /// The smallest body, by its place in the list of bodies.
        body: usize,
        /// The diagonal of its bounding box, in m.
        size: f64,
    },
    /// Two bodies, two parts of one, or a body and a half space are within the contact distance. At the
    /// start, the barrier then pushes them apart in the first time steps.
    Near {
        /// The two bodies, by their places in the list of bodies: twice the same for parts of one body, and
        /// `None` for a half space.
        bodies: (usize, Option<usize>),
        /// The distance between their contact surfaces, in m.
        gap: f64,
        /// The contact distance, in m.
        distance: f64,
    },
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::ContactDistance { distance, body, size } => write!(
                f,
                "the contact distance, {distance:.3e} m, is more than a tenth of the size of body[{body}], \
                 {size:.3e} m: surfaces stay visibly apart; set a smaller `contact-distance`"
            ),
            Self::Near {
                bodies: (a, b),
                gap,
                distance,
            } => {
                match b {
                    None => write!(f, "body[{a}] and a half space")?,
                    Some(b) if b == a => write!(f, "two parts of body[{a}]")?,
                    Some(b) => write!(f, "body[{a}] and body[{b}]")?,
                }
                write!(f, " start {gap:.3e} m apart, ")?;
                write!(
                    f,
                    "less than the contact distance, {distance:.3e} m: the barrier pushes them apart; \
                     set a smaller `contact-distance`, or place them farther apart"
                )
            }
        }
    }
}

impl Simulation {
    /// Warnings about the settings and the current positions: at most one of each kind.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        self.coarse().into_iter().chain(self.near()).collect()
    }

    /// The warning that the contact distance is large for the smallest body. Single points have no size.
    fn coarse(&self) -> Option<Warning> {
        let distance = self.barrier.activation_distance();
        let sizes = self.system.body_sizes().enumerate();
        let (body, size) = sizes
            .filter(|(_, size)| *size > 0.0)
            .min_by(|(_, a), (_, b)| a.total_cmp(b))?;
        (distance > COARSE * size).then_some(Warning::ContactDistance { distance, body, size })
    }

    /// The warning about the nearest two bodies that are within the contact distance.
    fn near(&self) -> Option<Warning> {
        let positions = &self.state.positions;
        let step = Step::new(&self.system.surface, positions, positions).ok()?;
        let candidates = self.system.near(step, &self.barrier);
        let surface = self.system.contact_surface(self.settings.formulation);
        let (gap, collision) = Collisions::nearest(surface, &candidates, positions, self.barrier)?;
        let [a, b] = self.system.bodies_of(&collision);
        let is_half_space = collision.half_space().is_some();
        let distance = self.barrier.activation_distance();
        Some(Warning::Near {
            bodies: (a.min(b), (!is_half_space).then_some(a.max(b))),
            gap,
            distance,
        })
    }
}
