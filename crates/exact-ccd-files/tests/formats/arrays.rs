//! Arrays of numpy, and the meshes of glTF: invalid files, shapes and transforms.

use super::temporary;
use exact_ccd_files::{Format, FrameSequence, Polygons, parse_frame, read_frame};

fn npy(header: &str, data: &[u8]) -> Vec<u8> {
    let mut bytes = b"\x93NUMPY\x02\x00".to_vec();
    bytes.extend((header.len() as u32).to_le_bytes());
    [&bytes, header.as_bytes(), data].concat()
}

#[test]
fn an_array_of_positions_is_a_sequence_of_points() {
    // Position (t, n, k) is 100 t + 10 n + k, and t varies fastest.
    let numbers = (0..3).flat_map(|k| (0..2).flat_map(move |n| (0..4).map(move |t| 100 * t + 10 * n + k)));
    let data: Vec<u8> = numbers.flat_map(|number: i16| number.to_be_bytes()).collect();
    let file = npy(
        "{\"shape\": (4, 2, 3), \"fortran_order\": True, \"descr\": \">i2\"}",
        &data,
    );
    let sequence = FrameSequence::open(temporary("arrays/points.npy", &file), Polygons::Refuse).unwrap();
    assert_eq!(sequence.len(), 4);
    for (frame, file) in sequence.iter().enumerate() {
        let x = 100.0 * frame as f64;
        let expected = [[x, x + 1.0, x + 2.0], [x + 10.0, x + 11.0, x + 12.0]];
        assert_eq!(file.unwrap().frame.positions, expected);
        assert!(
            sequence
                .name(frame)
                .ends_with(&format!("points.npy, frame {frame}"))
        );
    }
    let error = parse_frame(&file, Format::Npy).unwrap_err().to_string();
    assert_eq!(
        error,
        "expected one frame (read a file of several as a sequence), found 4 frames"
    );
}

#[test]
fn frames_that_are_not_finite_are_errors_when_they_are_read() {
    let data: Vec<u8> = [0.0, 1.0, 2.0, 3.0, f32::NAN, 5.0].map(f32::to_le_bytes).concat();
    let file = npy(
        "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 1, 3)}",
        &data,
    );
    let sequence = FrameSequence::open(temporary("arrays/nan.npy", &file), Polygons::Refuse).unwrap();
    assert!(sequence.read(0).is_ok());
    let error = sequence.read(1).unwrap_err().to_string();
    assert!(
        error.ends_with("nan.npy: frame 1: vertex 0 has y = NaN, expected a finite number"),
        "{error}"
    );
}

#[test]
fn invalid_arrays_are_errors() {
    let header = |shape: &str| format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}}}");
    let message = |file: &[u8]| parse_frame(file, Format::Npy).unwrap_err().to_string();
    let three = [0; 24];
    for (header, message_end) in [
        (
            header("(1, 4)"),
            "expected the numbers of an array <f8 (1, 4), found 24 bytes",
        ),
        (
            header("(3,)"),
            "expected positions of shape (T, N, 3) or (N, 3), not empty, found shape [3]",
        ),
        (header("(9999999999, 9999999999, 3)"), "found 24 bytes"),
        (
            header("(1, 3").replace('}', ""),
            "found `{\\'descr\\': \\'<f8\\', \\'fortran_order\\': …`",
        ),
        (
            header("(1, 3)").replace("<f8", "<c16"),
            "or of integers, found `<c16`",
        ),
    ] {
        let found = message(&npy(&header, &three));
        assert!(found.ends_with(message_end), "{found}");
    }
    for shape in ["(0, 3)", "(9999999999, 0, 3)", "(0, 4611686018427387904, 3)"] {
        assert!(
            message(&npy(&header(shape), &[])).contains("not empty"),
            "{shape}"
        );
    }
    assert_eq!(
        message(b"\x93NUM"),
        "byte 0: the file ends, expected `\\x93NUMPY` and a version"
    );
}

/// A triangle in a buffer in base64, with these nodes and these parts of its primitive.
fn gltf(nodes: &str, primitive: &str) -> String {
    use base64::Engine;
    let corners = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.1, 1.0, 0.0]];
    let data: Vec<u8> = corners.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let data = base64::engine::general_purpose::STANDARD.encode(data);
    format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{nodes}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}{primitive}}}]}}],
"skins":[{{"joints":[0]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}}],
"bufferViews":[{{"buffer":0,"byteLength":36}}],
"buffers":[{{"byteLength":36,"uri":"data:application/octet-stream;base64,{data}"}}]}}"#
    )
}

#[test]
fn nodes_place_their_meshes() {
    // A quarter turn around z, twice as large, and a shift, in a node that mirrors x.
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let nodes = format!(
        r#"{{"children":[1],"scale":[-1,1,1]}},
{{"mesh":0,"translation":[5,0,0.5],"rotation":[0,0,{half:?},{half:?}],"scale":[2,2,2]}}"#
    );
    let frame = parse_frame(gltf(&nodes, "").as_bytes(), Format::Gltf).unwrap();
    let expected = [[-5.0, 0.0, 0.5], [-5.0, 2.0, 0.5], [-3.0, 0.2, 0.5]];
    for (found, expected) in frame.positions.iter().zip(expected) {
        let near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6);
        assert!(near, "{found:?}, expected {expected:?}");
    }
    // Decimals are the nearest f64.
    let shifted = gltf(r#"{"mesh":0,"translation":[0.1,0,0]}"#, "");
    let shifted = parse_frame(shifted.as_bytes(), Format::Gltf).unwrap();
    assert_eq!(shifted.positions[0], [0.1, 0.0, 0.0]);
    // A shift alone is one exact sum here, and no transform changes no bit.
    let shifted = gltf(r#"{"mesh":0,"translation":[0.5,-1,3]}"#, "");
    let shifted = parse_frame(shifted.as_bytes(), Format::Gltf).unwrap();
    let x = f64::from(0.1_f32);
    assert_eq!(
        shifted.positions,
        [[0.5, -1.0, 3.0], [1.5, -1.0, 3.0], [x + 0.5, 0.0, 3.0]]
    );
    let plain = parse_frame(gltf(r#"{"mesh":0}"#, "").as_bytes(), Format::Gltf).unwrap();
    assert_eq!(plain.positions[2], [x, 1.0, 0.0]);
}

#[test]
fn triangles_without_all_their_corners_are_errors() {
    // Bytes 0, 0, 128 and so on of the positions as indices.
    let file = gltf(r#"{"mesh":0}"#, r#","indices":1"#).replacen(
        "\"accessors\":[",
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\
         \"min\":[0,0,0],\"max\":[1,1,0]},{\"bufferView\":0,\"componentType\":5121,\"count\":5,\
         \"type\":\"SCALAR\"},",
        1,
    );
    let error = parse_frame(file.as_bytes(), Format::Gltf).unwrap_err();
    assert_eq!(
        error.to_string(),
        "expected three vertices for each triangle in accessor 1, found 5"
    );
}

/// A file that many buffers name counts once, and so does its size.
#[test]
fn a_file_of_several_buffers_is_read_once() {
    temporary("arrays/positions.bin", vec![0; 1 << 20]);
    let buffers =
        "{\"byteLength\":36,\"uri\":\"positions.bin\"},{\"byteLength\":36,\"uri\":\"./positions.bin\"},";
    let file = gltf(r#"{"mesh":0}"#, "").replacen("\"buffers\":[", &format!("\"buffers\":[{buffers}"), 1);
    let frame = read_frame(temporary("arrays/shared.gltf", file.as_bytes())).unwrap();
    assert_eq!(frame.positions, [[0.0; 3]; 3]);
    let accessor = file.replacen("\"count\":3", "\"count\":12000000", 1);
    let error = read_frame(temporary("arrays/shared.gltf", accessor.as_bytes())).unwrap_err();
    // Twice the size of the file would allow for these positions.
    assert!(
        error.to_string().contains("the data expand to more than"),
        "{error}"
    );
}

#[test]
fn what_a_gltf_mesh_cannot_be_is_named() {
    for (nodes, primitive, message) in [
        (
            r#"{"mesh":0,"skin":0}"#,
            "",
            "expected mesh 0 without a skin (apply it before export), found a skin",
        ),
        (
            r#"{"mesh":0}"#,
            r#","targets":[{"POSITION":0}]"#,
            "expected mesh 0 without morph targets (shape keys) (apply it before export), found morph targets \
             (shape keys)",
        ),
        (
            r#"{"children":[0]}"#,
            "",
            "expected a node with one parent, found node 0 again",
        ),
        (
            r#"{"children":[1,1]},{"mesh":0}"#,
            "",
            "expected a node with one parent, found node 1 again",
        ),
        (
            r#"{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2]}"#,
            "",
            "expected 0 0 0 1 as the last row of the matrix of node 0, found other numbers",
        ),
        (
            r#"{"mesh":0}"#,
            r#","indices":0"#,
            "expected unsigned integers as indices in accessor 0, found something else",
        ),
    ] {
        let error = parse_frame(gltf(nodes, primitive).as_bytes(), Format::Gltf).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
    let file = gltf(r#"{"mesh":0}"#, "");
    for (from, to, message) in [
        (
            "\"count\":3",
            "\"count\":4000000000",
            "the data expand to more than",
        ),
        (
            "\"count\":3",
            "\"count\":4",
            "expected data within its buffer view in accessor 0, found something else",
        ),
        (
            "\"asset\"",
            "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"asset\"",
            "expected a glTF file that does not require this extension",
        ),
        (
            "data:application",
            "../x.bin?",
            "expected data within the file, as in a .glb file",
        ),
    ] {
        let changed = file.replacen(from, to, 1);
        let error = parse_frame(changed.as_bytes(), Format::Gltf)
            .unwrap_err()
            .to_string();
        assert!(error.contains(message), "{error}");
    }
    for (mode, message) in [
        (
            "1",
            "two vertices for each line in primitive 0 without indices, found 3",
        ),
        ("4", ""),
    ] {
        let file = gltf(r#"{"mesh":0}"#, &format!(",\"mode\":{mode}"));
        match parse_frame(file.as_bytes(), Format::Gltf) {
            Ok(_) => assert_eq!(message, "", "{mode}"),
            Err(error) => assert!(error.to_string().contains(message), "{error}"),
        }
    }
    let outside = file.replacen("data:application/octet-stream;base64,", "%2e%2e/", 1);
    let error = read_frame(temporary("arrays/outside.gltf", outside.as_bytes()))
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("expected a file in the same folder, found `%2e%2e/"),
        "{error}"
    );
}
