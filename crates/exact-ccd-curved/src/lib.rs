//! Continuous collision detection of curved motion, certified.
//!
//! Points move on polynomials, rotate with rigid bodies, or follow any function with a bound on its
//! deviation from a chord ([`Trajectory`]). The step is cut into chords where that is needed. Each is an
//! exact query of [`exact_ccd`], with a bound of the deviation of both primitives as minimum separation
//! (Ferguson et al., Intersection-free Rigid Body Dynamics, 2021). The answer is a part of the step that
//! is certainly free, and a time by which the primitives have certainly come together.
//!
//! ```
//! use exact_ccd::{CONTACT, EdgeEdge};
//! use exact_ccd_curved::{Polynomial, RigidMotion, SearchOptions, Trajectory, time_of_impact};
//!
//! // A bar turns by two radians, from the x axis towards a post at y = 1: contact at a quarter turn.
//! let motion = RigidMotion::new([0.0; 3], [0.0, 0.0, 1.0], 2.0, [0.0; 3])?;
//! let bar = [[0.0; 3], [2.0, 0.0, 0.0]].map(|end| motion.point(end));
//! let post = [-1.0, 1.0].map(|z| Polynomial::new([[0.0, 1.0, z]]));
//!
//! let points: [&dyn Trajectory; 4] = [&bar[0], &bar[1], &post[0], &post[1]];
//! let options = SearchOptions::default().with_time_tolerance(1e-12);
//! let answer = time_of_impact::<EdgeEdge, _>(&points, CONTACT, &options)?;
//! let by = answer.within.expect("they meet").by;
//! let time = std::f64::consts::FRAC_PI_4;
//! assert!(answer.free_until <= time && time <= by && by - answer.free_until <= 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | item | contents |
//! |---|---|
//! | [`Trajectory`] | the two bounds that every answer rests on |
//! | [`Polynomial`] | control points or coefficients, of any degree |
//! | [`RigidMotion`] | rotation about an axis that moves in a straight line, as in a screw motion |
//! | [`FromFunctions`] | functions of the caller |
//! | [`time_of_impact`] | two primitives |
//! | [`curved_step`] | a mesh; [`Instances`] are rigid bodies, by their poses at two times |
//!
//! No function panics on any input, except where a function of the caller does.

mod answer;
mod crossing;
mod error;
mod function;
mod instances;
mod interval;
mod kind;
mod options;
mod polynomial;
mod pose;
mod proximity;
mod rigid;
mod rounding;
mod search;
mod sine;
mod step;
mod step_answer;
mod straight;
mod trajectory;

pub use answer::{Answer, End, Proximity, Within};
pub use error::SearchError;
pub use function::FromFunctions;
pub use instances::{Instance, InstanceError, Instances};
pub use kind::CurvedKind;
pub use options::SearchOptions;
pub use polynomial::Polynomial;
pub use pose::Pose;
pub use rigid::{RigidMotion, RigidMotionError, RigidPoint};
pub use search::time_of_impact;
pub use step::curved_step;
pub use step_answer::{CurvedStep, CurvedStepError, CurvedStepOptions};
pub use trajectory::{Position, Trajectory};

/// The examples in the README of this crate, as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
