//! The contents of a mesh file: points, lines, faces and cells with volume over the same vertices.

use std::fmt;

use exact_ccd_mesh::{Frame, Point, TetMesh};

use super::budget::Budget;
use super::group::{Group, by_name};
use super::polygons::Faces;
use super::solids::{self, Solid, increasing};
use super::volumes;
use crate::error::{Fault, ParseError, Place};
use crate::file_ids::FileIds;
use crate::note::Note;

/// The contents of a mesh file. Readers have checked all indices.
#[derive(Default)]
pub(super) struct Cells {
    pub(super) positions: Vec<Point>,
    /// Vertices that a format lists as points.
    pub(super) points: Vec<u32>,
    pub(super) lines: Vec<[u32; 2]>,
    pub(super) faces: Faces,
    pub(super) solids: Vec<Solid>,
    /// Groups, which may have names in common.
    pub(super) groups: Vec<Group>,
    /// The names of the arrays that were read, in a file of several arrays.
    pub(super) arrays: Option<String>,
    /// Facts that could change an answer.
    pub(super) notes: Vec<Note>,
}

/// The frame of a file, and the facts about the file that a frame does not have.
pub(super) struct Assembled {
    pub(super) frame: Frame,
    /// The number of polygons with more than three corners among its faces.
    pub(super) polygons: usize,
    pub(super) first_polygon: Option<ParseError>,
    /// The number of cells with volume, of which the frame has the surface.
    pub(super) solids: usize,
    pub(super) groups: Vec<Group>,
    pub(super) ids: FileIds,
    pub(super) arrays: Option<String>,
    pub(super) notes: Vec<Note>,
}

/// The numbers of elements in the file, for the error of a file without any mesh.
impl fmt::Display for Cells {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (vertices, points, lines) = (self.positions.len(), self.points.len(), self.lines.len());
        let (faces, solids) = (self.faces.count, self.solids.len());
        write!(
            f,
            "{vertices} vertices, {points} points, {lines} edges, {faces} faces and {solids} cells with volume"
        )
    }
}

impl Cells {
    /// Counts the memory.
    pub(super) fn charge(&self, budget: &Budget) {
        budget.hold::<Point>(self.positions.len());
        budget.hold::<u32>(self.points.len());
        budget.hold::<[u32; 2]>(self.lines.len());
        budget.hold::<[u32; 4]>(self.faces.triangles.len());
        budget.hold::<Solid>(self.solids.len());
        budget.hold::<Note>(self.notes.len());
        for group in &self.groups {
            budget.hold::<Group>(1);
            budget.hold::<u8>(group.name.len());
            budget.hold::<u32>(group.vertices.len() + group.cells.len());
        }
    }

    /// Adds a note, unless there is one of the same fact.
    pub(super) fn note(&mut self, note: Note) {
        if self.notes.iter().all(|other| other.fact != note.fact) {
            self.notes.push(note);
        }
    }

    /// Adds the lines between consecutive vertices.
    pub(super) fn add_polyline(&mut self, vertices: &[u32]) {
        self.lines
            .extend(vertices.windows(2).map(|pair| [pair[0], pair[1]]));
    }

    /// All vertices, faces and lines. Every vertex in none of them is a point. For files without
    /// cells with volume.
    fn into_frame(self) -> Result<Assembled, ParseError> {
        let ids = FileIds {
            vertices: (0..self.positions.len()).map(|vertex| vertex as u32).collect(),
            faces: (0..self.faces.triangles.len())
                .map(|triangle| Some(self.faces.id(triangle)))
                .collect(),
            vertex_count: self.positions.len(),
            face_count: self.faces.count,
        };
        let Faces {
            triangles,
            polygons,
            first_polygon,
            ..
        } = self.faces;
        let frame = Frame::with_edges(self.positions, triangles, &self.lines);
        Ok(Assembled {
            frame: frame.map_err(at_file(Fault::Frame))?,
            polygons,
            first_polygon,
            solids: 0,
            groups: by_name(self.groups),
            ids,
            arrays: self.arrays,
            notes: self.notes,
        })
    }

    /// The surface of the cells with volume and the lines that are not edges of them; without such
    /// cells, as [`Cells::into_frame`].
    ///
    /// Every face must be a side of a cell. Listed points are left out: Gmsh lists the points of
    /// the geometry, such as the centers of arcs.
    pub(super) fn into_surface(mut self) -> Result<Assembled, ParseError> {
        if self.solids.is_empty() {
            return self.into_frame();
        }
        if let Some(face) = self.first_sheet() {
            return Err(Fault::Sheet { face }.at(Place::File));
        }
        // Sides of cells have no ids, but count for the ids of the files after this one.
        self.faces = self.faces.without_triangles();
        self.points = Vec::new();
        self.into_scene()
    }

    /// The surface of the cells with volume, and all other faces, lines and points: shells, rods
    /// and points beside solids.
    ///
    /// A side is on the surface if it belongs to one cell only. It has the orientation of its cell, of which
    /// the volume counts as positive in the order of the corners: the surface of a body stays the same under
    /// any deformation, even where cells turn inside out.
    pub(super) fn into_scene(mut self) -> Result<Assembled, ParseError> {
        if self.solids.is_empty() {
            return self.into_frame();
        }
        let surface = solids::surface(&self.solids)?;
        exact_ccd_mesh::check_positions(self.positions.len(), &self.positions)
            .map_err(|error| at_file(Fault::Frame)(error.into()))?;
        self.notes.extend(volumes::notes(&self.solids, &self.positions));
        self.with_surface(surface)
    }

    /// The surface, then the faces that are not sides of cells with volume, the lines that are not
    /// edges of them, and the listed points that are not corners of them.
    fn with_surface(self, surface: Faces) -> Result<Assembled, ParseError> {
        let corners = sorted(self.solids.iter().flat_map(Solid::sides).flatten());
        let is_free = |vertex: &u32| corners.binary_search(vertex).is_err();
        let points: Vec<u32> = self.points.into_iter().filter(is_free).collect();
        let lines = loose_lines(&self.solids, self.lines);
        let mut faces = surface.triangles;
        let mut face_ids = vec![None; faces.len()];
        if !self.faces.triangles.is_empty() {
            let sides = solids::all_triangles(&self.solids);
            for (number, &triangle) in self.faces.triangles.iter().enumerate() {
                if sides.binary_search(&increasing(triangle)).is_err() {
                    faces.push(triangle);
                    face_ids.push(Some(self.faces.id(number)));
                }
            }
        }
        let polygons = surface.polygons + self.faces.polygons_among(&face_ids);
        let first_polygon = surface.first_polygon.or(self.faces.first_polygon);
        let (frame, vertices) = frame(&self.positions, faces, &lines, &points)?;
        let mut groups = by_name(self.groups);
        for group in &mut groups {
            let places = group.vertices.iter();
            let places = places.filter_map(|vertex| vertices.binary_search(vertex).ok());
            group.vertices = places.map(|place| place as u32).collect();
        }
        groups.retain(|group| !group.vertices.is_empty());
        Ok(Assembled {
            frame,
            polygons,
            first_polygon: first_polygon.filter(|_| polygons > 0),
            solids: self.solids.len(),
            groups,
            ids: FileIds {
                vertices,
                faces: face_ids,
                vertex_count: self.positions.len(),
                face_count: self.faces.count,
            },
            arrays: self.arrays,
            notes: self.notes,
        })
    }

    /// The tetrahedra alone. Every face must be a face of one of them.
    pub(super) fn into_tet_mesh(self) -> Result<TetMesh, ParseError> {
        let tetrahedra = self.tetrahedra().ok_or_else(|| {
            let found = "hexahedra, wedges or pyramids";
            Fault::expected("no cells with volume but tetrahedra", found).at(Place::File)
        })?;
        let sheet = self.first_sheet();
        let mesh = TetMesh::new(self.positions, tetrahedra).map_err(at_file(Fault::TetMesh))?;
        match sheet {
            None => Ok(mesh),
            Some(face) => Err(Fault::Sheet { face }.at(Place::File)),
        }
    }

    /// The first face that is not a side of a cell, or a part of one.
    fn first_sheet(&self) -> Option<u32> {
        if self.faces.triangles.is_empty() {
            return None;
        }
        let sides = solids::all_triangles(&self.solids);
        let is_sheet = |&triangle: &[u32; 3]| sides.binary_search(&increasing(triangle)).is_err();
        let triangle = self.faces.triangles.iter().position(is_sheet)?;
        Some(self.faces.id(triangle))
    }

    /// The cells with volume, if all of them are tetrahedra.
    fn tetrahedra(&self) -> Option<Vec<[u32; 4]>> {
        let tetrahedra = self.solids.iter().map(|solid| match *solid {
            Solid::Tetrahedron(corners) => Some(corners),
            _ => None,
        });
        tetrahedra.collect()
    }
}

/// The frame of these faces, lines and points without all other vertices, in the same order, and the
/// vertices that it has.
fn frame(
    positions: &[Point],
    faces: Vec<[u32; 3]>,
    lines: &[[u32; 2]],
    points: &[u32],
) -> Result<(Frame, Vec<u32>), ParseError> {
    let corners = faces.as_flattened().iter().chain(lines.as_flattened());
    let vertices = sorted(corners.chain(points).copied());
    let index = |vertex: u32| vertices.partition_point(|&kept| kept < vertex) as u32;
    let positions = vertices.iter().map(|&vertex| positions[vertex as usize]);
    let faces = faces.into_iter().map(|face| face.map(index)).collect();
    let lines: Vec<_> = lines.iter().map(|line| line.map(index)).collect();
    let frame = Frame::with_edges(positions.collect(), faces, &lines).map_err(at_file(Fault::Frame))?;
    Ok((frame, vertices))
}

/// The lines between different vertices that are not edges of cells.
fn loose_lines(solids: &[Solid], mut lines: Vec<[u32; 2]>) -> Vec<[u32; 2]> {
    if lines.is_empty() {
        return lines;
    }
    let mut edges = Vec::new();
    for side in solids.iter().flat_map(Solid::sides) {
        let next = side.iter().cycle().skip(1);
        edges.extend(side.iter().zip(next).map(|(&a, &b)| increasing([a, b])));
    }
    let edges = sorted(edges.into_iter());
    lines.retain(|&line| line[0] != line[1] && edges.binary_search(&increasing(line)).is_err());
    lines
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
