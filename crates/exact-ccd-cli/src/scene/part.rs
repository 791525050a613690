//! One part of a scene.

use std::ops::Range;
use std::path::{Path, PathBuf};

use exact_ccd_files::{Contents, FileIds, Group, MeshFile, Note, ReadMotionError};
use exact_ccd_mesh::{Frame, MotionError, Point, TriangleMesh, Welding};
use exact_ccd_view::Body;

use super::Frames;
use crate::failure::Failure;
use crate::notes::Notes;

/// A mesh in motion, or at rest if it has one frame.
pub(super) struct Part {
    pub(super) name: String,
    pub(super) is_obstacle: bool,
    /// The vertices of the part in the scene.
    pub(super) vertices: Range<u32>,
    frames: Frames,
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
    mesh: TriangleMesh,
    welded: Option<(Welding, TriangleMesh)>,
    /// The named groups of the first frame, by their vertices in the part.
    pub(super) groups: Vec<Group>,
}

impl Part {
    /// Reads the first two frames, and all frames to find the vertices to weld.
    pub(super) fn open(name: String, frames: Frames, is_obstacle: bool, weld: bool) -> Result<Self, Failure> {
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
        let mesh = frame.mesh.clone();
        let vertices = 0..mesh.vertex_count() as u32;
        let second = second?.map(|file| file.frame);
        let mut part = Self {
            name,
            is_obstacle,
            vertices,
            frames,
            loaded: [Some(frame), second].to_vec(),
            contents,
            ids,
            arrays,
            file_notes,
            mesh,
            welded: None,
            groups,
        };
        let is_stl = part.frames.are_stl();
        if weld || is_stl {
            let (welding, mesh) = part.weld(is_stl)?;
            for vertex in part.groups.iter_mut().flat_map(|group| &mut group.vertices) {
                *vertex = welding.vertex_of(*vertex).unwrap_or(*vertex);
            }
            let kept = welding.first_vertices().iter();
            part.ids.vertices = kept.map(|&vertex| part.ids.vertices[vertex]).collect();
            part.vertices = 0..mesh.vertex_count() as u32;
            part.welded = Some((welding, mesh));
        }
        Ok(part)
    }

    /// Adds the notes about the file of the first frame.
    pub(super) fn add_file_notes(&self, notes: &mut Notes) {
        let file = self.frames.file(0).display();
        for note in &self.file_notes {
            let text = format!("{file}: {note}");
            if note.fact.is_warning() {
                notes.warn(text);
            } else {
                notes.note(text);
            }
        }
    }

    fn weld(&self, is_stl: bool) -> Result<(Welding, TriangleMesh), Failure> {
        let mut welding = Welding::default();
        for index in 0..self.frames.count() {
            if let Some(Some(frame)) = self.loaded.get(index) {
                self.check(index, frame)?;
                welding.restrict(&frame.positions);
            } else {
                let frame = self.frames.read(index)?.frame;
                self.check(index, &frame)?;
                welding.restrict(&frame.positions);
            }
        }
        if !is_stl {
            welding = welding.along_edges(&self.mesh);
        }
        let mesh = welding
            .mesh(&self.mesh)
            .map_err(|error| self.mismatch(0, error))?;
        Ok((welding, mesh))
    }

    /// Returns true if `--weld` makes one vertex of these two of the scene, where all frames are like these.
    pub(super) fn would_weld(&self, vertices: [u32; 2], frames: &[&[Point]]) -> bool {
        if self.welded.is_some() {
            return false;
        }
        let mut welding = Welding::default();
        for positions in frames {
            let Range { start, end } = self.vertices;
            welding.restrict(&positions[start as usize..end as usize]);
        }
        let welding = welding.along_edges(&self.mesh);
        let [v, w] = vertices.map(|vertex| welding.vertex_of(vertex - self.vertices.start));
        v == w
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
        Ok(match &self.welded {
            None => frame,
            Some((welding, mesh)) => Frame {
                mesh: mesh.clone(),
                positions: welding.positions(&frame.positions),
            },
        })
    }

    fn check(&self, index: usize, frame: &Frame) -> Result<(), Failure> {
        let same = self.mesh.check_same(&frame.mesh);
        same.map_err(|error| self.mismatch(index, error))
    }

    pub(super) fn frame_name(&self, index: usize) -> String {
        self.frames.name(index.min(self.frames.count() - 1))
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

/// The contents of the scene: what the files have, after welding.
pub(super) fn contents(parts: &[Part], frame: &Frame) -> Contents {
    if let [part] = parts
        && part.welded.is_none()
    {
        return part.contents;
    }
    let mut contents = Contents::of(frame);
    contents.polygons = parts.iter().map(|part| part.contents.polygons).sum();
    contents.solids = parts.iter().map(|part| part.contents.solids).sum();
    contents
}

/// The name of a part and its file: NAME=FILE, unless there is such a file; else the name is that of the
/// file, up to the first dot.
pub(super) fn named(path: &Path) -> (String, PathBuf) {
    let text = path.to_string_lossy();
    if let Some((name, file)) = text.split_once('=')
        && !name.is_empty()
        && !path.exists()
    {
        return (name.to_owned(), file.into());
    }
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    let stem = name.split('.').find(|stem| !stem.is_empty()).unwrap_or("part");
    (stem.to_owned(), path.to_owned())
}

/// The name of a part of a file: that of the file, and its own, if it has one.
pub(super) fn part_name(file: &str, part: Option<String>) -> String {
    part.map_or(file.to_owned(), |part| format!("{file}-{part}"))
}

/// Appends a number to the names that an earlier part has.
pub(super) fn make_names_unique(parts: &mut [Part]) {
    for index in 1..parts.len() {
        let (before, rest) = parts.split_at_mut(index);
        let is_taken = |name: &str| before.iter().any(|part| part.name == name);
        if is_taken(&rest[0].name) {
            let numbered = (2..).map(|number| format!("{}-{number}", rest[0].name));
            if let Some(name) = numbered.into_iter().find(|name| !is_taken(name)) {
                rest[0].name = name;
            }
        }
    }
}
