//! Motion on curves, decided exactly: Bézier curves, rigid bodies, chains of joints.
//!
//! A point of a [`Bezier`] motion moves on a polynomial curve; free fall has degree 2. A [`RigidMotion`]
//! turns a body by a linear quaternion, and a [`Chain`] is a product of rigid motions. The place of every
//! point is a quotient of polynomials in t, so that the answers are exact, as for straight motion: no
//! contact is missed, none is invented, and times are rounded down. `docs/curved-motion.md` has the
//! definition and the degrees.
//!
//! Floating-point filters decide most queries; where they do not, integers do, as in
//! [`Query::exactly`](crate::Query::exactly).

mod bezier;
mod body_pair;
mod chain;
mod curved_query;
mod error;
mod pose;
mod rigid_motion;

pub use bezier::Bezier;
pub use body_pair::BodyPair;
pub use chain::Chain;
pub use curved_query::CurvedQuery;
pub use error::InvalidMotion;
pub use pose::Pose;
pub use rigid_motion::RigidMotion;
