//! VTK's XML files: unstructured grids, and collections of them.
//!
//! VTK documentation, *XML File Formats*.

mod array;
mod collection;
mod grid;
mod xml;

pub(super) use collection::read as read_collection;
pub(super) use grid::read as read_grid;
