//! The connectivity of a triangle mesh.

/// The faces of a triangle mesh and the edges that they share.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TriangleMesh {
    vertex_count: usize,
    faces: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
}

/// A face names a vertex that the mesh does not have.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("face {face} names vertex {vertex}, but there are only {vertex_count} vertices")]
pub struct IndexOutOfRange {
    /// The index of the face, from 0.
    pub face: usize,
    /// The vertex that it names, from 0.
    pub vertex: u32,
    /// How many vertices there are.
    pub vertex_count: usize,
}

impl TriangleMesh {
    /// The mesh of these faces, each three indices of vertices from 0.
    ///
    /// # Errors
    /// [`IndexOutOfRange`] names the first face with an index that is not below `vertex_count`.
    pub fn new(vertex_count: usize, faces: Vec<[u32; 3]>) -> Result<Self, IndexOutOfRange> {
        for (face, corners) in faces.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= vertex_count) {
                return Err(IndexOutOfRange {
                    face,
                    vertex,
                    vertex_count,
                });
            }
        }
        let edges = edges_of(&faces);
        Ok(Self {
            vertex_count,
            faces,
            edges,
        })
    }

    /// The same faces among those vertices alone that have one, in the same order; and the number that each of these has here.
    ///
    /// ```
    /// use exact_ccd_mesh::TriangleMesh;
    ///
    /// let mesh = TriangleMesh::new(9, vec![[7, 4, 2]])?;
    /// let (alone, vertices) = mesh.without_loose_vertices();
    /// assert_eq!((alone.vertex_count(), alone.faces()), (3, &[[2, 1, 0]][..]));
    /// assert_eq!(vertices, [2, 4, 7]);
    /// # Ok::<(), exact_ccd_mesh::IndexOutOfRange>(())
    /// ```
    #[must_use]
    pub fn without_loose_vertices(&self) -> (Self, Vec<u32>) {
        let mut vertices = self.faces.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        let mut numbers = vec![0; self.vertex_count];
        for (number, &vertex) in (0..).zip(&vertices) {
            numbers[vertex as usize] = number;
        }
        let number = |vertex: u32| numbers[vertex as usize];
        let mesh = Self {
            vertex_count: vertices.len(),
            faces: self.faces.iter().map(|face| face.map(number)).collect(),
            // Numbers increase as vertices do: edges keep their order.
            edges: self.edges.iter().map(|edge| edge.map(number)).collect(),
        };
        (mesh, vertices)
    }

    /// How many vertices there are.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The faces, in the order in which they were given.
    #[must_use]
    pub fn faces(&self) -> &[[u32; 3]] {
        &self.faces
    }

    /// The edges of the faces, each once: the pairs (i, j), i < j, sorted by j, then by i, which is the order that
    /// the published data sets use.
    #[must_use]
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }
}

fn edges_of(faces: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let sides = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
    let mut edges: Vec<[u32; 2]> = faces
        .iter()
        .flat_map(sides)
        .filter(|[a, b]| a != b)
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    edges.sort_unstable_by_key(|&[i, j]| (j, i));
    edges.dedup();
    edges
}
