//! The settings of a simulation.

use exact_ccd_mesh::Point;
use serde::{Deserialize, Serialize};

use crate::integrator::Integrator;
use crate::range::{OutOfRange, check, check_finite, check_not_negative, check_positive};

/// The settings of a simulation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Settings {
    /// The time step, in s.
    pub time_step: f64,
    /// The acceleration of gravity, in m/s².
    pub gravity: Point,
    /// The time integration.
    pub integrator: Integrator,
    /// The rate at which all velocities decay, in 1/s: accelerations have the part −`damping` v.
    pub damping: f64,
    /// The factor β of damping in proportion to the stiffness, in s: elastic elements have the forces −β K
    /// v, with their projected stiffness K at the start of the time step. A vibration of the angular
    /// frequency ω decays with the damping ratio β ω / 2.
    #[serde(skip_serializing_if = "is_default")]
    pub stiffness_damping: f64,
    /// The activation distance d̂ of the barrier: primitives that are closer repel each other.
    pub contact_distance: Length,
    /// The sum of barriers that repels surfaces.
    pub formulation: Formulation,
    /// The line search of Newton's method.
    pub line_search: LineSearch,
    /// Friction.
    pub friction: Friction,
    /// The tolerance of Newton's method, as a length per second.
    ///
    /// Newton stops when two conditions hold. No component of a vertex's Newton direction exceeds the
    /// tolerance times the effective time step, which is the time step for implicit Euler and two thirds
    /// of it for BDF2. And the predicted decrease of energy is at most the kinetic energy of all free
    /// masses at this speed.
    ///
    /// With friction, a tolerance above a tenth of the [static velocity](Friction::static_velocity) counts as
    /// that tenth. Below the static velocity friction is stiff, so that the Newton direction of a body that
    /// should start to slide is at most about that velocity, however far the body has to go.
    pub tolerance: Length,
    /// The maximal number of Newton iterations for each friction lag.
    pub max_iterations: usize,
    /// The maximal number of equal parts in which a time step is repeated if Newton's method does not
    /// converge or fails: 1, 2, 4 and so on, up to this number. With 1, time steps are never repeated.
    pub max_substeps: usize,
    /// The name of the CCD method. A simulation starts with `exact`, and takes the name of the filter that
    /// is passed to [`Simulation::with_filter`](crate::Simulation::with_filter).
    pub ccd: String,
}

/// True for a value that is the same as if it were not given.
fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// The largest tolerance with friction, relative to the static velocity.
const STATIC: f64 = 0.1;

impl Settings {
    /// The tolerance of Newton's method in m/s, for a scene of this [size](crate::System::size), in m.
    pub(crate) fn newton_tolerance(&self, size: f64) -> f64 {
        let tolerance = self.tolerance.meters(size);
        if self.friction.acts() {
            tolerance.min(STATIC * self.friction.static_velocity.meters(size))
        } else {
            tolerance
        }
    }

    /// Checks that all settings but the pairs of friction are in range, for a scene of this
    /// [size](crate::System::size), in m. [`Simulation::new`](crate::Simulation::new) checks the pairs.
    ///
    /// # Errors
    /// [`OutOfRange`] names the first setting that is out of range. Lengths are in m.
    pub fn check(&self, size: f64) -> Result<(), OutOfRange> {
        let (distance, friction) = (self.contact_distance.meters(size), &self.friction);
        check_positive("time-step", self.time_step)?;
        check_positive("contact-distance", distance)?;
        let square = distance * distance;
        let expected = "a length from about 1e-153 to 1e154 m";
        check(square.is_normal(), "contact-distance", distance, expected)?;
        // A larger distance would put all pairs of primitives in contact.
        let expected = "a length not above the size of the bodies with mass";
        check(distance <= size, "contact-distance", distance, expected)?;
        check_positive("tolerance", self.tolerance.meters(size))?;
        check_positive("friction.static-velocity", friction.static_velocity.meters(size))?;
        check_not_negative("friction.coefficient", friction.coefficient)?;
        check(friction.lags > 0, "friction.lags", friction.lags, "at least 1")?;
        check_not_negative("damping", self.damping)?;
        check_not_negative("stiffness-damping", self.stiffness_damping)?;
        let (substeps, expected) = (self.max_substeps, "a number from 1 to 1048576");
        check(
            (1..=1 << 20).contains(&substeps),
            "max-substeps",
            substeps,
            expected,
        )?;
        let iterations = self.max_iterations;
        check(iterations > 0, "max-iterations", iterations, "at least 1")?;
        check_finite("gravity", &self.gravity)
    }

    /// The names and the values of all settings, for their comparison. The case of a method's name does not
    /// matter.
    pub(crate) fn values(&self) -> [(&'static str, String); 16] {
        let Self {
            time_step,
            gravity,
            integrator,
            damping,
            stiffness_damping,
            contact_distance,
            formulation,
            line_search,
            friction,
            tolerance,
            max_iterations,
            max_substeps,
            ccd,
        } = self;
        let Friction {
            coefficient,
            pairs,
            static_velocity,
            lags,
        } = friction;
        [
            ("time-step", format!("{time_step:?}")),
            ("gravity", format!("{gravity:?}")),
            ("integrator", format!("{integrator:?}")),
            ("damping", format!("{damping:?}")),
            ("stiffness-damping", format!("{stiffness_damping:?}")),
            ("contact-distance", format!("{contact_distance:?}")),
            ("formulation", format!("{formulation:?}")),
            ("line-search", format!("{line_search:?}")),
            ("friction.coefficient", format!("{coefficient:?}")),
            ("friction.pair", format!("{pairs:?}")),
            ("friction.static-velocity", format!("{static_velocity:?}")),
            ("friction.lags", format!("{lags:?}")),
            ("tolerance", format!("{tolerance:?}")),
            ("max-iterations", format!("{max_iterations:?}")),
            ("max-substeps", format!("{max_substeps:?}")),
            ("ccd", ccd.to_lowercase()),
        ]
    }
}

/// The sum of barriers that repels surfaces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Formulation {
    /// An integral over the surface of the barrier of the distance: a body at rest on a plane of triangles
    /// does not drift.
    #[default]
    Convergent,
    /// The sum over all pairs of primitives, as in *Incremental Potential Contact*. Near edges of a plane of
    /// triangles, it has forces along the plane.
    Sum,
}

/// The line search of Newton's method where contact limits a Newton direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LineSearch {
    /// All vertices take the same part of the direction.
    #[default]
    Common,
    /// Each vertex takes a part of its own, so that only vertices near a contact are held back; or all the
    /// same part, where this does not decrease the potential enough. The CCD method must be exact.
    Vertex,
}

/// A length, absolute or relative to the scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Length {
    /// In m.
    Absolute(f64),
    /// As a fraction of [`System::size`](crate::System::size): the diameter of the smallest ball around all
    /// bodies with mass at the start.
    Relative(f64),
}

impl Length {
    /// The length in m, for a scene of this [size](crate::System::size), in m.
    #[must_use]
    pub fn meters(self, size: f64) -> f64 {
        match self {
            Self::Absolute(meters) => meters,
            Self::Relative(share) => share * size,
        }
    }
}

/// Friction between all surfaces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Friction {
    /// The friction coefficient μ of all pairs of bodies without one of their own.
    pub coefficient: f64,
    /// The pairs of bodies with a coefficient of their own; the last pair of two bodies counts.
    #[serde(rename = "pair", skip_serializing_if = "Vec::is_empty")]
    pub pairs: Vec<FrictionPair>,
    /// The slip velocity below which friction is static.
    pub static_velocity: Length,
    /// The greatest number of friction lags: updates of normal forces and tangent planes in a time step. At
    /// least 1. They end with the first update after which Newton's method converges in one iteration: with
    /// a large number, the forces of friction belong to the end of the time step, within the tolerance. An
    /// attempt that is not the last ends with the first lag that does not converge.
    pub lags: usize,
}

/// The friction between bodies with two names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct FrictionPair {
    /// The names of bodies or half spaces. Repeat a name for friction among bodies of that name, self-contact
    /// included.
    pub between: [String; 2],
    /// The friction coefficient μ.
    pub coefficient: f64,
}

impl Friction {
    /// Returns true if the coefficient of a pair is positive.
    pub(crate) fn acts(&self) -> bool {
        self.coefficient > 0.0 || self.pairs.iter().any(|pair| pair.coefficient > 0.0)
    }
}

impl Default for Settings {
    /// Implicit Euler with time steps of 0.01 s, gravity along −y, no friction, and the lengths of
    /// *Incremental Potential Contact*.
    fn default() -> Self {
        Self {
            time_step: 0.01,
            gravity: [0.0, -9.81, 0.0],
            integrator: Integrator::default(),
            damping: 0.0,
            stiffness_damping: 0.0,
            contact_distance: Length::Relative(1e-3),
            formulation: Formulation::default(),
            line_search: LineSearch::default(),
            friction: Friction::default(),
            tolerance: Length::Relative(1e-2),
            max_iterations: 100,
            max_substeps: 8,
            ccd: "exact".to_owned(),
        }
    }
}

impl Default for Friction {
    /// No friction. Three lags: the first one has the forces of the last time step, the second those at the
    /// end of this one, and the third corrects them.
    fn default() -> Self {
        Self {
            coefficient: 0.0,
            pairs: Vec::new(),
            static_velocity: Length::Relative(1e-3),
            lags: 3,
        }
    }
}
