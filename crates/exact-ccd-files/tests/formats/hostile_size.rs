//! Limits: files that are large, and files in which a few bytes would cost much.

use super::temporary;
use exact_ccd_files::{Fault, Format, FrameSequence, MeshFile, Polygons, ReadOptions, parse_frame};

const OBJ: &[u8] = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

fn message(file: &[u8], format: Format) -> String {
    parse_frame(file, format).unwrap_err().to_string()
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
    std::io::Write::write_all(&mut gzip, bytes).unwrap();
    gzip.finish().unwrap()
}

/// A surface whose arrays are the same part of the appended data.
fn vtp(compressor: &str, arrays: usize, data: &[u8]) -> Vec<u8> {
    let piece = "<Piece><Points><DataArray type='Int8' format='appended' offset='0'/></Points></Piece>";
    let xml = format!(
        "<VTKFile type='PolyData' byte_order='LittleEndian' compressor='{compressor}'><PolyData>{}</PolyData>\
         <AppendedData encoding='raw'>_",
        piece.repeat(arrays)
    );
    [xml.as_bytes(), data].concat()
}

#[test]
fn headers_of_blocks_that_are_named_often_are_errors() {
    // Empty blocks of zlib.
    const BLOCK: &[u8] = b"\x78\x9c\x03\0\0\0\0\x01";
    let blocks = 2700;
    let numbers = [vec![blocks as u32, 0, 0], vec![BLOCK.len() as u32; blocks]].concat();
    let header: Vec<u8> = numbers.into_iter().flat_map(u32::to_le_bytes).collect();
    let file = vtp(
        "vtkZLibDataCompressor",
        330,
        &[header, BLOCK.repeat(blocks)].concat(),
    );
    let error = message(&file, Format::Vtp);
    assert!(error.contains("the data expand to more than"), "{error}");
}

#[test]
fn many_dimensions_are_an_error() {
    let npy = |dimensions: usize| {
        let header = format!(
            "{{'descr': '<f8', 'fortran_order': True, 'shape': (3, {}), }}",
            "1, ".repeat(dimensions - 1)
        );
        let length = (header.len() as u32).to_le_bytes();
        [b"\x93NUMPY\x02\x00", &length[..], header.as_bytes(), &[0; 24]].concat()
    };
    for (dimensions, expected) in [
        (32, "positions of shape (T, N, 3) or (N, 3), not empty"),
        (33, "an array of at most 32 dimensions, found 33"),
        (20_000, "an array of at most 32 dimensions, found 20000"),
    ] {
        let error = message(&npy(dimensions), Format::Npy);
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn many_attributes_and_namespaces_are_errors() {
    let attributes = |count: usize| {
        let attributes: String = (0..count).map(|k| format!(" a{k}=''")).collect();
        format!("<VTKFile type='PolyData'{attributes}></VTKFile>")
    };
    assert!(message(attributes(255).as_bytes(), Format::Vtp).contains("an attribute `byte_order`"));
    assert_eq!(
        message(attributes(256).as_bytes(), Format::Vtp),
        "byte 1: expected at most 256 attributes of an element, found 257"
    );
    let namespaces = |count: usize| {
        let begin: String = (0..count).map(|k| format!("<a xmlns:a{k}='b'>")).collect();
        format!(
            "<VTKFile type='PolyData'>{begin}{}</VTKFile>",
            "</a>".repeat(count)
        )
    };
    assert!(message(namespaces(16).as_bytes(), Format::Vtp).contains("an attribute `byte_order`"));
    assert!(
        message(namespaces(17).as_bytes(), Format::Vtp).contains("expected at most 16 namespaces, found 17")
    );
}

#[test]
fn primitives_of_a_mesh_in_many_nodes_are_errors() {
    let count = 3000;
    let roots: Vec<String> = (0..count).map(|k| k.to_string()).collect();
    let file = format!(
        r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[{}]}}],"nodes":[{}],"meshes":[{{"primitives":[{}]}}]}}"#,
        roots.join(","),
        vec![r#"{"mesh":0}"#; count].join(","),
        vec![r#"{"attributes":{}}"#; count].join(",")
    );
    let error = message(file.as_bytes(), Format::Gltf);
    assert!(error.contains("the data expand to more than"), "{error}");
}

/// Each level may expand to 200 times its size; both together, too.
#[test]
fn compression_within_compression_has_one_limit() {
    let mut zlib = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
    std::io::Write::write_all(&mut zlib, &vec![0; 3_000_000]).unwrap();
    let block = zlib.finish().unwrap();
    let header: Vec<u8> = [1, 3_000_000, 0, block.len() as u32]
        .into_iter()
        .flat_map(u32::to_le_bytes)
        .collect();
    let file = vtp("vtkZLibDataCompressor", 5, &[header, block].concat());
    let compressed = gzip(&[&file[..], &vec![b' '; 100_000]].concat());
    let error =
        MeshFile::read(temporary("size/both.vtp.gz", &compressed), Polygons::Triangulate).unwrap_err();
    assert!(
        error.to_string().contains("the data expand to more than"),
        "{error}"
    );
}

#[test]
fn the_remedy_for_lzma_is_named() {
    let error = message(&vtp("vtkLZMADataCompressor", 1, &[]), Format::Vtp);
    assert!(error.contains("save the file again: in ParaView"), "{error}");
    assert!(error.contains("found `vtkLZMADataCompressor`"), "{error}");
}

#[test]
fn larger_files_than_allowed_are_refused() {
    let path = temporary("size/triangle.obj", OBJ);
    let compressed = temporary("size/triangle.obj.gz", gzip(&[OBJ, &[b'\n'; 1000]].concat()));
    let options = |size: usize| ReadOptions::default().with_max_size(size as u64);
    let limit = |fault: &Fault| match fault {
        Fault::Size { limit } => Some(*limit),
        _ => None,
    };
    assert!(MeshFile::parse(OBJ, Format::Obj, options(OBJ.len())).is_ok());
    let error = MeshFile::parse(OBJ, Format::Obj, options(OBJ.len() - 1)).unwrap_err();
    assert_eq!(limit(&error.fault), Some(OBJ.len() as u64 - 1));
    assert!(MeshFile::read(&path, options(OBJ.len())).is_ok());
    let error = MeshFile::read(&path, options(OBJ.len() - 1))
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("more than 31 bytes, the size that is allowed"),
        "{error}"
    );
    // The data that a file expands to count as well.
    assert!(MeshFile::read(&compressed, options(2000)).is_ok());
    let error = MeshFile::read(&compressed, options(1000))
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("more than 1000 bytes, the size that is allowed"),
        "{error}"
    );
    let sequence = FrameSequence::open(&path, options(10)).unwrap();
    assert!(sequence.read(0).is_err());
}
