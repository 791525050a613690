//! VTK's XML format of surfaces, for points with data.

use std::io;

use exact_ccd_mesh::{Point, check_positions};

use super::check::invalid;
use super::vtu::{data_array, encoded, vectors};
use super::xml::attribute;

/// Data of points: one value for each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PointArray<'a> {
    /// Integers.
    Integers(&'a [i64]),
    /// Numbers.
    Reals(&'a [f64]),
    /// Vectors of three components.
    Vectors(&'a [Point]),
}

/// Writes a VTK file of points with data, `.vtp`, bit for bit.
///
/// Each point is a cell of its own, so that ParaView draws it. The data are named arrays.
///
/// ```
/// use exact_ccd_files::{PointArray, write_vtp};
///
/// let points = [[0.0; 3], [1.0, 0.0, 0.0]];
/// let mut vtp = Vec::new();
/// write_vtp(&mut vtp, &points, &[("time", PointArray::Reals(&[0.25, 0.5]))])?;
/// assert!(String::from_utf8_lossy(&vtp).contains(r#"<Piece NumberOfPoints="2" NumberOfVerts="2">"#));
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput), before anything is
/// written, if a coordinate is not finite, the numbers of values and points differ, or a name has a character
/// that XML does not allow.
pub fn write_vtp(
    mut writer: impl io::Write,
    points: &[Point],
    data: &[(&str, PointArray<'_>)],
) -> io::Result<()> {
    let count = points.len();
    check_positions(count, points).map_err(invalid)?;
    for (name, array) in data {
        let found = array.len();
        if found != count {
            return Err(invalid(format!(
                "{found} values of {name}, expected one for each of {count} points"
            )));
        }
    }
    let element = |(name, array): &(&str, PointArray<'_>)| Ok(array.element(&attribute("name", name)?));
    let arrays = data.iter().map(element).collect::<io::Result<Vec<_>>>()?;
    let cells = |ids: std::ops::Range<i64>| encoded(ids.map(i64::to_le_bytes));
    let file = format!(
        r#"<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData>
<Piece NumberOfPoints="{count}" NumberOfVerts="{count}">
<PointData>
{}
</PointData>
<Points>
{}
</Points>
<Verts>
<DataArray type="Int64" Name="connectivity" format="binary">{}</DataArray>
<DataArray type="Int64" Name="offsets" format="binary">{}</DataArray>
</Verts>
</Piece>
</PolyData>
</VTKFile>
"#,
        arrays.join("\n"),
        vectors("Points", points),
        cells(0..count as i64),
        cells(1..count as i64 + 1),
    );
    writer.write_all(file.as_bytes())
}

impl PointArray<'_> {
    fn len(&self) -> usize {
        match self {
            Self::Integers(values) => values.len(),
            Self::Reals(values) => values.len(),
            Self::Vectors(values) => values.len(),
        }
    }

    fn element(&self, name: &str) -> String {
        match self {
            Self::Integers(values) => {
                data_array("Int64", name, 1, values.iter().map(|value| value.to_le_bytes()))
            }
            Self::Reals(values) => {
                data_array("Float64", name, 1, values.iter().map(|value| value.to_le_bytes()))
            }
            Self::Vectors(values) => vectors(name, values),
        }
    }
}
