//! The names and numbers of the two kinds of query in the published scenes.

use exact_ccd::{EdgeEdge, Kind, Point, VertexFace};
use exact_ccd_mesh::{PairKind, TriangleMesh};

/// A kind of query of the published scenes and folders of query files. The names of its files in a
/// scene end in its [short name](exact_ccd::AnyKind::short).
pub trait DataKind: PairKind + Kind<Points = [Point; 4], Vertices = [u32; 4]> {
    /// The folder of its handcrafted query files.
    const FOLDER: &'static str = Self::KIND.name();

    /// The indices of the two primitives of a mesh with these global ids, or `None` if they are not
    /// a pair of this kind. Ids count the vertices, then the edges, then the faces.
    fn indices(ids: [usize; 2], mesh: &TriangleMesh) -> Option<[u32; 2]>;

    /// The global ids of two primitives of a mesh: the inverse of [`indices`](Self::indices).
    fn ids(indices: [u32; 2], mesh: &TriangleMesh) -> [u64; 2];
}

impl DataKind for VertexFace {
    fn indices([vertex, face]: [usize; 2], mesh: &TriangleMesh) -> Option<[u32; 2]> {
        let face = face.checked_sub(mesh.vertex_count() + mesh.edges().len())?;
        Some([
            index(vertex, mesh.vertex_count())?,
            index(face, mesh.faces().len())?,
        ])
    }

    fn ids([vertex, face]: [u32; 2], mesh: &TriangleMesh) -> [u64; 2] {
        let first_face = mesh.vertex_count() + mesh.edges().len();
        [vertex.into(), u64::from(face) + first_face as u64]
    }
}

impl DataKind for EdgeEdge {
    fn indices([a, b]: [usize; 2], mesh: &TriangleMesh) -> Option<[u32; 2]> {
        let edge = |id: usize| index(id.checked_sub(mesh.vertex_count())?, mesh.edges().len());
        Some([edge(a)?, edge(b)?])
    }

    fn ids(indices: [u32; 2], mesh: &TriangleMesh) -> [u64; 2] {
        indices.map(|edge| u64::from(edge) + mesh.vertex_count() as u64)
    }
}

fn index(id: usize, count: usize) -> Option<u32> {
    u32::try_from(id).ok().filter(|_| id < count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_count_vertices_then_edges_then_faces() {
        let mesh = TriangleMesh::new(4, vec![[0, 1, 2], [1, 2, 3]]).unwrap();
        assert_eq!(mesh.edges().len(), 5);
        assert_eq!(VertexFace::indices([3, 9], &mesh), Some([3, 0]));
        assert_eq!(VertexFace::indices([0, 10], &mesh), Some([0, 1]));
        assert_eq!(EdgeEdge::indices([4, 8], &mesh), Some([0, 4]));
        assert_eq!(VertexFace::ids([3, 0], &mesh), [3, 9]);
        assert_eq!(EdgeEdge::ids([0, 4], &mesh), [4, 8]);
        for ids in [[4, 9], [0, 8], [0, 11], [9, 0]] {
            assert_eq!(VertexFace::indices(ids, &mesh), None, "{ids:?}");
        }
        for ids in [[3, 4], [4, 9], [9, 4]] {
            assert_eq!(EdgeEdge::indices(ids, &mesh), None, "{ids:?}");
        }
    }
}
