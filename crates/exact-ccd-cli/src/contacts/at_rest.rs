//! Primitives at rest, without the place where they meet.

use exact_ccd_mesh::{Intersection, Pair, TriangleMesh};

use super::record::{ContactRecord, RecordKind};

impl ContactRecord {
    /// A pair that touches at rest, in a frame, without the place.
    pub(crate) fn of_pair(frame: usize, mesh: &TriangleMesh, pair: Pair) -> Self {
        let vertices = pair.vertices(mesh).expect("the pair is one of the mesh");
        let (first, second) = vertices.split_at(pair.kind().sizes()[0]);
        let vertices = [first.to_vec(), second.to_vec()];
        Self {
            frame,
            kind: RecordKind::Pair(pair.kind()),
            ids: pair.ids().map(Some),
            mesh_vertices: vertices.clone(),
            vertices,
            ..Self::default()
        }
    }

    /// An edge that passes through a face, in a frame, without the place.
    pub(crate) fn of_crossing(frame: usize, mesh: &TriangleMesh, crossing: Intersection) -> Self {
        let Intersection { edge, face } = crossing;
        let vertices = [
            mesh.edges()[edge as usize].to_vec(),
            mesh.faces()[face as usize].to_vec(),
        ];
        Self {
            frame,
            kind: RecordKind::EdgeFace,
            ids: [Some(edge), Some(face)],
            mesh_vertices: vertices.clone(),
            vertices,
            ..Self::default()
        }
    }

    /// A face as the second primitive, to name it and its body.
    #[cfg(feature = "repair")]
    pub(crate) fn of_face(mesh: &TriangleMesh, face: u32) -> Self {
        let corners = mesh.faces()[face as usize].to_vec();
        Self {
            ids: [None, Some(face)],
            mesh_vertices: [corners.clone(), corners],
            ..Self::default()
        }
    }
}
