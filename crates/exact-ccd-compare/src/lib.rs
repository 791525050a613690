//! Comparison of methods of continuous collision detection on the same queries in the same run: table 1 of
//! the paper.
//!
//! [`Source`] finds data sets in a folder, [`Comparison`] runs methods and [peers](Peer) on them, [`Report`]
//! writes tables and charts, and [`plot`] has the style of the charts.

mod charts;
mod contestant;
mod peer;
pub mod plot;
mod process;
mod report;
mod run;
mod sampling;
mod setting;
mod source;
mod statistics;
mod table;
mod timed;

pub use contestant::Contestant;
pub use peer::{Peer, PeerError};
pub use report::Report;
pub use run::Comparison;
pub use sampling::{Subject, Subjects};
pub use setting::Setting;
pub use source::Source;
pub use statistics::TimeError;
pub use table::{Row, Sizes, Table};
