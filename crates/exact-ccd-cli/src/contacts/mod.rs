//! Contacts and intersections in reports and in files of their own.

mod cells;
mod list;
#[cfg(feature = "queries")]
mod parquet;
mod places;
mod record;

pub(crate) use list::{ContactList, ListFile};
pub(crate) use record::{ContactRecord, HalfSpaceContact};
