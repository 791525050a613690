//! Mesh files: no bytes make a reader panic, and every frame that is read can be written and read again.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd_files::{Format, FrameSequence, Group, Polygons, parse_frame, parse_tet_mesh, write_ply};
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
    "$PhysicalNames\n1\n3 7 \"a\"\n$EndPhysicalNames\n",
    "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 2 7 -8 0\n$EndEntities\n",
    "$Entities\n",
    "$EndEntities\n",
    "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n",
    "$Nodes\n1 4 1 4\n3 0 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n",
    "1 4 2 7 0 1 2 3 4\n",
    "2 2 2 0 0 1 2 3\n",
    "1 1 1 1\n",
    "3 0 4 1\n",
    "3 1 4 1\n",
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

const VTP: &[&str] = &[
    " ",
    "<VTKFile type='PolyData' byte_order='LittleEndian'><PolyData><Piece>",
    "<VTKFile type='PolyData' byte_order='BigEndian' header_type='UInt64' compressor='vtkZLibDataCompressor'>",
    "<VTKFile type='PolyData' byte_order='LittleEndian' compressor='vtkLZ4DataCompressor'><PolyData><Piece>",
    "<PolyData><Piece NumberOfPoints='4'>",
    "</Piece></PolyData>",
    "</VTKFile>",
    "<Points><DataArray type='Float64' format='ascii'>0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>",
    "<Points><DataArray type='Float32' format='appended' offset='0'/></Points>",
    "<Points><DataArray type='Float32' format='binary'>",
    "<Polys>",
    "</Polys>",
    "<Strips>",
    "</Strips>",
    "<Lines>",
    "</Lines>",
    "<DataArray type='Int64' Name='connectivity' format='ascii'>0 1 2 3</DataArray>",
    "<DataArray type='UInt8' Name='offsets' format='ascii'>3</DataArray>",
    "<DataArray type='UInt8' Name='offsets' format='appended' offset='12'/>",
    "<AppendedData encoding='raw'>_",
    "<AppendedData encoding='base64'>_",
    "</AppendedData>",
    "AQAAAAwAAAAAAAAA",
    "\x01\0\0\0",
    "\x0c\0\0\0",
    "\0\0\0\0",
    "\0\0\0\x01",
];

const VTK: &[&str] = &[
    "\n",
    " ",
    "# vtk DataFile Version 3.0\n\nASCII\n",
    "# vtk DataFile Version 5.1\n\nBINARY\n",
    "DATASET POLYDATA\n",
    "DATASET UNSTRUCTURED_GRID\n",
    "POINTS 4 float\n",
    "POINTS 1 unsigned_char\n",
    "0 0 0 1 0 0 0 1 0 0 0 1\n",
    "POLYGONS 1 4\n3 0 1 2\n",
    "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n",
    "LINES 2 2\nOFFSETS vtktypeint64\n",
    "CONNECTIVITY int\n",
    "CELLS 1 9\n8 0 1 2 3 0 1 2 3\n",
    "CELL_TYPES 1\n",
    "12 ",
    "14 ",
    "FIELD FieldData 1\na 1 2 float\n",
    "METADATA\n",
    "POINT_DATA 4\n",
    "\0\0\0\x02",
];

const GLTF: &[&str] = &[
    " ",
    "{\"asset\":{\"version\":\"2.0\"},",
    "\"scenes\":[{\"nodes\":[0]}],",
    "\"nodes\":[{\"mesh\":0}],",
    "\"nodes\":[{\"children\":[1]},{\"mesh\":0,\"scale\":[2,1,1]}],",
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],",
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1,\"mode\":5}]}],",
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],     \"max\":[1,1,1]},{\"bufferView\":0,\"componentType\":5121,\"count\":9,\"type\":\"SCALAR\"}],",
    "\"byteOffset\":8,",
    "\"byteStride\":4,",
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],",
    "\"buffers\":[{\"byteLength\":36,\"uri\":\"data:;base64,AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA\"}]}",
    "glTF\x02\0\0\0",
    "JSON",
    "BIN\0",
    "9",
];

const NPY: &[&str] = &[
    " ",
    "NUMPY\x01\0",
    "\x3b\0",
    "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 1, 3)}",
    "{'descr': '>i2', 'fortran_order': True, 'shape': (1, 2, 3)}",
    "{'shape': (",
    "99999999999",
    "0, ",
    ")}",
    "\0\0\0\0",
];

const CACHE: &[&str] = &[
    "POINTCACHE2\0",
    "\x01\0\0\0",
    "\x03\0\0\0",
    "\x02\0\0\0",
    "\0\0\0\x01",
    "\0\0\0\x03",
    "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0",
];

fuzz_target!(|bytes: &[u8]| {
    // The only error is that the bytes run out, which ends the case.
    let _ = check(&mut Unstructured::new(bytes));
});

fn check(bytes: &mut Unstructured) -> Result<()> {
    let (format, words) = match bytes.arbitrary::<u8>()? % 14 {
        0 => (Format::Ply, PLY),
        1 => (Format::Obj, OBJ),
        2 => (Format::Stl, STL),
        3 => (Format::Off, OFF),
        4 => (Format::Msh, MSH),
        5 => (Format::Vtu, VTU),
        6 | 7 => (Format::Vtp, VTP),
        8 => (Format::Vtk, VTK),
        9 => (Format::Gltf, GLTF),
        10 => (Format::Npy, NPY),
        12 => return Ok(check_cache("pc2", &file(bytes, CACHE)?)),
        13 => return Ok(check_cache("mdd", &file(bytes, CACHE)?)),
        _ => (Format::Npz, NPY),
    };
    let mut file = file(bytes, words)?;
    if format == Format::Npy {
        // No text begins with this byte.
        file.insert(0, 0x93);
    }
    match parse_tet_mesh(&file) {
        Ok((mesh, groups)) => {
            let [vertices, cells] = [mesh.positions().len(), mesh.tetrahedra().len()];
            groups
                .iter()
                .for_each(|group| check_group(group, vertices, cells));
            check_frame(&mesh.surface_frame().0);
        }
        Err(error) => drop(error.to_string()),
    }
    match parse_frame(&file, format) {
        Ok(frame) => check_frame(&frame),
        Err(error) => drop(error.to_string()),
    }
    Ok(())
}

/// Frames of a cache of positions have the vertices of the mesh, and finite coordinates.
fn check_cache(extension: &str, cache: &[u8]) {
    let folder = std::env::temp_dir();
    let place = |name: &str| folder.join(format!("exact-ccd-fuzz-{}.{name}", std::process::id()));
    let (mesh, path) = (place("obj"), place(extension));
    std::fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("the folder is for files");
    std::fs::write(&path, cache).expect("the folder is for files");
    match FrameSequence::open_cache(&mesh, &path, Polygons::Refuse) {
        Ok(sequence) => {
            for frame in 0..sequence.len() {
                match sequence.read(frame) {
                    Ok(file) => check_frame(&file.frame),
                    Err(error) => drop(error.to_string()),
                }
            }
        }
        Err(error) => drop(error.to_string()),
    }
}

fn check_group(group: &Group, vertices: usize, cells: usize) {
    for (numbers, count) in [(&group.vertices, vertices), (&group.cells, cells)] {
        assert!(numbers.is_sorted_by(|a, b| a < b));
        assert!(numbers.last().is_none_or(|&last| (last as usize) < count));
    }
}

fn check_frame(frame: &Frame) {
    if frame.positions.is_empty() {
        return;
    }
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
