//! The file of a mesh with new positions.

use std::io::Write;
use std::path::Path;

use exact_ccd_files::{Format, MeshFile, Polygons, with_obj_positions, write_obj, write_ply};
use exact_ccd_mesh::{Frame, Point, TriangleMesh};

use crate::failure::Failure;
use crate::output::write_file;
use crate::scene::Scene;

/// The place of a mesh with new positions, and the file that it had before.
pub(super) struct MeshOutput<'a> {
    input: &'a Path,
    output: &'a Path,
    format: Format,
}

impl<'a> MeshOutput<'a> {
    pub(super) fn new(input: &'a Path, output: &'a Path) -> Result<Self, Failure> {
        match Format::of_path(output) {
            Some(format @ (Format::Ply | Format::Obj)) => Ok(Self {
                input,
                output,
                format,
            }),
            _ => Err(Failure::of(
                output,
                "the repaired mesh is a PLY or an OBJ file: name one that ends in .ply or .obj",
            )),
        }
    }

    /// Writes the parts of a scene that are no obstacles.
    pub(super) fn write(
        &self,
        scene: &Scene,
        mesh: &TriangleMesh,
        positions: &[Point],
    ) -> Result<(), Failure> {
        // Obstacles are behind the other parts.
        let count = scene.moving_vertices().last().map_or(0, |part| part.end);
        let positions = &positions[..count as usize];
        if let Some(text) = self.same_text(positions) {
            return write_file(self.output, |writer| writer.write_all(text.as_bytes()));
        }
        let is_written = |primitive: &[u32]| primitive.iter().all(|&vertex| vertex < count);
        let faces = mesh.faces().iter().copied().filter(|face| is_written(face));
        let edges = mesh.loose_edges().iter().copied().filter(|edge| is_written(edge));
        let written = TriangleMesh::with_edges(positions.len(), faces.collect(), &edges.collect::<Vec<_>>())?;
        let frame = Frame {
            mesh: written,
            positions: positions.to_vec(),
        };
        write_file(self.output, |writer| match self.format {
            Format::Obj => write_obj(writer, &frame),
            _ => write_ply(writer, &frame),
        })
    }

    /// The text of an OBJ file with new coordinates, if it reads as these positions.
    fn same_text(&self, positions: &[Point]) -> Option<String> {
        if (self.format, Format::of_path(self.input)) != (Format::Obj, Some(Format::Obj)) {
            return None;
        }
        let before = std::fs::read_to_string(self.input).ok()?;
        let text = with_obj_positions(&before, positions)?;
        let read = MeshFile::parse(text.as_bytes(), Format::Obj, Polygons::Triangulate).ok()?;
        (read.frame.positions == positions).then_some(text)
    }
}
