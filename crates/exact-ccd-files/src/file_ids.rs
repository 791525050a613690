//! The ids of vertices and faces in a file.

/// The ids that vertices and faces have in their file, counted from 0, for each vertex and each face of its
/// frame.
///
/// The id of a vertex is the number of its position in the file. The id of a face is its number among the
/// faces of the file: the triangles of a polygon have the id of the polygon. Lines and cells with volume do
/// not count as faces. The sides of cells with volume are no faces of the file, and have no id.
///
/// ```
/// use exact_ccd_files::{Format, MeshFile, Polygons};
///
/// let obj = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 4\n";
/// let ids = MeshFile::parse(obj, Format::Obj, Polygons::Triangulate)?.ids;
/// assert_eq!(ids.vertices, [0, 1, 2, 3]);
/// assert_eq!(ids.faces, [Some(0), Some(0), Some(1)]);
/// # Ok::<(), exact_ccd_files::ParseError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct FileIds {
    /// The id of each vertex of the frame. Vertices inside of cells with volume are left out of the frame.
    pub vertices: Vec<u32>,
    /// The id of each face of the frame; none for a side of a cell with volume.
    pub faces: Vec<Option<u32>>,
    /// The number of vertices in the file.
    pub vertex_count: usize,
    /// The number of faces in the file.
    pub face_count: usize,
}

impl FileIds {
    /// Appends the ids of another file. They continue the ids of the files before.
    ///
    /// ```
    /// use exact_ccd_files::{FileIds, Format, MeshFile, Polygons};
    ///
    /// let obj = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
    /// let file = MeshFile::parse(obj, Format::Obj, Polygons::Triangulate)?;
    /// let mut ids = FileIds::default();
    /// ids.append(&file.ids);
    /// ids.append(&file.ids);
    /// assert_eq!(ids.vertices, [0, 1, 2, 3, 4, 5]);
    /// assert_eq!(ids.faces, [Some(0), Some(1)]);
    /// # Ok::<(), exact_ccd_files::ParseError>(())
    /// ```
    pub fn append(&mut self, next: &Self) {
        let (vertex, face) = (self.vertex_count as u32, self.face_count as u32);
        let vertices = next.vertices.iter();
        self.vertices
            .extend(vertices.map(|id| vertex.saturating_add(*id)));
        let faces = next.faces.iter();
        self.faces
            .extend(faces.map(|id| id.map(|id| face.saturating_add(id))));
        self.vertex_count += next.vertex_count;
        self.face_count += next.face_count;
    }
}
