//! The mesh that is examined of a part: without wires and points, or with welded vertices.

use exact_ccd_mesh::vector::minus;
use exact_ccd_mesh::{Frame, Point, TriangleMesh, Welding};
use serde::Serialize;

/// The changes to the mesh of a file, the same in all frames.
#[derive(Default)]
pub(super) struct Shape {
    /// The vertices of faces in the file, if all else is left out.
    of_faces: Option<Vec<u32>>,
    welding: Option<Welding>,
    mesh: TriangleMesh,
}

/// The numbers of loose edges and points that `--faces-only` has left out.
#[derive(Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub(crate) struct LeftOut {
    pub(super) loose_edges: usize,
    pub(super) points: usize,
}

impl Shape {
    /// The mesh as it is.
    pub(super) fn of(mesh: TriangleMesh) -> Self {
        Self {
            mesh,
            ..Self::default()
        }
    }

    /// The faces of a mesh, and the numbers of loose edges and points that are left out.
    pub(super) fn of_faces(mesh: &TriangleMesh) -> (Self, LeftOut) {
        let faces = TriangleMesh::new(mesh.vertex_count(), mesh.faces().to_vec());
        let (faces, vertices) = faces.unwrap_or_default().without_unused_vertices();
        let left_out = LeftOut {
            loose_edges: mesh.loose_edges().len(),
            points: mesh
                .loose_vertices()
                .filter(|vertex| vertices.binary_search(vertex).is_err())
                .count(),
        };
        let shape = Self {
            of_faces: Some(vertices),
            welding: None,
            mesh: faces,
        };
        (shape, left_out)
    }

    /// The same shape with welded vertices; `mesh` is its mesh.
    pub(super) fn welded(self, welding: Welding, mesh: TriangleMesh) -> Self {
        Self {
            welding: Some(welding),
            mesh,
            ..self
        }
    }

    pub(super) fn mesh(&self) -> &TriangleMesh {
        &self.mesh
    }

    pub(super) fn is_welded(&self) -> bool {
        self.welding.is_some()
    }

    /// Returns true if the mesh is another one than in the file.
    pub(super) fn is_changed(&self) -> bool {
        self.welding.is_some() || self.of_faces.is_some()
    }

    /// The values of the vertices in the mesh, from the values of the vertices in the file.
    pub(super) fn of_vertices<T: Copy>(&self, in_file: &[T]) -> Vec<T> {
        let all: Vec<T> = match &self.of_faces {
            Some(vertices) => vertices
                .iter()
                .filter_map(|&vertex| in_file.get(vertex as usize).copied())
                .collect(),
            None => in_file.to_vec(),
        };
        match &self.welding {
            Some(welding) => welding
                .first_vertices()
                .iter()
                .filter_map(|&vertex| all.get(vertex).copied())
                .collect(),
            None => all,
        }
    }

    /// The number of vertices that are welded to others in a frame of the file with these positions, but not
    /// in the same place, and their greatest distance, rounded.
    pub(super) fn joined(&self, in_file: &[Point]) -> (usize, f64) {
        let unwelded = Self {
            of_faces: self.of_faces.clone(),
            ..Self::default()
        };
        let (all, kept) = (unwelded.of_vertices(in_file), self.of_vertices(in_file));
        let place = |vertex: u32| {
            let welded = self.welding.as_ref()?.vertex_of(vertex)?;
            kept.get(welded as usize)
        };
        let distances = (0..).zip(&all).filter_map(|(vertex, &position)| {
            let [x, y, z] = minus(position, *place(vertex)?);
            Some(x.hypot(y).hypot(z))
        });
        distances
            .filter(|distance| *distance > 0.0)
            .fold((0, 0.0), |(count, most), distance| {
                (count + 1, distance.max(most))
            })
    }

    /// The frame of a file, changed.
    pub(super) fn frame(&self, frame: Frame) -> Frame {
        if !self.is_changed() {
            return frame;
        }
        let positions: Vec<Point> = self.of_vertices(&frame.positions);
        Frame {
            mesh: self.mesh.clone(),
            positions,
        }
    }

    /// The vertices in the mesh for vertices in the file, without vertices that are left out.
    pub(super) fn vertices(&self, in_file: &[u32]) -> Vec<u32> {
        let vertex = |&vertex: &u32| {
            let kept = match &self.of_faces {
                Some(vertices) => vertices.binary_search(&vertex).ok()? as u32,
                None => vertex,
            };
            Some(
                self.welding
                    .as_ref()
                    .and_then(|welding| welding.vertex_of(kept))
                    .unwrap_or(kept),
            )
        };
        in_file.iter().filter_map(vertex).collect()
    }
}
