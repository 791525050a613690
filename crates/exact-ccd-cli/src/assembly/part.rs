//! One part of a scene.

use std::ops::Range;
#[cfg(feature = "repair")]
use std::path::Path;

use exact_ccd_files::{Contents, FileIds, Group, MeshFile, Note, ReadMotionError};
use exact_ccd_mesh::{Frame, MotionError, Point, TriangleMesh, Welding};
use exact_ccd_view::Body;

use super::frames::Frames;
use super::options::AssemblyOptions;
use super::shape::{LeftOut, Shape};
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;

/// A mesh in motion, or at rest if it has one frame.
pub(super) struct Part {
    pub(super) name: String,
    pub(super) is_obstacle: bool,
    /// The vertices of the part in the scene.
    pub(super) vertices: Range<u32>,
    pub(super) frames: Frames,
    /// The first frames, until they are read.
    loaded: Vec<Option<Frame>>,
    /// The contents of the first frame, as it is in its file.
    contents: Contents,
    /// The ids of vertices and faces in the file of the first frame. A welded vertex has the least one.
    pub(super) ids: FileIds,
    /// The names of the arrays of the file.
    pub(super) arrays: Option<String>,
    /// Facts about the file of the first frame.
    file_notes: Vec<Note>,
    /// The mesh of all frames in their files.
    in_file: TriangleMesh,
    shape: Shape,
    /// The numbers of edges and points that are left out of the mesh.
    pub(super) left_out: LeftOut,
    /// The named groups of the first frame, by their vertices in the part.
    pub(super) groups: Vec<Group>,
}

impl Part {
    /// Reads the first two frames, and all frames to find the vertices to weld.
    pub(super) fn open(
        name: String,
        frames: Frames,
        is_obstacle: bool,
        options: &AssemblyOptions,
    ) -> Result<Self, Failure> {
        let (first, second) = rayon::join(
            || frames.read(0),
            || (frames.count() > 1).then(|| frames.read(1)).transpose(),
        );
        let MeshFile {
            frame,
            contents,
            groups,
            ids,
            arrays,
            notes: file_notes,
            ..
        } = first?;
        let in_file = frame.mesh.clone();
        let (shape, left_out) = if options.has_faces_only(&name) {
            Shape::of_faces(&in_file)
        } else {
            (Shape::of(in_file.clone()), LeftOut::default())
        };
        let second = second?.map(|file| file.frame);
        let mut part = Self {
            name,
            is_obstacle,
            vertices: 0..0,
            frames,
            loaded: [Some(frame), second].to_vec(),
            contents,
            ids,
            arrays,
            file_notes,
            in_file,
            shape,
            left_out,
            groups,
        };
        if options.weld.is_some() || part.frames.are_stl() {
            let (welding, mesh) = part.weld(options.weld.unwrap_or(0.0))?;
            part.shape = part.shape.welded(welding, mesh);
        }
        for group in &mut part.groups {
            group.vertices = part.shape.vertices(&group.vertices);
        }
        part.ids.vertices = part.shape.of_vertices(&part.ids.vertices);
        part.vertices = 0..part.mesh().vertex_count() as u32;
        Ok(part)
    }

    /// Adds the notes about the file of the first frame.
    pub(super) fn add_file_notes(&self, notes: &mut Notes) {
        let file = self.frames.mesh_file(0).display();
        for note in &self.file_notes {
            let text = format!("{file}: {note}");
            if note.fact.is_warning() {
                notes.warn(text);
            } else {
                notes.note(text);
            }
        }
    }

    /// The vertices in one place, or within a tolerance, in all frames: at seams, or all of STL.
    fn weld(&self, tolerance: f64) -> Result<(Welding, TriangleMesh), Failure> {
        let mut welding = Welding::default();
        let mut restrict = |index: usize, frame: &Frame| {
            self.check(index, frame)?;
            let positions = self.shape.of_vertices(&frame.positions);
            if tolerance > 0.0 {
                self.check_tolerance(tolerance, &positions)?;
                welding.restrict_within(&positions, tolerance);
            } else {
                welding.restrict(&positions);
            }
            Ok::<_, Failure>(())
        };
        for index in 0..self.frames.count() {
            match self.loaded.get(index) {
                Some(Some(frame)) => restrict(index, frame)?,
                _ => restrict(index, &self.frames.read(index)?.frame)?,
            }
        }
        if !self.frames.are_stl() {
            welding = welding.along_edges(self.mesh());
        }
        let mesh = welding
            .mesh(self.mesh())
            .map_err(|error| self.mismatch(0, error))?;
        Ok((welding, mesh))
    }

    /// Refuses a tolerance that is too near to the rounding of the positions, see
    /// [`Welding::restrict_within`].
    fn check_tolerance(&self, tolerance: f64, positions: &[Point]) -> Result<(), Failure> {
        let most = positions
            .as_flattened()
            .iter()
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        let least = most * 2.0_f64.powi(-50);
        if tolerance >= least {
            return Ok(());
        }
        Err(Failure::new(format_args!(
            "--weld={tolerance:e} is below {least:e}, the rounding of the positions of the part {}: name a greater \
             tolerance, or none to join vertices in the same place",
            self.name
        )))
    }

    /// The vertices that a tolerance has joined in the first frame, by [`Shape::joined`]; known until the
    /// first frame is read.
    pub(super) fn joined(&self) -> (usize, f64) {
        let first = self.loaded.first().and_then(Option::as_ref);
        first.map_or((0, 0.0), |frame| self.shape.joined(&frame.positions))
    }

    /// The mesh of the part in the scene.
    pub(super) fn mesh(&self) -> &TriangleMesh {
        self.shape.mesh()
    }

    pub(super) fn is_welded(&self) -> bool {
        self.shape.is_welded()
    }

    /// Returns true if there is neither a face nor an edge.
    pub(super) fn is_of_points(&self) -> bool {
        self.mesh().edges().is_empty() && self.mesh().faces().is_empty()
    }

    /// The group of each vertex, if each is in one of several; `None` otherwise.
    pub(super) fn group_of_vertices(&self) -> Option<Vec<u32>> {
        let mut of_vertex = vec![None; self.mesh().vertex_count()];
        for (number, group) in (0..).zip(&self.groups) {
            for &vertex in &group.vertices {
                let group = of_vertex.get_mut(vertex as usize)?.get_or_insert(number);
                if *group != number {
                    return None;
                }
            }
        }
        of_vertex.into_iter().collect()
    }

    /// The frame, welded. A part at rest has the same one at all times.
    pub(super) fn read(&mut self, index: usize) -> Result<Frame, Failure> {
        let is_at_rest = self.frames.count() == 1;
        let index = if is_at_rest { 0 } else { index };
        let loaded = match self.loaded.get_mut(index) {
            Some(frame) if is_at_rest => frame.clone(),
            Some(frame) => frame.take(),
            None => None,
        };
        let frame = match loaded {
            Some(frame) => frame,
            None => self.frames.read(index)?.frame,
        };
        self.check(index, &frame)?;
        Ok(self.shape.frame(frame))
    }

    fn check(&self, index: usize, frame: &Frame) -> Result<(), Failure> {
        let same = self.in_file.check_same(&frame.mesh);
        same.map_err(|error| self.mismatch(index, error))
    }

    pub(super) fn frame_name(&self, index: usize) -> String {
        self.frames.name(index.min(self.frames.count() - 1))
    }

    /// The file of a frame, or of the only one.
    #[cfg(feature = "repair")]
    pub(super) fn frame_file(&self, index: usize) -> &Path {
        self.frames.file(index.min(self.frames.count() - 1))
    }

    /// The time of a frame, if its file has it.
    pub(super) fn time(&self, index: usize) -> Option<f64> {
        self.frames.time(index)
    }

    /// The error for a frame that does not belong to the frames before it.
    pub(super) fn mismatch(&self, index: usize, source: MotionError) -> Failure {
        let [start, end] = self.frames.files([index.saturating_sub(1), index]);
        Failure::from(ReadMotionError::Motion { start, end, source })
    }

    /// The groups of the part as bodies, if each is a range of vertices and they cover the part in their
    /// order; or else the part.
    pub(super) fn bodies(&self) -> Vec<Body> {
        let (first, end) = (self.vertices.start, self.vertices.end);
        let kind = if self.is_obstacle { "obstacle" } else { "" };
        let mut bodies: Vec<Body> = Vec::new();
        for group in &self.groups {
            let start = bodies.last().map_or(first, |body| body.vertices.end);
            let mut vertices = group.vertices.clone();
            vertices.sort_unstable();
            vertices.dedup();
            let after = start + vertices.len() as u32;
            if vertices.is_empty() || !vertices.iter().map(|vertex| first + vertex).eq(start..after) {
                return vec![Body::new(&self.name, kind, first..end)];
            }
            bodies.push(Body::new(&group.name, kind, start..after));
        }
        if bodies.last().is_none_or(|body| body.vertices.end != end) {
            return vec![Body::new(&self.name, kind, first..end)];
        }
        bodies
    }

    /// Sets the vertices of the part in the scene.
    pub(super) fn set_vertices(&mut self, first: u32, end: usize) -> Result<(), Failure> {
        let end = u32::try_from(end)
            .map_err(|_| Failure::new("all parts together have more than 2^32 - 1 vertices"))?;
        self.vertices = first..end;
        Ok(())
    }
}

/// The contents of the scene: the contents of the files, after welding.
pub(super) fn contents(parts: &[Part], frame: &Frame) -> Contents {
    if let [part] = parts
        && !part.shape.is_changed()
    {
        return part.contents;
    }
    let mut contents = Contents::of(frame);
    contents.polygons = parts.iter().map(|part| part.contents.polygons).sum();
    contents.solids = parts.iter().map(|part| part.contents.solids).sum();
    contents
}

/// The name of a part of a file: the file's name, and the part's own name, if it has one.
pub(super) fn part_name(file: &str, part: Option<String>) -> String {
    part.map_or(file.to_owned(), |part| format!("{file}-{part}"))
}

/// The name, with a number if a part has it.
pub(super) fn unique_name(parts: &[Part], name: String) -> String {
    let is_taken = |name: &str| parts.iter().any(|part| part.name == name);
    if !is_taken(&name) {
        return name;
    }
    let mut numbered = (2..).map(|number: u64| format!("{name}-{number}"));
    numbered.find(|name| !is_taken(name)).unwrap_or(name)
}
