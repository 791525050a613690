//! VTK's files: unstructured grids and surfaces, in XML and in the legacy format, and collections
//! of files.
//!
//! VTK documentation, *VTK File Formats*.

mod appended;
mod array;
mod blocks;
mod cell;
mod collection;
mod grid;
mod legacy;
mod list;
mod stream;
mod xml;

pub(super) use collection::{CollectionEntry, read as read_collection};
pub(super) use grid::read as read_grid;
pub(super) use legacy::read as read_legacy;
