//! Parts that are rigid bodies, each in its own coordinates.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use exact_ccd_mesh::Frame;

use super::frames::{self, Frames};
use super::{Assembly, AssemblyOptions};
use crate::contacts::PartPrimitive;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;

impl Assembly {
    /// The bodies in these files, one in each, by the names of the files without folder and extension.
    pub(crate) fn of_bodies(
        files: &[PathBuf],
        options: &AssemblyOptions,
        notes: &mut Notes,
    ) -> Result<Self, Failure> {
        let mut named: BTreeMap<String, &Path> = BTreeMap::new();
        let mut bodies = Vec::new();
        for file in files {
            let stem = file.file_stem().unwrap_or(file.as_os_str());
            let name = stem.to_string_lossy().into_owned();
            if let Some(other) = named.insert(name.clone(), file) {
                let other = other.display();
                let reason =
                    format_args!("{other} is a body of the name {name}, too: rename one of the files");
                return Err(Failure::of(file, reason));
            }
            let frames = Frames::of_file(file, &options.read_options())?;
            if frames.count() != 1 {
                return Err(frames::frame_count(file, frames.count(), 1));
            }
            bodies.push((name, frames));
        }
        Self::open(bodies, options, notes)
    }

    /// The names of the parts.
    pub(crate) fn part_names(&self) -> Vec<String> {
        self.parts.iter().map(|part| part.name.clone()).collect()
    }

    /// The first frame of each part.
    pub(crate) fn part_frames(&mut self) -> Result<Vec<Frame>, Failure> {
        let positions = self.read(0)?.positions;
        let frame = |part: &super::Part| Frame {
            mesh: part.mesh().clone(),
            positions: positions[part.vertices.start as usize..part.vertices.end as usize].to_vec(),
        };
        Ok(self.parts.iter().map(frame).collect())
    }

    /// Two primitives with these numbers of vertices and indices in their parts, in the mesh of the scene.
    pub(crate) fn primitives_of_parts(
        &self,
        parts: [usize; 2],
        sizes: [usize; 2],
        primitives: [u32; 2],
    ) -> [PartPrimitive; 2] {
        [0, 1].map(|side: usize| {
            let (part, index) = (&self.parts[parts[side]], primitives[side]);
            let start = part.vertices.start;
            let vertices = match sizes[side] {
                1 => vec![index],
                2 => part.mesh().edges()[index as usize].to_vec(),
                _ => part.mesh().faces()[index as usize].to_vec(),
            };
            let vertices: Vec<u32> = vertices.into_iter().map(|vertex| start + vertex).collect();
            let before = self.parts[..parts[side]].iter();
            let id = match vertices[..] {
                [vertex] => Some(vertex),
                [a, b] => self.mesh.edge(a, b),
                _ => Some(before.map(|part| part.mesh().faces().len() as u32).sum::<u32>() + index),
            };
            PartPrimitive { id, vertices }
        })
    }
}
