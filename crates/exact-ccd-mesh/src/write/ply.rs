//! The Stanford polygon format, binary.

use std::io;

use crate::frame::Frame;
use crate::positions;

impl Frame {
    /// Writes the frame as a binary little-endian PLY file, which reads back as the same frame, bit for bit.
    ///
    /// Coordinates take 8 bytes each, or 4 if every one of them is exactly an `f32`.
    ///
    /// # Errors
    /// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput), with the
    /// [`PositionsError`](crate::PositionsError), if the positions do not fit the mesh.
    pub fn write_ply(&self, mut writer: impl io::Write) -> io::Result<()> {
        positions::check(&self.mesh, &self.positions)
            .map_err(|error| io::Error::new(io::ErrorKind::InvalidInput, error))?;
        let coordinates = self.positions.as_flattened();
        let single = coordinates
            .iter()
            .all(|&x| f64::from(x as f32).to_bits() == x.to_bits());
        let header = header(self, if single { "float" } else { "double" });
        let mut bytes = header.into_bytes();
        for &x in coordinates {
            if single {
                bytes.extend((x as f32).to_le_bytes());
            } else {
                bytes.extend(x.to_le_bytes());
            }
        }
        for face in self.mesh.faces() {
            bytes.push(3);
            bytes.extend(face.iter().flat_map(|corner| corner.to_le_bytes()));
        }
        writer.write_all(&bytes)
    }
}

fn header(frame: &Frame, coordinate: &str) -> String {
    let vertex_count = frame.positions.len();
    let face_count = frame.mesh.faces().len();
    // Old readers know no unsigned indices.
    let index = if vertex_count <= i32::MAX as usize {
        "int"
    } else {
        "uint"
    };
    format!(
        "ply\n\
         format binary_little_endian 1.0\n\
         element vertex {vertex_count}\n\
         property {coordinate} x\n\
         property {coordinate} y\n\
         property {coordinate} z\n\
         element face {face_count}\n\
         property list uchar {index} vertex_indices\n\
         end_header\n"
    )
}
