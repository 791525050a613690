//! VTK's XML format of unstructured grids, which ParaView opens.
//!
//! VTK documentation, *XML File Formats*. Data are inline in base64, which keeps every bit and
//! leaves the file plain XML.

use std::io;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use exact_ccd_mesh::Point;

use super::grid::UnstructuredGrid;

/// VTK's numbers of the types of cells.
const VERTEX: u8 = 1;
const LINE: u8 = 3;
const TRIANGLE: u8 = 5;
const TETRAHEDRON: u8 = 10;

/// Writes a VTK file of an unstructured grid, `.vtu`, bit for bit: of a
/// [`Frame`](exact_ccd_mesh::Frame), a [`TetMesh`](exact_ccd_mesh::TetMesh) or an
/// [`UnstructuredGrid`].
///
/// Tetrahedra count as positive in the order of their corners in VTK: a file with some positive and
/// some negative ones cannot be read as a frame.
///
/// # Errors
/// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput), before anything is
/// written, if a coordinate or velocity is not finite, a corner is not a vertex, or the numbers of
/// velocities, of ids and of vertices differ.
pub fn write_vtu<'a>(mut writer: impl io::Write, grid: impl Into<UnstructuredGrid<'a>>) -> io::Result<()> {
    let grid = grid.into();
    grid.check()?;
    let mut cells = Cells::default();
    cells.add(TETRAHEDRON, grid.tetrahedra);
    cells.add(TRIANGLE, grid.triangles);
    cells.add(LINE, grid.lines);
    cells.add(VERTEX, grid.points.as_chunks::<1>().0);
    let velocities = grid.velocities.map(|velocities| vectors("velocity", velocities));
    let attribute = velocities.as_ref().map_or("", |_| " Vectors=\"velocity\"");
    let ids = grid.ids.map(|ids| {
        let data = ids.iter().flat_map(|&id| i64::from(id).to_le_bytes());
        data_array("Int64", "id", 1, data)
    });
    let arrays: Vec<String> = velocities.into_iter().chain(ids).collect();
    let data = match &arrays[..] {
        [] => String::new(),
        _ => format!("<PointData{attribute}>\n{}\n</PointData>\n", arrays.join("\n")),
    };
    let file = format!(
        r#"<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid>
<Piece NumberOfPoints="{}" NumberOfCells="{}">
{data}<Points>
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
        grid.positions.len(),
        cells.types.len(),
        vectors("Points", grid.positions),
        encoded(cells.corners.iter().flat_map(|corner| corner.to_le_bytes())),
        encoded(cells.ends.iter().flat_map(|end| end.to_le_bytes())),
        encoded(cells.types.iter().copied()),
    );
    writer.write_all(file.as_bytes())
}

/// The three arrays that describe cells.
#[derive(Default)]
struct Cells {
    corners: Vec<i64>,
    /// The number of corners up to the end of each cell.
    ends: Vec<i64>,
    types: Vec<u8>,
}

impl Cells {
    fn add<const N: usize>(&mut self, kind: u8, cells: &[[u32; N]]) {
        for cell in cells {
            self.corners.extend(cell.map(i64::from));
            self.ends.push(self.corners.len() as i64);
            self.types.push(kind);
        }
    }
}

/// An array of three components for each vertex.
pub(super) fn vectors(name: &str, vectors: &[Point]) -> String {
    data_array(
        "Float64",
        name,
        3,
        vectors.as_flattened().iter().flat_map(|x| x.to_le_bytes()),
    )
}

/// An array of this type with this number of components for each vertex.
pub(super) fn data_array(kind: &str, name: &str, components: u8, data: impl Iterator<Item = u8>) -> String {
    let data = encoded(data);
    format!(
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" \
         format=\"binary\">{data}</DataArray>"
    )
}

/// The number of bytes, as 64 bits, and the bytes, in base64.
pub(super) fn encoded(data: impl Iterator<Item = u8>) -> String {
    let mut bytes = vec![0; 8];
    bytes.extend(data);
    let length = bytes.len() as u64 - 8;
    bytes[..8].copy_from_slice(&length.to_le_bytes());
    STANDARD.encode(bytes)
}
