//! Continuous collision detection of curved motion, certified.
mod answer;
mod crossing;
mod error;
mod function;
mod instances;
mod kind;
mod options;
mod polynomial;
mod pose;
mod rigid;
mod rounding;
mod search;
mod step;
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
pub use search::first_within;
pub use step::{CurvedStep, CurvedStepError, CurvedStepOptions, curved_step};
pub use trajectory::{Position, Trajectory};
