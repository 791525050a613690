//! Arrays of numpy: `.npy`, and `.npz` archives of several.

mod archive;
mod array;
mod elements;
mod header;
mod roles;
mod scene;

pub(super) use roles::Names;
pub(super) use scene::{Arrays, read_faces, read_npy, read_npz};
