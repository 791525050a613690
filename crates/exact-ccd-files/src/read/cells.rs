//! The contents of a mesh file: points, lines, triangles and tetrahedra over the same vertices.

use exact_ccd_mesh::{Frame, Point, TetFaces, TetMesh, TetMeshError};

use crate::error::{Fault, ParseError, Place};

/// The contents of a mesh file. Readers have checked all indices.
#[derive(Default)]
pub(super) struct Cells {
    pub(super) positions: Vec<Point>,
    /// Vertices that a format lists as points.
    pub(super) points: Vec<u32>,
    pub(super) lines: Vec<[u32; 2]>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) tetrahedra: Vec<[u32; 4]>,
}

impl Cells {
    /// Adds the lines between consecutive vertices.
    pub(super) fn add_polyline(&mut self, vertices: &[u32]) {
        self.lines
            .extend(vertices.windows(2).map(|pair| [pair[0], pair[1]]));
    }

    /// All vertices, triangles and lines. Every vertex in none of them is a point. For files
    /// without tetrahedra.
    pub(super) fn into_frame(self) -> Result<Frame, ParseError> {
        Frame::with_edges(self.positions, self.triangles, &self.lines).map_err(at_file(Fault::Frame))
    }

    /// The surface of the tetrahedra and the lines that are not edges of tetrahedra; without
    /// tetrahedra, as [`Cells::into_frame`].
    ///
    /// Listed points are left out: Gmsh lists the points of the geometry, as the centres of arcs.
    pub(super) fn into_surface(mut self) -> Result<Frame, ParseError> {
        if self.tetrahedra.is_empty() {
            return self.into_frame();
        }
        let lines = loose_lines(&self.tetrahedra, std::mem::take(&mut self.lines));
        let mesh = self.into_tet_mesh()?;
        frame(mesh.positions(), mesh.surface().to_vec(), &lines, &[])
    }

    /// The surface of the tetrahedra, and all other triangles, lines and points: shells, rods and
    /// points beside solids.
    ///
    /// Tetrahedra count as positive in the order of their corners, so that the surface of a body
    /// stays the same under any deformation, even where tetrahedra turn inside out.
    pub(super) fn into_scene(self) -> Result<Frame, ParseError> {
        if self.tetrahedra.is_empty() {
            return self.into_frame();
        }
        if let Some(tetrahedron) = self.tetrahedra.iter().position(|corners| !are_distinct(corners)) {
            return Err(at_file(Fault::TetMesh)(TetMeshError::Flat { tetrahedron }));
        }
        let lines = loose_lines(&self.tetrahedra, self.lines);
        let corners = sorted(self.tetrahedra.as_flattened().iter().copied());
        let is_free = |vertex: &u32| corners.binary_search(vertex).is_err();
        let points: Vec<u32> = self.points.into_iter().filter(is_free).collect();
        let tet_faces = TetFaces::of(self.tetrahedra);
        tet_faces.check().map_err(at_file(Fault::TetMesh))?;
        let mut faces = tet_faces.boundary();
        let shells = self.triangles.into_iter();
        faces.extend(shells.filter(|&triangle| !tet_faces.contains(triangle)));
        frame(&self.positions, faces, &lines, &points)
    }

    /// The tetrahedra alone. Every triangle must be a face of one of them.
    pub(super) fn into_tet_mesh(self) -> Result<TetMesh, ParseError> {
        let mesh = TetMesh::new(self.positions, self.tetrahedra).map_err(at_file(Fault::TetMesh))?;
        if self.triangles.is_empty() {
            return Ok(mesh);
        }
        let faces = TetFaces::of(mesh.tetrahedra().iter().copied());
        let is_sheet = |&triangle: &[u32; 3]| !faces.contains(triangle);
        match self.triangles.iter().position(is_sheet) {
            None => Ok(mesh),
            Some(triangle) => Err(Fault::Sheet { triangle }.at(Place::File)),
        }
    }
}

/// The frame of these faces, lines and points without all other vertices, in the same order.
///
/// All positions must be finite, also those that are left out.
fn frame(
    positions: &[Point],
    faces: Vec<[u32; 3]>,
    lines: &[[u32; 2]],
    points: &[u32],
) -> Result<Frame, ParseError> {
    exact_ccd_mesh::check_positions(positions.len(), positions)
        .map_err(|error| at_file(Fault::Frame)(error.into()))?;
    let corners = faces.as_flattened().iter().chain(lines.as_flattened());
    let vertices = sorted(corners.chain(points).copied());
    let index = |vertex: u32| vertices.partition_point(|&kept| kept < vertex) as u32;
    let positions = vertices.iter().map(|&vertex| positions[vertex as usize]);
    let faces = faces.into_iter().map(|face| face.map(index)).collect();
    let lines: Vec<_> = lines.iter().map(|line| line.map(index)).collect();
    Frame::with_edges(positions.collect(), faces, &lines).map_err(at_file(Fault::Frame))
}

/// The lines between different vertices that are not edges of tetrahedra.
fn loose_lines(tetrahedra: &[[u32; 4]], mut lines: Vec<[u32; 2]>) -> Vec<[u32; 2]> {
    if lines.is_empty() {
        return lines;
    }
    let ordered = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
    let edges = sorted(
        tetrahedra
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b], [a, c], [a, d], [b, c], [b, d], [c, d]].map(ordered)),
    );
    lines.retain(|&line| line[0] != line[1] && edges.binary_search(&ordered(line)).is_err());
    lines
}

fn are_distinct(corners: &[u32; 4]) -> bool {
    (1..4).all(|k| !corners[..k].contains(&corners[k]))
}

/// The elements in increasing order, each once.
fn sorted<T: Ord>(elements: impl Iterator<Item = T>) -> Vec<T> {
    let mut sorted: Vec<T> = elements.collect();
    sorted.sort_unstable();
    sorted.dedup();
    sorted
}

/// The error of the file as a whole.
fn at_file<E>(fault: impl FnOnce(E) -> Fault) -> impl FnOnce(E) -> ParseError {
    move |error| fault(error).at(Place::File)
}

/// The index of a vertex of an element, counted from 0 as in the file.
pub(super) fn vertex_index(
    (element, number): (&'static str, usize),
    index: i64,
    vertex_count: u64,
    place: Place,
) -> Result<u32, ParseError> {
    let in_range = |&index: &u32| u64::from(index) < vertex_count;
    u32::try_from(index).ok().filter(in_range).ok_or_else(|| {
        Fault::Index {
            element,
            number,
            index,
            first: 0,
            vertex_count,
        }
        .at(place)
    })
}
