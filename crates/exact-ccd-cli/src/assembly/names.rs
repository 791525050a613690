//! The names of the bodies in contacts: parts, or groups of files.

use super::part::Part;
use crate::contacts::{ContactRecord, Owners};

/// The body of each vertex of a scene, by its name; empty if all is one body.
#[derive(Default)]
pub(super) struct Names {
    names: Vec<String>,
    of_vertex: Vec<u32>,
}

/// A part that a contact may be of.
struct Owner<'a> {
    part: &'a Part,
    first_vertex: u32,
    first_face: u32,
}

impl Names {
    pub(super) fn new(parts: &[Part]) -> Self {
        let (mut names, mut of_vertex) = (Vec::new(), Vec::new());
        for part in parts {
            let first = names.len() as u32;
            match part.group_of_vertices() {
                Some(groups) => {
                    let name = |name: &String| match parts {
                        [_] => name.clone(),
                        _ => format!("{}/{name}", part.name),
                    };
                    names.extend(part.groups.iter().map(|group| name(&group.name)));
                    of_vertex.extend(groups.into_iter().map(|group| first + group));
                }
                None => {
                    names.push(part.name.clone());
                    of_vertex.extend(part.vertices.clone().map(|_| first));
                }
            }
        }
        if names.len() > 1 {
            Self { names, of_vertex }
        } else {
            Self::default()
        }
    }

    /// The number of the body of a vertex: 0 if all is one.
    pub(super) fn body(&self, vertex: u32) -> usize {
        self.of_vertex
            .get(vertex as usize)
            .map_or(0, |body| *body as usize)
    }

    /// The name of the body of some vertices, if they are of one.
    pub(super) fn name(&self, vertices: &[u32]) -> Option<&str> {
        let body = self.body(*vertices.first()?);
        let is_one = vertices.iter().all(|&vertex| self.body(vertex) == body);
        self.names.get(body).filter(|_| is_one).map(String::as_str)
    }

    /// The bodies of a contact, and its ids in their files; `None` if all is one body.
    pub(super) fn owners(&self, parts: &[Part], record: &ContactRecord) -> Option<Owners> {
        if self.names.is_empty() {
            return None;
        }
        let owner = |side: usize| Owner::of(parts, *record.mesh_vertices[side].first()?);
        let owners = [owner(0), owner(1)];
        let name = |side: usize| {
            let of_part = owners[side].as_ref().map(|owner| owner.part.name.as_str());
            let found = self.name(&record.mesh_vertices[side]);
            found.or(of_part).map(str::to_owned)
        };
        let id = |side: usize| match &owners[side] {
            Some(owner) => owner.id(record, side),
            None => record.ids[side],
        };
        let vertices = |side: usize| {
            let first = owners[side].as_ref().map_or(0, |owner| owner.first_vertex);
            record.vertices[side]
                .iter()
                .map(|vertex| vertex.saturating_sub(first))
                .collect()
        };
        Some(Owners {
            parts: [name(0), name(1)],
            part_ids: [id(0), id(1)],
            part_vertices: [vertices(0), vertices(1)],
        })
    }
}

impl<'a> Owner<'a> {
    /// The part of a vertex, with the numbers of vertices and faces in the files before.
    fn of(parts: &'a [Part], vertex: u32) -> Option<Self> {
        let index = parts.iter().position(|part| part.vertices.contains(&vertex))?;
        let before = &parts[..index];
        let count = |of: fn(&Part) -> usize| before.iter().map(of).sum::<usize>() as u32;
        Some(Self {
            part: &parts[index],
            first_vertex: count(|part| part.ids.vertex_count),
            first_face: count(|part| part.ids.face_count),
        })
    }

    /// The id of a primitive in the file of the part. For an edge, it is its index in the mesh of the part.
    fn id(&self, record: &ContactRecord, side: usize) -> Option<u32> {
        let vertices = &record.mesh_vertices[side];
        let start = self.part.vertices.start;
        match vertices[..] {
            [_] => record.ids[side].map(|id| id.saturating_sub(self.first_vertex)),
            [a, b] => self.part.mesh().edge(a - start, b - start),
            _ => record.ids[side].map(|id| id.saturating_sub(self.first_face)),
        }
    }
}
