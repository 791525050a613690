//! The search for contacts: exact tests of pairs, among all candidates of a step, or in step after step with
//! few tests.

mod answers;
mod candidates;
mod chunks;
mod clearances;
mod collect;
mod contact;
mod contact_points;
mod culled_search;
mod detector;
mod first_contacts;
mod kept;
mod method;
mod narrow_phase;
mod pair_collision;
mod report;
mod screen;
mod worlds;

pub use candidates::Candidates;
pub use contact::Contact;
pub use contact_points::contact_points;
pub use detector::Detector;
pub use first_contacts::FirstContacts;
pub use report::{StepReport, step};
pub use worlds::Worlds;

pub(crate) use collect::{AnyContact, Collect, Earliest, Relevant};
pub(crate) use culled_search::CulledSearch;
pub(crate) use pair_collision::PairCollision;
