//! Meshes at rest.

use exact_ccd_mesh::intersections;

use crate::border::call;
use crate::error::Status;
use crate::mesh::Mesh;
use crate::pointers::{positions, reference, reference_mut};

/// Decides if a mesh at rest passes through itself: if an edge and a face without a common vertex
/// have a common point. `edge` and `face` are the first such pair; both may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_has_intersections(
    mesh: *const Mesh,
    x: *const f64,
    vertex_count: usize,
    has_intersections: *mut bool,
    edge: *mut u32,
    face: *mut u32,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        unsafe {
            let Mesh(mesh) = reference("mesh", mesh)?;
            let x = positions("x", x, vertex_count)?;
            let has_intersections = reference_mut("has_intersections", has_intersections)?;
            let found = intersections(mesh, x)?;
            *has_intersections = !found.is_empty();
            if let Some(first) = found.first() {
                if let Ok(edge) = reference_mut("edge", edge) {
                    *edge = first.edge;
                }
                if let Ok(face) = reference_mut("face", face) {
                    *face = first.face;
                }
            }
        }
        Ok(())
    })
}
