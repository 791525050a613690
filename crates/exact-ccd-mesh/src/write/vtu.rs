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

/// Tetrahedra and triangles over the same vertices, as VTK shows solids beside shells.
///
/// ```
/// use exact_ccd_mesh::UnstructuredGrid;
///
/// let grid = UnstructuredGrid {
///     positions: &[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
///     tetrahedra: &[[0, 1, 2, 3]],
///     ..UnstructuredGrid::default()
/// };
/// let mut vtu = Vec::new();
/// grid.write_vtu(&mut vtu)?;
/// assert!(String::from_utf8_lossy(&vtu).contains(r#"<Piece NumberOfPoints="4" NumberOfCells="1">"#));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UnstructuredGrid<'a> {
    /// The position of each vertex.
    pub positions: &'a [Point],
    /// Tetrahedra, the first cells.
    pub tetrahedra: &'a [[u32; 4]],
    /// Triangles, the cells after these.
    pub triangles: &'a [[u32; 3]],
    /// The velocity of each vertex, if it is to be written: as point data `velocity`.
    pub velocities: Option<&'a [Point]>,
}

impl Frame {
    /// Writes the vertices and faces as a VTK file of an unstructured grid, `.vtu`, bit for bit.
    ///
    /// # Errors
    /// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput), with the
    /// [`PositionsError`](crate::PositionsError), if the positions do not fit the mesh.
    pub fn write_vtu(&self, writer: impl io::Write) -> io::Result<()> {
        positions::check(&self.mesh, &self.positions)
            .map_err(|error| io::Error::new(io::ErrorKind::InvalidInput, error))?;
        let grid = UnstructuredGrid {
            positions: &self.positions,
            triangles: self.mesh.faces(),
            ..UnstructuredGrid::default()
        };
        grid.write_vtu(writer)
    }
}

impl TetMesh {
    /// Writes the vertices and tetrahedra as a VTK file of an unstructured grid, `.vtu`, bit for bit.
    ///
    /// VTK takes tetrahedra to be positive in the order of their corners: if some are and others are not, a
    /// [`Frame`](crate::Frame) of the file is an error.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn write_vtu(&self, writer: impl io::Write) -> io::Result<()> {
        let grid = UnstructuredGrid {
            positions: self.positions(),
            tetrahedra: self.tetrahedra(),
            ..UnstructuredGrid::default()
        };
        grid.write_vtu(writer)
    }
}

impl UnstructuredGrid<'_> {
    /// Writes the grid as a VTK file, `.vtu`, bit for bit.
    ///
    /// # Errors
    /// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput), before anything is written, if a coordinate
    /// is not finite, a corner is no vertex, or there is not one velocity for each vertex.
    pub fn write_vtu(&self, mut writer: impl io::Write) -> io::Result<()> {
        self.check()?;
        let cell_count = self.tetrahedra.len() + self.triangles.len();
        let corners = [self.tetrahedra.as_flattened(), self.triangles.as_flattened()].concat();
        let corners = corners.iter().flat_map(|&corner| i64::from(corner).to_le_bytes());
        let last = 4 * self.tetrahedra.len();
        let ends = (1..=self.tetrahedra.len()).map(|cell| 4 * cell);
        let ends = ends.chain((1..=self.triangles.len()).map(|cell| last + 3 * cell));
        let ends = ends.flat_map(|end| (end as i64).to_le_bytes());
        let types = self.tetrahedra.iter().map(|_| TETRAHEDRON);
        let types = types.chain(self.triangles.iter().map(|_| TRIANGLE));
        let velocities = self.velocities.map_or(String::new(), |velocities| {
            let data = vectors("velocity", velocities);
            format!("<PointData Vectors=\"velocity\">\n{data}\n</PointData>\n")
        });
        let file = format!(
            r#"<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid>
<Piece NumberOfPoints="{}" NumberOfCells="{cell_count}">
{velocities}<Points>
{}
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
            self.positions.len(),
            vectors("Points", self.positions),
            encoded(corners),
            encoded(ends),
            encoded(types),
        );
        writer.write_all(file.as_bytes())
    }

    fn check(&self) -> io::Result<()> {
        let invalid = |what: String| Err(io::Error::new(io::ErrorKind::InvalidInput, what));
        let count = self.positions.len();
        positions::check_all(count, self.positions)
            .map_err(|error| io::Error::new(io::ErrorKind::InvalidInput, error))?;
        let mut corners = self
            .tetrahedra
            .as_flattened()
            .iter()
            .chain(self.triangles.as_flattened());
        if let Some(corner) = corners.find(|&&corner| corner as usize >= count) {
            return invalid(format!(
                "a cell names vertex {corner}, but there are only {count} vertices"
            ));
        }
        let Some(velocities) = self.velocities else {
            return Ok(());
        };
        if velocities.len() != count {
            let found = velocities.len();
            return invalid(format!(
                "{found} velocities, expected one for each of {count} vertices"
            ));
        }
        match velocities.as_flattened().iter().find(|v| !v.is_finite()) {
            None => Ok(()),
            Some(v) => invalid(format!(
                "a velocity has the component {v}, expected finite numbers"
            )),
        }
    }
}

/// An array of three components for each vertex.
fn vectors(name: &str, vectors: &[Point]) -> String {
    let data = encoded(vectors.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
    format!(
        "<DataArray type=\"Float64\" Name=\"{name}\" NumberOfComponents=\"3\" format=\"binary\">{data}</DataArray>"
    )
}

/// How many bytes there are, as 64 bits, and the bytes.
fn encoded(data: impl Iterator<Item = u8>) -> String {
    let mut bytes = vec![0; 8];
    bytes.extend(data);
    let length = bytes.len() as u64 - 8;
    bytes[..8].copy_from_slice(&length.to_le_bytes());
    STANDARD.encode(bytes)
}
