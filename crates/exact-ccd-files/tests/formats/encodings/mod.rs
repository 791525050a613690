//! One frame in every format and encoding, by writers that are independent of the crate.

mod arrays;
mod vtk;

use exact_ccd_files::{Format, write_obj, write_ply, write_vtu};
use exact_ccd_mesh::Frame;

/// A file: description, format, contents.
pub(crate) type File = (&'static str, Format, Vec<u8>);

/// The frame in the formats that keep the connectivity, without loss.
pub(crate) fn indexed(frame: &Frame) -> Vec<File> {
    let (mut own, mut vtu, mut own_obj) = (Vec::new(), Vec::new(), Vec::new());
    write_ply(&mut own, frame).unwrap();
    write_vtu(&mut vtu, frame).unwrap();
    write_obj(&mut own_obj, frame).unwrap();
    vec![
        ("our OBJ as text", Format::Obj, own_obj),
        ("vtu in base64", Format::Vtu, vtu),
        ("text vtu", Format::Vtu, text_vtu(frame).into_bytes()),
        ("text vtu, CRLF", Format::Vtu, crlf(&text_vtu(frame))),
        ("our own ply", Format::Ply, own),
        ("text ply", Format::Ply, text_ply(frame).into_bytes()),
        ("text ply, CRLF", Format::Ply, crlf(&text_ply(frame))),
        (
            "little-endian ply",
            Format::Ply,
            binary_ply(frame, "little", f64::to_le_bytes, i32::to_le_bytes),
        ),
        (
            "big-endian ply",
            Format::Ply,
            binary_ply(frame, "big", f64::to_be_bytes, i32::to_be_bytes),
        ),
        ("obj", Format::Obj, obj(frame).into_bytes()),
        ("obj, CRLF", Format::Obj, crlf(&obj(frame))),
        ("off", Format::Off, off(frame).into_bytes()),
        ("off, CRLF", Format::Off, crlf(&off(frame))),
        ("vtp, raw, zlib", Format::Vtp, vtk::appended_vtp(frame, vtk::zlib)),
        ("vtp, raw, lz4", Format::Vtp, vtk::appended_vtp(frame, vtk::lz4)),
        ("text vtk 4.2", Format::Vtk, vtk::legacy_text(frame).into_bytes()),
        ("vtk 5.1 of big numbers", Format::Vtk, vtk::legacy_binary(frame)),
        ("npz", Format::Npz, arrays::npz(frame)),
    ]
}

/// The frame in the formats with three vertices for each face, without loss if all coordinates are
/// single precision.
pub(crate) fn soup(frame: &Frame) -> Vec<File> {
    vec![
        ("text stl", Format::Stl, text_stl(frame).into_bytes()),
        ("text stl, CRLF", Format::Stl, crlf(&text_stl(frame))),
        ("binary stl", Format::Stl, binary_stl(frame)),
        ("glb", Format::Gltf, arrays::glb(frame)),
    ]
}

fn crlf(text: &str) -> Vec<u8> {
    text.replace('\n', "\r\n").into_bytes()
}

/// One line for each row: a prefix and the numbers, separated by spaces.
fn lines<T: std::fmt::Debug>(prefix: &str, rows: impl IntoIterator<Item = [T; 3]>) -> String {
    let line = |[x, y, z]: [T; 3]| format!("{prefix}{x:?} {y:?} {z:?}\n");
    rows.into_iter().map(line).collect()
}

fn ply_header(frame: &Frame, encoding: &str) -> String {
    format!(
        "ply\nformat {encoding} 1.0\ncomment from a test\nelement vertex {}\nproperty double x\n\
         property double y\nproperty double z\nelement face {}\nproperty list uchar int vertex_index\n\
              end_header\n",
        frame.positions.len(),
        frame.mesh.faces().len(),
    )
}

fn text_ply(frame: &Frame) -> String {
    ply_header(frame, "ascii")
        + &lines("", frame.positions.iter().copied())
        + &lines("3 ", frame.mesh.faces().iter().copied())
}

fn binary_ply(
    frame: &Frame,
    order: &str,
    coordinate: fn(f64) -> [u8; 8],
    index: fn(i32) -> [u8; 4],
) -> Vec<u8> {
    let mut bytes = ply_header(frame, &format!("binary_{order}_endian")).into_bytes();
    bytes.extend(frame.positions.as_flattened().iter().flat_map(|&x| coordinate(x)));
    for face in frame.mesh.faces() {
        bytes.push(3);
        bytes.extend(
            face.iter()
                .flat_map(|&corner| index(i32::try_from(corner).unwrap())),
        );
    }
    bytes
}

fn obj(frame: &Frame) -> String {
    let from_one = frame
        .mesh
        .faces()
        .iter()
        .map(|face| face.map(|corner| corner + 1));
    lines("v ", frame.positions.iter().copied()) + &lines("f ", from_one)
}

fn off(frame: &Frame) -> String {
    format!("OFF\n{} {} 0\n", frame.positions.len(), frame.mesh.faces().len())
        + &lines("", frame.positions.iter().copied())
        + &lines("3 ", frame.mesh.faces().iter().copied())
}

fn text_stl(frame: &Frame) -> String {
    let (triangles, _) = frame.positions.as_chunks::<3>();
    let facet = |&corners: &[[f64; 3]; 3]| {
        let vertices = lines("      vertex ", corners);
        format!("  facet normal nan 0 -1e-3\n    outer loop\n{vertices}    endloop\n  endfacet\n")
    };
    let facets: String = triangles.iter().map(facet).collect();
    format!("solid a name of facets\n{facets}endsolid a name of facets\n")
}

fn binary_stl(frame: &Frame) -> Vec<u8> {
    let (triangles, _) = frame.positions.as_chunks::<3>();
    let mut bytes = b"solid, and yet binary".to_vec();
    bytes.resize(80, b' ');
    bytes.extend(u32::try_from(triangles.len()).unwrap().to_le_bytes());
    for triangle in triangles {
        bytes.extend([0xff; 12]);
        bytes.extend(
            triangle
                .as_flattened()
                .iter()
                .flat_map(|&x| (x as f32).to_le_bytes()),
        );
        bytes.extend([1, 2]);
    }
    bytes
}

fn text_vtu(frame: &Frame) -> String {
    let cells = frame.mesh.faces().len();
    let ends: String = (1..=cells).map(|cell| format!("{} ", 3 * cell)).collect();
    format!(
        "<VTKFile byte_order='BigEndian' type='UnstructuredGrid'><!-- from a test -->\n\
         <UnstructuredGrid>\n<Piece>\n\
         <PointData/>\n<Points><DataArray type='Float64' NumberOfComponents='3' format='ascii'>\n\
          {}</DataArray></Points>\n\
         <Cells>\n<DataArray type='UInt8' Name='types' format='ascii'>{}</DataArray>\n\
         <DataArray type='Int32' Name='offsets' format='ascii'>{ends}</DataArray>\n\
         <DataArray type='Int64' Name='connectivity' format='ascii'>\n{}</DataArray>\n\
         </Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
        lines("", frame.positions.iter().copied()),
        "5 ".repeat(cells),
        lines("", frame.mesh.faces().iter().copied()),
    )
}
