//! Errors of a simulation.

use exact_ccd_mesh::{MotionError, Point};

use crate::range::OutOfRange;
use crate::system::{BodyPrimitive, Designation};

/// An error at the start of a simulation or in a time step.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SimulationError {
    /// A setting is out of range.
    #[error(transparent)]
    Setting(#[from] OutOfRange),
    /// A pair of friction has a negative coefficient, or names a body that does not exist.
    #[error("friction pair {pair}: {source}")]
    FrictionPair {
        /// The place of the pair in [`Friction::pairs`](crate::Friction::pairs), from 0.
        pair: usize,
        /// The coefficient or the name.
        source: OutOfRange,
    },
    /// The settings name another CCD method than `exact`, which only the caller can pass.
    #[error(
        "the settings name the CCD method `{name}`, expected `exact`: pass other methods to `with_filter`"
    )]
    Method {
        /// The name in the settings.
        name: String,
    },
    /// The state belongs to another system.
    #[error("the state has {found} {what}, expected {expected}, one for each vertex of the system")]
    State {
        /// `positions`, `velocities`, and so on.
        what: &'static str,
        /// The number of entries.
        found: usize,
        /// The number of vertices of the system.
        expected: usize,
    },
    /// A number of the state is out of range.
    #[error("the state is invalid: {0}")]
    InState(OutOfRange),
    /// The surface of the system has too many primitives.
    #[error(transparent)]
    Surface(#[from] MotionError),
    /// The checkpoint has another value of a setting.
    #[error(
        "the checkpoint has `{what}` = {there}, expected {here} as in the settings: \
         resume with the settings of the checkpoint, or start a new run"
    )]
    OtherSetting {
        /// The name of the setting: the path of fields in [`Settings`](crate::Settings) with dots, and
        /// hyphens for underscores.
        what: &'static str,
        /// Its value in the checkpoint.
        there: String,
        /// Its value in the settings.
        here: String,
    },
    /// The checkpoint identifies its system by hashes of another definition.
    #[error(
        "the checkpoint was saved by another version of the simulator: \
         resume with that version, or start a new run"
    )]
    OtherVersion,
    /// The checkpoint belongs to another system.
    #[error(
        "the checkpoint belongs to a system with other {what}: \
         resume with the scene of the checkpoint, or start a new run"
    )]
    OtherSystem {
        /// The first part that differs: `positions`, `elements`, `velocities`, `bodies`, `materials`,
        /// `scripts`, `half spaces`, `loads` or `springs`.
        what: &'static str,
    },
    /// Two primitives intersect or touch at the start.
    #[error(
        "{} and {} intersect or touch at the start, near {near:?}, expected a positive distance between them",
        primitives[0], primitives[1]
    )]
    Start {
        /// The two primitives.
        primitives: Box<[BodyPrimitive; 2]>,
        /// The position of one of their vertices, in m.
        near: Point,
    },
    /// Two primitives start nearer than the thickness of their surfaces.
    #[error(
        "{} and {} are within the sum of their offsets, {thickness} m, at the start, near {near:?}, \
         expected a larger distance between them",
        primitives[0], primitives[1]
    )]
    Close {
        /// The two primitives.
        primitives: Box<[BodyPrimitive; 2]>,
        /// The sum of the offsets of their bodies, in m.
        thickness: f64,
        /// The position of one of their vertices, in m.
        near: Point,
    },
    /// A vertex touches a half space at the start, or is inside.
    #[error(
        "{vertex} touches {half_space} at the start, or is inside of it, at {near:?}, \
         expected a positive distance above the offset of the body"
    )]
    Grounded {
        /// The vertex.
        vertex: BodyPrimitive,
        /// The half space.
        half_space: Designation,
        /// The position of the vertex, in m.
        near: Point,
    },
    /// The CCD method has no minimum separation.
    #[error(
        "the CCD method `{name}` has no minimum separation, which bodies with an offset need, \
         expected `exact` or another exact method"
    )]
    Offset {
        /// The name of the CCD method.
        name: String,
    },
    /// The line search by vertex needs exact times of contact.
    #[error(
        "`line-search` is `vertex`, but the CCD method `{name}` has no exact times of contact, \
         expected `exact` or another exact method, or the line search `common`"
    )]
    ByVertex {
        /// The name of the CCD method.
        name: String,
    },
    /// The vertices of an affine body take no parts of their own.
    #[error(
        "`line-search` is `vertex`, but {body} is affine, so that its vertices take no parts of their own, expected \
         the line search `common`"
    )]
    AffineByVertex {
        /// The body.
        body: Designation,
    },
    /// The linear system of a Newton iteration has no finite solution: forces are not finite, or their
    /// magnitudes differ too much.
    #[error(
        "step {step}: the linear system of Newton's method has no solution; the forces are largest on {body}: \
         set a smaller `time-step`, or check the numbers of its material, velocity and loads"
    )]
    Singular {
        /// The number of the step.
        step: u64,
        /// The body on which the forces are largest or not finite.
        body: Designation,
    },
    /// The flag of [`Simulation::with_interrupt`](crate::Simulation::with_interrupt) is true.
    #[error("step {step}: interrupted")]
    Interrupted {
        /// The number of the step, which has not been taken.
        step: u64,
    },
    /// The CCD method rejects a Newton step of any positive length.
    #[error(
        "step {step}: the CCD method `{filter}` rejects a Newton step of any length{}, \
         expected a positive step size; the method `exact` has no false positives",
        because_of(pair.as_deref())
    )]
    Blocked {
        /// The number of the step.
        step: u64,
        /// The name of the CCD method.
        filter: String,
        /// Two primitives for which the method rejects every length. `None` if it accepts each pair alone, or
        /// if a half space is in the way.
        pair: Option<Box<[BodyPrimitive; 2]>>,
    },
}

/// The rejected primitives, as a part of a sentence.
fn because_of(pair: Option<&[BodyPrimitive; 2]>) -> String {
    let named = pair.map(|[a, b]| format!(" because of {a} and {b}"));
    named.unwrap_or_default()
}
