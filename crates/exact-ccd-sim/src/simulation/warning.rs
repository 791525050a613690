//! Warnings about a simulation that is valid, but unlikely to be intended.

use std::fmt;

use exact_ccd_mesh::Step;

use super::Simulation;
use crate::contact::Collisions;
use crate::system::{System, designation};

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

impl Warning {
    /// The text of the warning with the names of the bodies of a system in place of their numbers.
    #[must_use]
    pub fn with_names(&self, system: &System) -> String {
        self.text(|body| system.designation(body))
    }

    fn text(&self, designation: impl Fn(usize) -> String) -> String {
        match *self {
            Self::ContactDistance { distance, body, size } => format!(
                "the contact distance, {distance:.3e} m, is more than a tenth of the size of {}, \
                 {size:.3e} m: surfaces stay visibly apart; set a smaller `contact-distance`",
                designation(body)
            ),
            Self::Near {
                bodies: (a, b),
                gap,
                distance,
            } => {
                let of_a = designation(a);
                let both = match b {
                    None => format!("{of_a} and a half space"),
                    Some(b) if b == a => format!("two parts of {of_a}"),
                    Some(b) => format!("{of_a} and {}", designation(b)),
                };
                format!(
                    "{both} start {gap:.3e} m apart, less than the contact distance, {distance:.3e} m: \
                     the barrier pushes them apart; set a smaller `contact-distance`, or place them farther apart"
                )
            }
        }
    }
}

/// The text with the numbers of bodies.
impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(|body| designation("body", body, "")))
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
