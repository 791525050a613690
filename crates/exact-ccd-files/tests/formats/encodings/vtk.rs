//! VTK files by writers that are independent of the crate.

use std::io::Write;

use exact_ccd_mesh::Frame;

pub(super) fn zlib(data: &[u8]) -> (&'static str, Vec<u8>) {
    let mut writer = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
    writer.write_all(data).unwrap();
    ("vtkZLibDataCompressor", writer.finish().unwrap())
}

pub(super) fn lz4(data: &[u8]) -> (&'static str, Vec<u8>) {
    ("vtkLZ4DataCompressor", lz4_flex::block::compress(data))
}

/// A surface with appended raw data in compressed blocks of 16 bytes.
pub(super) fn appended_vtp(frame: &Frame, compress: fn(&[u8]) -> (&'static str, Vec<u8>)) -> Vec<u8> {
    const BLOCK: usize = 16;
    let mut data = Vec::new();
    let mut append = |array: Vec<u8>| {
        let offset = data.len();
        let blocks: Vec<Vec<u8>> = array.chunks(BLOCK).map(|block| compress(block).1).collect();
        let sizes = blocks.iter().map(Vec::len);
        let header = [blocks.len(), BLOCK, array.len() % BLOCK]
            .into_iter()
            .chain(sizes);
        data.extend(header.flat_map(|number| (number as u32).to_le_bytes()));
        data.extend(blocks.concat());
        offset
    };
    let coordinates = frame.positions.as_flattened().iter();
    let points = append(coordinates.flat_map(|x| x.to_le_bytes()).collect());
    let corners = frame.mesh.faces().as_flattened().iter();
    let corners = append(
        corners
            .flat_map(|&corner| i64::from(corner).to_le_bytes())
            .collect(),
    );
    let faces = frame.mesh.faces().len();
    let ends = append(
        (1..=faces)
            .flat_map(|face| (3 * face as u16).to_le_bytes())
            .collect(),
    );
    let array = |kind: &str, name: &str, offset| {
        format!("<DataArray type='{kind}' Name='{name}' format='appended' offset='{offset}'/>")
    };
    let xml = format!(
        "<VTKFile type='PolyData' byte_order='LittleEndian' compressor='{}'><PolyData><Piece \
         NumberOfPoints='{}'>\n<Points>{}</Points><Verts/><Polys>\n{}{}</Polys></Piece></PolyData>\n\
         <AppendedData encoding='raw'>\n  _",
        compress(&[]).0,
        frame.positions.len(),
        array("Float64", "Points", points),
        array("Int64", "connectivity", corners),
        array("UInt16", "offsets", ends),
    );
    [xml.as_bytes(), &data, b"\n  </AppendedData>\n</VTKFile>\n"].concat()
}

pub(super) fn legacy_text(frame: &Frame) -> String {
    let faces = frame.mesh.faces();
    let mut text = format!(
        "# vtk DataFile Version 4.2\nfrom a test\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\n\
         time 1 2 float\n0 1\nMETADATA\nINFORMATION 0\n\nPOINTS {} double\n",
        frame.positions.len()
    );
    for [x, y, z] in &frame.positions {
        text += &format!("{x:?} {y:?}\n{z:?} ");
    }
    text += &format!("\nCELLS {} {}\n", faces.len(), 4 * faces.len());
    for [a, b, c] in faces {
        text += &format!("3 {a} {b} {c}\n");
    }
    text + &format!(
        "CELL_TYPES {}\n{}\nPOINT_DATA 9\n",
        faces.len(),
        "5 ".repeat(faces.len())
    )
}

pub(super) fn legacy_binary(frame: &Frame) -> Vec<u8> {
    let (faces, points) = (frame.mesh.faces(), frame.positions.len());
    let mut bytes = format!(
        "# vtk DataFile Version 5.1\r\nfrom a test\r\nBINARY\r\nDATASET POLYDATA\r\nPOINTS {points} double\r\n"
    )
    .into_bytes();
    bytes.extend(
        frame
            .positions
            .as_flattened()
            .iter()
            .flat_map(|x| x.to_be_bytes()),
    );
    bytes.extend(format!("\nPOLYGONS {} {}\n", faces.len() + 1, 3 * faces.len()).as_bytes());
    bytes.extend(b"OFFSETS vtktypeint64\n");
    bytes.extend((0..=faces.len()).flat_map(|face| (3 * face as i64).to_be_bytes()));
    bytes.extend(b"\nCONNECTIVITY int\n");
    let corners = faces.as_flattened().iter();
    bytes.extend(corners.flat_map(|corner| corner.to_be_bytes()));
    bytes
}
