//! Mesh files of all formats: the meshes that they become, and the errors.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod arrays;
mod contents;
mod encodings;
mod frame_order;
mod gltf;
mod gmsh;
mod groups;
mod hostile_input;
mod hostile_size;
mod in_use;
mod loose;
mod motion;
mod named_parts;
mod npz;
mod numpy;
mod point_cache;
mod polygons;
mod read_errors;
mod same_frame;
mod vtk;
mod vtk_legacy;
mod vtk_read;

use std::path::{Path, PathBuf};

/// Writes a file below the temporary folder of the tests and returns its path.
fn temporary(name: &str, contents: impl AsRef<[u8]>) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("formats").join(name);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(&path, contents).unwrap();
    path
}
