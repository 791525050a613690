//! Contacts and intersections in reports and in files of their own.

mod at_rest;
mod cells;
mod list;
mod of_bodies;
mod places;
mod record;
mod rounding;

pub(crate) use list::{ContactList, ListFile};
pub(crate) use of_bodies::PartPrimitive;
pub(crate) use record::{Bounds, ContactRecord, Owners, RecordKind, unsigned_zero};
pub(crate) use rounding::note_of_rounding;
