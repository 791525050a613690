//! Warnings about a simulation that is valid, but unlikely to be intended.

use std::fmt;

use super::Simulation;
use crate::system::Designation;

/// The largest contact distance without a warning, relative to the diagonal of the smallest body.
const COARSE: f64 = 0.1;

/// A property of a simulation that is valid, but unlikely to be intended.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// The contact distance is large for a body, which rests visibly apart from others.
    ContactDistance {
        /// The contact distance, in m.
        distance: f64,
        /// The smallest body.
        body: Designation,
        /// The diagonal of its bounding box, in m.
        size: f64,
    },
    /// Two bodies, two parts of one, or a body and a half space are within the contact distance. At the
    /// start, the barrier then pushes them apart in the first time steps.
    Near {
        /// The two bodies, or a body and a half space. Twice the same for parts of one body.
        bodies: [Designation; 2],
        /// The distance between their contact surfaces, in m.
        gap: f64,
        /// The contact distance, in m.
        distance: f64,
    },
    /// A rod without a shear modulus is curved at rest, and scripts hold both ends of a curved part. It moves
    /// by twist alone, without a force: a coil spring has no stiffness.
    Coil {
        /// The rod.
        body: Designation,
    },
    /// Many inner vertices of a shell have four edges along two directions, as in a grid with alternating
    /// diagonals. They do not resist twist.
    Twist {
        /// The shell.
        body: Designation,
        /// Their part of all inner vertices.
        part: f64,
    },
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ContactDistance { distance, body, size } => write!(
                f,
                "the contact distance, {distance:.3e} m, is more than a tenth of the size of {body}, {size:.3e} m: \
                 surfaces stay visibly apart; set a smaller `contact-distance`"
            ),
            Self::Near {
                bodies,
                gap,
                distance,
            } => write!(
                f,
                "{} start {gap:.3e} m apart, less than the contact distance, {distance:.3e} m: the barrier pushes \
                 them apart; set a smaller `contact-distance`, or place them farther apart",
                Designation::both(bodies)
            ),
            Self::Coil { body } => write!(
                f,
                "{body} is a rod that is curved at rest and has no `shear`: it twists without a torque, so that a \
                 coil spring has no stiffness; set `shear`, for an isotropic material \
                 young / (2 (1 + Poisson's ratio))"
            ),
            Self::Twist { body, part } => write!(
                f,
                "{body} is a shell, and {:.0} % of its inner vertices have four edges along two directions, as in a grid \
                 with alternating diagonals: they do not resist twist, so that the shell is too soft; use parallel \
                 diagonals, or irregular triangles",
                100.0 * part
            ),
        }
    }
}

impl Simulation {
    /// Warnings about the settings and the current positions: at most one of each kind.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let found = [self.coarse(), self.near(), self.coil(), self.twist()];
        found.into_iter().flatten().collect()
    }

    /// The warning about a shell that does not resist twist everywhere.
    fn twist(&self) -> Option<Warning> {
        let (body, part) = self.system.shell_without_twist()?;
        let body = self.system.bodies.designation(body);
        Some(Warning::Twist { body, part })
    }

    /// The warning about a rod that is curved at rest, held at both ends and without a shear modulus.
    fn coil(&self) -> Option<Warning> {
        let body = self.system.coil_without_shear()?;
        let body = self.system.bodies.designation(body);
        Some(Warning::Coil { body })
    }

    /// The warning that the contact distance is large for the smallest body. Single points have no size.
    fn coarse(&self) -> Option<Warning> {
        let distance = self.barrier.activation_distance();
        let sizes = self.system.bodies.sizes(&self.system.start).enumerate();
        let (body, size) = sizes
            .filter(|(_, size)| *size > 0.0)
            .min_by(|(_, a), (_, b)| a.total_cmp(b))?;
        let body = self.system.bodies.designation(body);
        (distance > COARSE * size).then_some(Warning::ContactDistance { distance, body, size })
    }

    /// The warning about the nearest two bodies that are within the contact distance.
    fn near(&self) -> Option<Warning> {
        let formulation = self.settings.formulation;
        let nearest = self
            .system
            .nearest(formulation, &self.state.positions, self.barrier);
        let (gap, bodies) = nearest?;
        let distance = self.barrier.activation_distance();
        Some(Warning::Near {
            bodies,
            gap,
            distance,
        })
    }
}
