//! Mesh files: no bytes make a reader panic, and every frame that is read can be written and read again.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd_files::{Format, parse_frame, parse_tet_mesh, write_ply};
use exact_ccd_fuzz::file;
use exact_ccd_mesh::Frame;
use libfuzzer_sys::fuzz_target;

const PLY: &[&str] = &[
    "\n",
    " ",
    "ply\n",
    "format ascii 1.0\n",
    "format binary_little_endian 1.0\n",
    "format binary_big_endian 1.0\n",
    "comment ",
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n",
    "element vertex 4\nproperty double x\nproperty double y\nproperty double z\n",
    "element face 1\nproperty list uchar int vertex_indices\n",
    "element face 2\nproperty list uint ushort vertex_index\n",
    "element edge 1\nproperty int vertex1\nproperty uchar vertex2\n",
    "element other ",
    "property ",
    "list ",
    "char ",
    "uint8 ",
    "short ",
    "uint ",
    "float64 ",
    "name\n",
    "end_header\n",
    "3 0 1 2\n",
];

const OBJ: &[&str] = &[
    "\n",
    " ",
    "v ",
    "v 0 1 2\n",
    "f ",
    "f 1 2 3\n",
    "f 1/1/1 2//2 -1\n",
    "/",
    "-",
    "# ",
    "\\\n",
    "vn 0 0 1\n",
    "vt 0 0\n",
    "o name\n",
    "usemtl ",
    "l 1 2\n",
    "p 3\n",
];

const STL: &[&str] = &[
    "\n",
    " ",
    "solid ",
    "facet normal 0 0 1\n",
    "outer loop\n",
    "vertex ",
    "vertex 0 1 2\n",
    "endloop\n",
    "endfacet\n",
    "endsolid ",
    "name",
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n",
    "eighty bytes of header, so that the number of faces and the faces can come next: ",
    "\0\0",
];

const OFF: &[&str] = &[
    "\n",
    " ",
    "OFF\n",
    "3 1 0\n",
    "3 0 1 2\n",
    "0 1 2\n",
    "# ",
    "COFF\n",
    "-1",
    "3 ",
];

const MSH: &[&str] = &[
    "\n",
    " ",
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n",
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n",
    "$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n",
    "$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n",
    "$MeshFormat\n4.1 1 8\n\0\0\0\x01\n$EndMeshFormat\n",
    "$Nodes\n",
    "$EndNodes\n",
    "$Elements\n",
    "$EndElements\n",
    "$Comments\n",
    "$EndComments\n",
    "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n",
    "$Nodes\n1 4 1 4\n3 0 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n",
    "1 4 2 0 0 1 2 3 4\n",
    "2 2 2 0 0 1 2 3\n",
    "1 1 1 1\n",
    "3 0 4 1\n",
    "1 1 2 3 4\n",
    "\0\0\0\0",
    "\x04\0\0\0\0\0\0\0",
];

const VTU: &[&str] = &[
    " ",
    "<VTKFile type='UnstructuredGrid' byte_order='LittleEndian'><UnstructuredGrid><Piece>",
    "<VTKFile type='UnstructuredGrid' byte_order='BigEndian' header_type='UInt64'><UnstructuredGrid><Piece>",
    "</Piece></UnstructuredGrid></VTKFile>",
    "<Points><DataArray type='Float64' format='ascii'>0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>",
    "<Points><DataArray type='Float32' format='binary'>",
    "</DataArray></Points>",
    "<Cells>",
    "</Cells>",
    "<DataArray type='Int64' Name='connectivity' format='ascii'>",
    "<DataArray type='Int32' Name='offsets' format='binary'>",
    "<DataArray type='UInt8' Name='types' format='ascii'>",
    "</DataArray>",
    "0 1 2 3",
    "AAAAAAAA",
    "DAAAAA==",
    "5 ",
    "10 ",
    "4 ",
    "3 ",
    "1 ",
    "<",
    "&lt;",
];

fuzz_target!(|bytes: &[u8]| {
    // The only error is that the bytes run out, which ends the case.
    let _ = check(&mut Unstructured::new(bytes));
});

fn check(bytes: &mut Unstructured) -> Result<()> {
    let (format, words) = match bytes.arbitrary::<u8>()? % 6 {
        0 => (Format::Ply, PLY),
        1 => (Format::Obj, OBJ),
        2 => (Format::Stl, STL),
        3 => (Format::Off, OFF),
        4 => (Format::Msh, MSH),
        _ => (Format::Vtu, VTU),
    };
    let file = file(bytes, words)?;
    match parse_tet_mesh(&file) {
        Ok(mesh) => check_frame(&mesh.surface_frame().0),
        Err(error) => drop(error.to_string()),
    }
    match parse_frame(&file, format) {
        Ok(frame) => check_frame(&frame),
        Err(error) => drop(error.to_string()),
    }
    Ok(())
}

fn check_frame(frame: &Frame) {
    let mut written = Vec::new();
    write_ply(&mut written, frame).expect("writing into memory cannot fail");
    let read = parse_frame(&written, Format::Ply).expect("written files are valid");
    assert_eq!(frame, &read);
    let bits = |frame: &Frame| {
        frame
            .positions
            .as_flattened()
            .iter()
            .map(|x| x.to_bits())
            .collect::<Vec<_>>()
    };
    assert_eq!(bits(frame), bits(&read));
}
