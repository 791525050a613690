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
/// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput), before anything is
/// written, if a coordinate or velocity is not finite, a corner is not a vertex, or the numbers of
/// velocities, of bodies, of ids and of vertices differ.
pub fn write_vtu<'a>(mut writer: impl io::Write, grid: impl Into<UnstructuredGrid<'a>>) -> io::Result<()> {
    let grid = grid.into();
    grid.check()?;
    let mut cells = Cells::default();
    cells.add(TETRAHEDRON, grid.tetrahedra);
    cells.add(TRIANGLE, grid.triangles);
    cells.add(LINE, grid.lines);
    cells.add(VERTEX, grid.points.as_chunks::<1>().0);
    let Data { points, of_cells } = Data::new(&grid, &cells);
    let file = format!(
        r#"<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<UnstructuredGrid>
<Piece NumberOfPoints="{}" NumberOfCells="{}">
{points}{of_cells}<Points>
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
        encoded(cells.corners.iter().map(|corner| corner.to_le_bytes())),
        encoded(cells.ends.iter().map(|end| end.to_le_bytes())),
        encoded(cells.types.iter().map(|kind| [*kind])),
    );
    writer.write_all(file.as_bytes())
}

/// The elements with data, each empty or a line.
#[derive(Default)]
struct Data {
    points: String,
    of_cells: String,
}

impl Data {
    fn new(grid: &UnstructuredGrid<'_>, cells: &Cells) -> Self {
        let velocities = grid.velocities.map(|velocities| vectors("velocity", velocities));
        let body = |bodies: &mut dyn Iterator<Item = u32>| {
            data_array("Int32", "body", 1, bodies.map(|body| (body as i32).to_le_bytes()))
        };
        let of_vertices = grid.bodies.map(|bodies| body(&mut bodies.iter().copied()));
        let of_cells = grid.bodies.map(|bodies| {
            let first = |corner: &u32| bodies[*corner as usize];
            body(&mut cells.first.iter().map(first))
        });
        let element = |name: &str, attributes: &str, arrays: Vec<String>| {
            if arrays.is_empty() {
                return String::new();
            }
            format!("<{name}{attributes}>\n{}\n</{name}>\n", arrays.join("\n"))
        };
        let vectors = if velocities.is_some() {
            " Vectors=\"velocity\""
        } else {
            ""
        };
        let ids = grid.ids.map(|ids| {
            let data = ids.iter().map(|&id| i64::from(id).to_le_bytes());
            data_array("Int64", "id", 1, data)
        });
        let of_points = velocities.into_iter().chain(of_vertices).chain(ids).collect();
        Self {
            points: element("PointData", vectors, of_points),
            of_cells: element("CellData", "", of_cells.into_iter().collect()),
        }
    }
}

/// The three arrays that describe cells.
#[derive(Default)]
struct Cells {
    /// The first corner of each cell.
    first: Vec<u32>,
    corners: Vec<i64>,
    /// The number of corners up to the end of each cell.
    ends: Vec<i64>,
    types: Vec<u8>,
}

impl Cells {
    fn add<const N: usize>(&mut self, kind: u8, cells: &[[u32; N]]) {
        for cell in cells {
            self.first.push(cell[0]);
            self.corners.extend(cell.map(i64::from));
            self.ends.push(self.corners.len() as i64);
            self.types.push(kind);
        }
    }
}

/// An array of three components for each vertex.
pub(super) fn vectors(name: &str, vectors: &[Point]) -> String {
    let coordinates = vectors.as_flattened().iter();
    data_array("Float64", name, 3, coordinates.map(|x| x.to_le_bytes()))
}

/// An array of this type with this number of components for each vertex.
pub(super) fn data_array<const N: usize>(
    kind: &str,
    name: &str,
    components: u8,
    data: impl Iterator<Item = [u8; N]>,
) -> String {
    let data = encoded(data);
    format!(
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" \
         format=\"binary\">{data}</DataArray>"
    )
}

/// The number of bytes, as 64 bits, and the bytes of some numbers, in base64.
pub(super) fn encoded<const N: usize>(data: impl Iterator<Item = [u8; N]>) -> String {
    let mut bytes = vec![0; 8];
    bytes.extend(data.flatten());
    let length = bytes.len() as u64 - 8;
    bytes[..8].copy_from_slice(&length.to_le_bytes());
    STANDARD.encode(bytes)
}
