//! The file of a mesh with new positions.

use std::io::Write;
use std::path::{Path, PathBuf};

use exact_ccd_files::{Format, MeshFile, Polygons, with_obj_positions, write_obj, write_ply};
use exact_ccd_mesh::{Frame, Point, TriangleMesh};

use crate::assembly::Assembly;
use crate::files::outputs::write_file;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;

/// The place of a mesh with new positions, and the file that it had before.
pub(super) struct MeshOutput<'a> {
    input: PathBuf,
    output: &'a Path,
    is_obj: bool,
}

impl<'a> MeshOutput<'a> {
    pub(super) fn new(input: PathBuf, output: &'a Path) -> Result<Self, Failure> {
        let is = |name| {
            let extension = output.extension();
            extension.is_some_and(|extension| extension.eq_ignore_ascii_case(name))
        };
        if !is("ply") && !is("obj") {
            let reason = "the repaired mesh is a PLY or an OBJ file: name one that ends in .ply or .obj";
            return Err(Failure::of(output, reason));
        }
        Ok(Self {
            input,
            output,
            is_obj: is("obj"),
        })
    }

    /// Writes the parts of a scene that are no obstacles.
    pub(super) fn write(
        &self,
        scene: &Assembly,
        mesh: &TriangleMesh,
        positions: &[Point],
        notes: &mut Notes,
    ) -> Result<(), Failure> {
        // Obstacles are behind the other parts.
        let count = scene.moving_vertices().last().map_or(0, |part| part.end);
        let positions = positions[..count as usize].to_vec();
        let is_written = |primitive: &[u32]| primitive.iter().all(|&vertex| vertex < count);
        let faces = mesh.faces().iter().copied().filter(|face| is_written(face));
        let edges = mesh.loose_edges().iter().copied().filter(|edge| is_written(edge));
        let edges: Vec<[u32; 2]> = edges.collect();
        let mesh = TriangleMesh::with_edges(positions.len(), faces.collect(), &edges)?;
        let frame = Frame { mesh, positions };
        if !self.is_obj {
            return write_file(self.output, |writer| write_ply(writer, &frame));
        }
        if Format::of_path(&self.input) == Some(Format::Obj) {
            if let Some(text) = self.same_text(&frame) {
                return write_file(self.output, |writer| writer.write_all(text.as_bytes()));
            }
            notes.note(format!(
                "{} has vertices, triangles and loose edges only: the text of {} could not be kept",
                self.output.display(),
                self.input.display()
            ));
        }
        write_file(self.output, |writer| write_obj(writer, &frame))
    }

    /// The text of the OBJ file before with new coordinates, if it reads as this frame.
    fn same_text(&self, frame: &Frame) -> Option<String> {
        let before = std::fs::read_to_string(&self.input).ok()?;
        let text = with_obj_positions(&before, &frame.positions)?;
        let read = MeshFile::parse(text.as_bytes(), Format::Obj, Polygons::Triangulate).ok()?;
        (read.frame == *frame).then_some(text)
    }
}
