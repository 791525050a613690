//! The meshes of a command, as one scene: parts that move or rest, read and joined frame by frame.

mod can_collide;
mod frames;
mod identity;
mod inputs;
mod named_file;
mod names;
mod nesting;
mod options;
mod part;
mod points;
mod rigid_bodies;
mod rules;
mod seams;
mod shape;
mod split;
mod summary;
mod turns;
mod vertex_set;

use std::ops::Range;
#[cfg(feature = "repair")]
use std::path::Path;

use exact_ccd_files::{Contents, FileIds};
use exact_ccd_mesh::{CanCollide, Frame, MotionError, TriangleMesh};
use exact_ccd_view::Body;

use crate::contacts::ContactRecord;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
pub(crate) use frames::Frames;
use named_file::named;
use names::Names;
pub(crate) use options::AssemblyOptions;
use part::{Part, part_name};
use rules::Rules;
pub(crate) use summary::Summary;
pub(crate) use turns::{Turn, Turns};

/// Parts with the same number of frames, or with one frame, which rest.
pub(crate) struct Assembly {
    parts: Vec<Part>,
    mesh: TriangleMesh,
    /// The first frame, until it is read.
    first: Option<Frame>,
    contents: Contents,
    rules: Rules,
    ids: FileIds,
    names: Names,
    can_collide: CanCollide,
    frame_count: usize,
}

impl Assembly {
    /// The scene of the parts that move, by their names, and of the parts that the options name.
    fn open(
        moving: Vec<(String, Frames)>,
        options: &AssemblyOptions,
        notes: &mut Notes,
    ) -> Result<Self, Failure> {
        let frame_count = moving.iter().map(|(_, frames)| frames.count()).max().unwrap_or(0);
        let mut parts = Vec::new();
        for (name, frames) in moving {
            let name = part::unique_name(&parts, name);
            parts.push(Part::open(name, frames, false, options)?);
        }
        for path in &options.others {
            let (name, file) = named(path);
            let found =
                Frames::parts_of_paths(std::slice::from_ref(&file), false, &options.of_others(), notes)?;
            for (part, frames) in found {
                let count = frames.count();
                let rests = count == 1;
                if !rests && count != frame_count {
                    let first = parts.first().map_or("", |part| part.name.as_str());
                    return Err(Failure::of(
                        &file,
                        format_args!(
                            "{count} frames, expected {frame_count} as of {first}, or 1 of a mesh at rest"
                        ),
                    ));
                }
                let name = part::unique_name(&parts, part_name(&name, part));
                parts.push(Part::open(name, frames, rests, options)?);
            }
        }
        parts.iter().for_each(|part| part.add_file_notes(notes));
        if let Some(tolerance) = options.weld {
            parts.iter().for_each(|part| part.note_joined(tolerance, notes));
        }
        let frame = joined(&mut parts, None, 0)?;
        let contents = part::contents(&parts, &frame);
        points::check(&parts, options, notes)?;
        if options.weld.is_none() {
            for part in &parts {
                let Range { start, end } = part.vertices;
                part.note_near_vertices(&frame.positions[start as usize..end as usize], notes);
            }
        }
        let mut ids = FileIds::default();
        parts.iter().for_each(|part| ids.append(&part.ids));
        let can_collide = can_collide::can_collide(&parts, &options.rules)?;
        let (mesh, first) = (frame.mesh.clone(), Some(frame));
        Ok(Self {
            mesh,
            first,
            contents,
            rules: options.rules.clone(),
            names: Names::new(&parts),
            parts,
            ids,
            can_collide,
            frame_count,
        })
    }

    pub(crate) fn frame_count(&self) -> usize {
        self.frame_count
    }

    /// The name of a frame in the first part.
    pub(crate) fn frame_name(&self, index: usize) -> String {
        self.parts[0].frame_name(index)
    }

    /// The file of a frame of the first part.
    #[cfg(feature = "repair")]
    pub(crate) fn frame_file(&self, index: usize) -> &Path {
        self.parts[0].frame_file(index)
    }

    /// The time of a frame, if the list of the files of the first part has times.
    pub(crate) fn time(&self, index: usize) -> Option<f64> {
        self.parts[0].time(index)
    }

    /// The frame of all parts.
    pub(crate) fn read(&mut self, index: usize) -> Result<Frame, Failure> {
        match self.first.take() {
            Some(first) if index == 0 => Ok(first),
            _ => joined(&mut self.parts, Some(&self.mesh), index),
        }
    }

    pub(crate) fn mesh(&self) -> &TriangleMesh {
        &self.mesh
    }

    /// The pairs that can collide.
    pub(crate) fn can_collide(&self) -> CanCollide {
        self.can_collide.clone()
    }

    /// The vertices of the parts that are no obstacles.
    pub(crate) fn moving_vertices(&self) -> Vec<Range<u32>> {
        let moving = self.parts.iter().filter(|part| !part.is_obstacle);
        moving.map(|part| part.vertices.clone()).collect()
    }

    /// The vertices of the obstacles, and of the parts and groups with these names.
    #[cfg(feature = "repair")]
    pub(crate) fn resting_vertices(&self, names: &[String]) -> Result<Vec<u32>, Failure> {
        let obstacles = self.parts.iter().filter(|part| part.is_obstacle);
        let mut vertices: Vec<u32> = obstacles.flat_map(|part| part.vertices.clone()).collect();
        for name in names {
            vertices.extend(vertex_set::named_set(&self.parts, name)?.vertices());
        }
        Ok(vertices)
    }

    /// The named bodies of the scene, for pages: its parts, or the groups of a part where each vertex is in
    /// one. None, if all is one part without groups.
    pub(crate) fn bodies(&self) -> Vec<Body> {
        let bodies: Vec<Body> = self.parts.iter().flat_map(Part::bodies).collect();
        if bodies.len() > 1 { bodies } else { Vec::new() }
    }

    /// The ids of vertices and faces in their files, for reports.
    pub(crate) fn ids(&self) -> &FileIds {
        &self.ids
    }

    /// The id of a vertex in the file of its part.
    fn file_vertex(&self, vertex: u32) -> u32 {
        let part = self.parts.iter().find(|part| part.vertices.contains(&vertex));
        let id = part.and_then(|part| part.ids.vertices.get((vertex - part.vertices.start) as usize));
        id.copied().unwrap_or(vertex)
    }

    /// The ids of all vertices and faces, each in the file of its part.
    pub(crate) fn ids_in_parts(&self) -> (Vec<u32>, Vec<Option<u32>>) {
        let of_vertices = self.parts.iter().flat_map(|part| &part.ids.vertices);
        let of_faces = self.parts.iter().flat_map(|part| &part.ids.faces);
        (of_vertices.copied().collect(), of_faces.copied().collect())
    }

    /// The record with the ids of the files, and with the names of its bodies if there are several.
    pub(crate) fn in_file(&self, record: ContactRecord) -> ContactRecord {
        let record = record.in_file(&self.ids);
        let owners = self.names.owners(&self.parts, &record);
        ContactRecord { owners, ..record }
    }

    /// A face by its id and its body, if there are several; without an id, by its vertices.
    #[cfg(feature = "repair")]
    pub(crate) fn face_name(&self, mesh: &TriangleMesh, face: u32) -> String {
        let record = self.in_file(ContactRecord::of_face(mesh, face));
        let (id, part) = match &record.owners {
            Some(owners) => (owners.part_ids[1], owners.parts[1].as_deref()),
            None => (record.ids[1], None),
        };
        let of_part = part.map(|part| format!(" of {part}")).unwrap_or_default();
        match id {
            Some(id) => format!("face {id}{of_part}"),
            None => format!("the face with the vertices {:?}{of_part}", record.vertices[1]),
        }
    }

    /// The error for a frame that does not belong to the frames before it.
    pub(crate) fn mismatch(&self, index: usize, source: MotionError) -> Failure {
        self.parts[0].mismatch(index, source)
    }

    /// The contents and the parts, for reports.
    pub(crate) fn summary(&self) -> Summary {
        Summary::new(self.contents, &self.parts, &self.rules)
    }
}

/// The frames of all parts as one frame. The mesh is the given one, unless it is the first frame.
fn joined(parts: &mut [Part], mesh: Option<&TriangleMesh>, index: usize) -> Result<Frame, Failure> {
    if let [part] = parts {
        return part.read(index);
    }
    let (mut positions, mut meshes) = (Vec::new(), Vec::new());
    for part in parts {
        let frame = part.read(index)?;
        let first = positions.len() as u32;
        meshes.push(frame.mesh);
        positions.extend(frame.positions);
        part.set_vertices(first, positions.len())?;
    }
    let mesh = match mesh {
        Some(mesh) => mesh.clone(),
        None => TriangleMesh::joined(&meshes)
            .map_err(|error| Failure::new(format_args!("the parts together: {error}")))?,
    };
    Ok(Frame { mesh, positions })
}
