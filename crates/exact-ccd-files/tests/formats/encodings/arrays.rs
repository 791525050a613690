//! Arrays in numpy's and in Khronos' formats, by writers that are independent of the crate.

use std::io::{Cursor, Write};

use exact_ccd_mesh::Frame;
use zip::write::SimpleFileOptions;

/// A `.npy` file.
pub(super) fn npy(descr: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(data);
    bytes
}

pub(super) fn npz(frame: &Frame) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let coordinates = frame.positions.as_flattened().iter();
    let positions: Vec<u8> = coordinates.flat_map(|x| x.to_be_bytes()).collect();
    let corners = frame.mesh.faces().as_flattened().iter();
    let faces: Vec<u8> = corners.flat_map(|corner| corner.to_le_bytes()).collect();
    let (vertex_count, face_count) = (frame.positions.len(), frame.mesh.faces().len());
    for (name, array) in [
        ("velocities.npy", npy("<f4", "(0, 3)", &[])),
        (
            "positions.npy",
            npy(">f8", &format!("(1, {vertex_count}, 3)"), &positions),
        ),
        ("faces.npy", npy("<u4", &format!("({face_count}, 3)"), &faces)),
        ("text.npy", npy("<U4", "(0,)", &[])),
    ] {
        zip.start_file(name, SimpleFileOptions::default()).unwrap();
        zip.write_all(&array).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// A triangle soup as binary glTF, below a node with the identity as its matrix.
pub(super) fn glb(frame: &Frame) -> Vec<u8> {
    let coordinates = frame.positions.as_flattened().iter();
    let mut data: Vec<u8> = coordinates.flat_map(|&x| (x as f32).to_le_bytes()).collect();
    let length = data.len();
    let count = frame.positions.len();
    let mut json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
"nodes":[{{"children":[1],"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}},{{"mesh":0}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":{count},"type":"VEC3",
"min":[0,0,0],"max":[1,1,1]}}],
"bufferViews":[{{"buffer":0,"byteLength":{length}}}],"buffers":[{{"byteLength":{length}}}]}}"#
    )
    .into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    data.resize(length.next_multiple_of(4), 0);
    let chunk = |kind: &[u8; 4], data: &[u8]| [&(data.len() as u32).to_le_bytes()[..], kind, data].concat();
    let chunks = [chunk(b"JSON", &json), chunk(b"BIN\0", &data)].concat();
    let length = (12 + chunks.len() as u32).to_le_bytes();
    [b"glTF\x02\0\0\0", &length[..], &chunks].concat()
}
