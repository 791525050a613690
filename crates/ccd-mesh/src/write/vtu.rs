//! VTK's XML format of unstructured grids, which ParaView opens.
//!
//! VTK documentation, *XML File Formats*. Data stand inline in base64: that keeps every bit, and the file is plain XML.

use std::io;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use exact_ccd::Point;

use crate::frame::Frame;
use crate::positions;
use crate::tet_mesh::TetMesh;

/// What VTK calls the cells that are written here.
const TRIANGLE: u8 = 5;
const TETRAHEDRON: u8 = 10;

impl Frame {
    /// Writes the vertices and faces as a VTK file of an unstructured grid, `.vtu`, bit for bit.
    ///
    /// # Errors
    /// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput), with the
    /// [`PositionsError`](crate::PositionsError), if the positions do not fit the mesh.
    pub fn write_vtu(&self, writer: impl io::Write) -> io::Result<()> {
        positions::check(&self.mesh, &self.positions)
            .map_err(|error| io::Error::new(io::ErrorKind::InvalidInput, error))?;
        write(writer, &self.positions, self.mesh.faces(), TRIANGLE)
    }
}

impl TetMesh {
    /// Writes the vertices and tetrahedra as a VTK file of an unstructured grid, `.vtu`, bit for bit.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_vtu(&self, writer: impl io::Write) -> io::Result<()> {
        write(writer, self.positions(), self.tetrahedra(), TETRAHEDRON)
    }
}

fn write<const N: usize>(
    mut writer: impl io::Write,
    positions: &[Point],
    cells: &[[u32; N]],
    cell_type: u8,
) -> io::Result<()> {
    let coordinates = positions.as_flattened().iter().flat_map(|x| x.to_le_bytes());
    let corners = cells
        .as_flattened()
        .iter()
        .flat_map(|&corner| i64::from(corner).to_le_bytes());
    let ends = (1..=cells.len()).flat_map(|cell| ((cell * N) as i64).to_le_bytes());
    let types = cells.iter().map(|_| cell_type);
    let file = format!(
        r#"<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid>
<Piece NumberOfPoints="{}" NumberOfCells="{}">
<Points>
<DataArray type="Float64" Name="Points" NumberOfComponents="3" format="binary">{}</DataArray>
</Points>
<Cells>
<DataArray type="Int64" Name="connectivity" format="binary">{}</DataArray>
<DataArray type="Int64" Name="offsets" format="binary">{}</DataArray>
<DataArray type="UInt8" Name="types" format="binary">{}</DataArray>
</Cells>
</Piece>
</UnstructuredGrid>
</VTKFile>
"#,
        positions.len(),
        cells.len(),
        encoded(coordinates),
        encoded(corners),
        encoded(ends),
        encoded(types),
    );
    writer.write_all(file.as_bytes())
}

/// How many bytes there are, as 64 bits, and the bytes.
fn encoded(data: impl Iterator<Item = u8>) -> String {
    let mut bytes = vec![0; 8];
    bytes.extend(data);
    let length = bytes.len() as u64 - 8;
    bytes[..8].copy_from_slice(&length.to_le_bytes());
    STANDARD.encode(bytes)
}
