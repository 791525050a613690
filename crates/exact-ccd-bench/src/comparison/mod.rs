//! Methods against each other, on the same queries and in the same run: the paper's table 1.

mod contestant;
mod peer;
mod plots;
mod report;
mod run;
mod sampling;
mod setting;
mod source;
mod table;

pub use contestant::Contestant;
pub use peer::{Peer, PeerError};
pub use report::Report;
pub use run::Comparison;
pub use sampling::{Subject, Subjects};
pub use setting::Setting;
pub use source::Source;
pub use table::{Row, Table, TimeError};
