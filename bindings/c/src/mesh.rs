//! Meshes.

use std::sync::Arc;

use exact_ccd_mesh::TriangleMesh;

use crate::border::call;
use crate::error::{Error, Status};
use crate::pointers::{Out, array, fill, free, places, reference};

/// The connectivity of a mesh: faces, edges and vertices. It never changes.
pub struct Mesh(pub(crate) Arc<TriangleMesh>);

/// A mesh of `face_count` faces, each three vertices from 0, and `edge_count` edges that may be
/// edges of no face (rods), each two vertices. Vertices of no face and no edge are points.
///
/// The edges of the mesh are the edges of its faces, each once, as pairs i < j sorted by j, then by i; then
/// the given edges that are not among them, in the same order. Counts may be 0, and their arrays null then.
/// The mesh is freed with `exact_ccd_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_mesh_new(
    vertex_count: usize,
    faces: *const u32,
    face_count: usize,
    edges: *const u32,
    edge_count: usize,
    mesh: *mut *mut Mesh,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (mesh, faces, edges) = unsafe {
            let mesh = Out::new("mesh", mesh)?;
            let faces = array("faces", faces.cast::<[u32; 3]>(), face_count)?;
            let edges = array("edges", edges.cast::<[u32; 2]>(), edge_count)?;
            (mesh, faces, edges)
        };
        let new = TriangleMesh::with_edges(vertex_count, faces.to_vec(), edges)?;
        mesh.give(Mesh(Arc::new(new)));
        Ok(())
    })
}

/// The numbers of faces, edges (of faces first) and edges of no face.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_mesh_counts(
    mesh: *const Mesh,
    face_count: *mut usize,
    edge_count: *mut usize,
    loose_edge_count: *mut usize,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        unsafe {
            let Mesh(mesh) = reference("mesh", mesh)?;
            let places = [
                Out::new("face_count", face_count)?,
                Out::new("edge_count", edge_count)?,
                Out::new("loose_edge_count", loose_edge_count)?,
            ];
            let counts = [mesh.faces().len(), mesh.edges().len(), mesh.loose_edges().len()];
            for (place, count) in places.into_iter().zip(counts) {
                place.write(count);
            }
        }
        Ok(())
    })
}

/// Writes the two vertices of each edge to `edges`, which has room for `edge_count` edges. Contacts
/// name edges by their index here.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_mesh_edges(
    mesh: *const Mesh,
    edges: *mut u32,
    edge_count: usize,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (mesh, edges) = unsafe {
            let Mesh(mesh) = reference("mesh", mesh)?;
            let edges = places("edges", edges.cast::<[u32; 2]>(), edge_count)?;
            (mesh, edges)
        };
        if edges.len() != mesh.edges().len() {
            return Err(Error::argument(format_args!(
                "edge_count is {}, but the mesh has {} edges",
                edges.len(),
                mesh.edges().len()
            )));
        }
        fill(edges, mesh.edges().iter().copied());
        Ok(())
    })
}

/// Frees a mesh. Detectors of the mesh keep what they need. Null is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_mesh_free(mesh: *mut Mesh) {
    // SAFETY: the caller's promise.
    unsafe { free(mesh) }
}
