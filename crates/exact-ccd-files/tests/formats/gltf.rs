//! The scenes of glTF: instances, animations, quantized meshes and extensions.

use base64::Engine;
use exact_ccd_files::{Fact, Format, FrameSequence, MeshFile, Polygons, parse_frame};
use exact_ccd_mesh::Point;

use crate::temporary;

/// A list of accessors in one buffer.
#[derive(Default)]
struct Buffer {
    data: Vec<u8>,
    views: Vec<String>,
    accessors: Vec<String>,
}

impl Buffer {
    /// Appends an accessor, whose elements have this size, and returns its number.
    fn add(&mut self, properties: &str, size: usize, data: &[u8]) -> usize {
        let (offset, length) = (self.data.len(), data.len());
        self.data.extend(data);
        self.data.resize(self.data.len().next_multiple_of(4), 0);
        let view = self.views.len();
        self.views.push(format!(
            r#"{{"buffer":0,"byteOffset":{offset},"byteLength":{length}}}"#
        ));
        let count = length / size;
        self.accessors
            .push(format!(r#"{{"bufferView":{view},"count":{count},{properties}}}"#));
        view
    }

    fn floats<const N: usize>(&mut self, numbers: &[[f32; N]]) -> usize {
        let shape = ["SCALAR", "VEC2", "VEC3", "VEC4"][N - 1];
        let data: Vec<u8> = numbers
            .as_flattened()
            .iter()
            .flat_map(|x| x.to_le_bytes())
            .collect();
        self.add(&format!(r#""componentType":5126,"type":"{shape}""#), 4 * N, &data)
    }

    /// The file with these further properties. Node 0 is the only root.
    fn file(&self, nodes: &str, primitive: &str, more: &str) -> String {
        let data = base64::engine::general_purpose::STANDARD.encode(&self.data);
        format!(
            r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"nodes":[{nodes}],"accessors":[{}],
"meshes":[{{"primitives":[{{{primitive}}}]}}],"bufferViews":[{}],
"buffers":[{{"byteLength":{},"uri":"data:application/octet-stream;base64,{data}"}}]{more}}}"#,
            self.accessors.join(","),
            self.views.join(","),
            self.data.len()
        )
    }
}

const TRIANGLE: [[f32; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
const PRIMITIVE: &str = r#""attributes":{"POSITION":0}"#;

/// A file with one triangle, of which accessor 0 has the positions.
fn triangle() -> Buffer {
    let mut buffer = Buffer::default();
    buffer.floats(&TRIANGLE);
    buffer
}

fn open(name: &str, file: &str) -> FrameSequence {
    FrameSequence::open(temporary(&format!("gltf/{name}.gltf"), file), Polygons::Refuse).unwrap()
}

/// The first vertex in each frame.
fn path(sequence: &FrameSequence) -> Vec<Point> {
    sequence
        .iter()
        .map(|file| file.unwrap().frame.positions[0])
        .collect()
}

fn animation(channels: &[(usize, usize, usize, &str, &str)]) -> String {
    let list = channels.iter().enumerate().map(|(k, (_, _, node, path, _))| {
        format!(r#"{{"sampler":{k},"target":{{"node":{node},"path":"{path}"}}}}"#)
    });
    let samplers = channels.iter().map(|(input, output, _, _, interpolation)| {
        format!(r#"{{"input":{input},"output":{output},"interpolation":"{interpolation}"}}"#)
    });
    format!(
        r#"{{"channels":[{}],"samplers":[{}]}}"#,
        list.collect::<Vec<_>>().join(","),
        samplers.collect::<Vec<_>>().join(",")
    )
}

#[test]
fn translations_are_frames_at_all_keys() {
    let mut buffer = triangle();
    let slow = buffer.floats(&[[0.0], [2.0]]);
    let along_x = buffer.floats(&[[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]]);
    let late = buffer.floats(&[[1.0], [3.0]]);
    let along_y = buffer.floats(&[[0.0, 1.0, 0.0], [0.0, 9.0, 0.0]]);
    let channels = [
        (slow, along_x, 0, "translation", "LINEAR"),
        (late, along_y, 1, "translation", "LINEAR"),
    ];
    let more = format!(r#","animations":[{}]"#, animation(&channels));
    // The parent is scaled, so that the translation of the child counts twice.
    let file = buffer.file(r#"{"children":[1],"scale":[2,2,2]},{"mesh":0}"#, PRIMITIVE, &more);
    let sequence = open("linear", &file);
    let times: Vec<_> = (0..sequence.len()).map(|frame| sequence.time(frame)).collect();
    assert_eq!(times, [0.0, 1.0, 2.0, 3.0].map(Some));
    assert_eq!(
        path(&sequence),
        [
            [0.0, 2.0, 0.0],
            [2.0, 2.0, 0.0],
            [4.0, 10.0, 0.0],
            [4.0, 18.0, 0.0]
        ]
    );
    assert_eq!(sequence.read(0).unwrap().notes, []);
    // One frame, at rest, has a note.
    let rest = MeshFile::parse(file.as_bytes(), Format::Gltf, Polygons::Refuse).unwrap();
    assert_eq!(rest.frame.positions[0], [0.0; 3]);
    assert!(
        rest.notes[0]
            .to_string()
            .contains("the animation; the meshes are at rest")
    );
}

#[test]
fn a_jump_has_a_frame_before_it_and_one_after_it() {
    let mut buffer = triangle();
    let times = buffer.floats(&[[0.0], [1.0], [2.0]]);
    let values = buffer.floats(&[[0.0, 0.0, 0.0], [5.0, 0.0, 0.0], [5.0, 0.0, 0.0]]);
    let more = format!(
        r#","animations":[{}]"#,
        animation(&[(times, values, 0, "translation", "STEP")])
    );
    let sequence = open("step", &buffer.file(r#"{"mesh":0}"#, PRIMITIVE, &more));
    assert_eq!(
        path(&sequence),
        [[0.0; 3], [0.0; 3], [5.0, 0.0, 0.0], [5.0, 0.0, 0.0]]
    );
    assert_eq!(sequence.read(0).unwrap().notes[0].fact, Fact::Jumps);
}

#[test]
fn rotations_and_scales_of_one_value_are_the_pose() {
    let mut buffer = triangle();
    let times = buffer.floats(&[[0.0], [1.0]]);
    let values = buffer.floats(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
    let scales = buffer.floats(&[[3.0, 3.0, 3.0]; 2]);
    let turn = buffer.floats(&[[0.0, 0.0, 1.0, 0.0]; 2]);
    let channels = [
        (times, values, 0, "translation", "LINEAR"),
        (times, scales, 0, "scale", "LINEAR"),
        (times, turn, 0, "rotation", "STEP"),
    ];
    let more = format!(r#","animations":[{}]"#, animation(&channels));
    let sequence = open(
        "pose",
        &buffer.file(r#"{"mesh":0,"scale":[9,9,9]}"#, PRIMITIVE, &more),
    );
    let last = sequence.read(1).unwrap();
    assert_eq!(
        last.frame.positions,
        [[1.0, 0.0, 0.0], [-2.0, 0.0, 0.0], [1.0, -3.0, 0.0]]
    );
    assert_eq!(last.notes, []);
}

#[test]
fn other_animations_are_named_with_the_remedy() {
    let mut buffer = triangle();
    let times = buffer.floats(&[[0.0], [1.0]]);
    let values = buffer.floats(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
    let turns = buffer.floats(&[[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 0.0]]);
    let linear = animation(&[(times, values, 0, "translation", "LINEAR")]);
    for (animations, part) in [
        (
            animation(&[(times, turns, 0, "rotation", "LINEAR")]),
            "the animation of the rotation of node 0; the meshes",
        ),
        (
            animation(&[(times, values, 0, "scale", "LINEAR")]),
            "the animation of the scale of node 0",
        ),
        (
            animation(&[(times, values, 0, "translation", "CUBICSPLINE")]),
            "the animation of the translation of node 0",
        ),
        (
            format!("{linear},{linear}"),
            "2 animations; the meshes are at rest",
        ),
    ] {
        let file = buffer.file(
            r#"{"mesh":0}"#,
            PRIMITIVE,
            &format!(r#","animations":[{animations}]"#),
        );
        let sequence = open("other", &file);
        assert_eq!(path(&sequence), [[0.0; 3]]);
        let note = &sequence.read(0).unwrap().notes[0];
        assert!(
            note.fact.is_warning() && note.to_string().contains(part),
            "{note}"
        );
    }
    // A node that moves no mesh has no effect.
    let camera = animation(&[(times, turns, 1, "rotation", "LINEAR")]);
    let file = buffer.file(
        r#"{"mesh":0,"children":[1]},{}"#,
        PRIMITIVE,
        &format!(r#","animations":[{camera}]"#),
    );
    assert_eq!(open("camera", &file).read(0).unwrap().notes, []);
}

#[test]
fn instances_are_copies() {
    let mut buffer = triangle();
    let translations = buffer.floats(&[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    let scales = buffer.floats(&[[1.0, 1.0, 1.0], [3.0, 3.0, 3.0]]);
    let three = buffer.floats(&[[0.0, 0.0, 0.0, 1.0]; 3]);
    let node = |more: &str| {
        format!(
            r#"{{"mesh":0,"translation":[0,0,1],"extensions":{{"EXT_mesh_gpu_instancing":{{"attributes":{{
"TRANSLATION":{translations},"SCALE":{scales}{more}}}}}}}}}"#
        )
    };
    let used = r#","extensionsRequired":["EXT_mesh_gpu_instancing"]"#;
    let frame = parse_frame(buffer.file(&node(""), PRIMITIVE, used).as_bytes(), Format::Gltf).unwrap();
    assert_eq!(
        frame.positions[..3],
        [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]]
    );
    assert_eq!(
        frame.positions[3..],
        [[2.0, 0.0, 1.0], [5.0, 0.0, 1.0], [2.0, 3.0, 1.0]]
    );
    let file = buffer.file(&node(&format!(r#","ROTATION":{three}"#)), PRIMITIVE, used);
    let error = parse_frame(file.as_bytes(), Format::Gltf)
        .unwrap_err()
        .to_string();
    assert!(error.contains("2 instances in each attribute"), "{error}");
}

#[test]
fn quantized_positions_are_read_exactly() {
    for (component_type, normalized, size, data, x) in [
        (
            5120,
            true,
            3,
            vec![127_u8, 0, 0x80, 0, 0, 0, 0, 0, 0],
            [1.0, 0.0, -1.0],
        ),
        (5121, true, 3, vec![255, 51, 0, 0, 0, 0, 0, 0, 0], [1.0, 0.2, 0.0]),
        (
            5122,
            false,
            6,
            [[0xff_u8, 0xff], [2, 0], [0, 1]].concat().repeat(3),
            [-1.0, 2.0, 256.0],
        ),
        (
            5123,
            true,
            6,
            [[0xff_u8, 0xff], [0, 0], [0x33, 0x33]].concat().repeat(3),
            [1.0, 0.0, 0.2],
        ),
    ] {
        let mut buffer = Buffer::default();
        let properties =
            format!(r#""componentType":{component_type},"type":"VEC3","normalized":{normalized}"#);
        buffer.add(&properties, size, &data);
        let required = r#","extensionsRequired":["KHR_mesh_quantization"]"#;
        let file = buffer.file(r#"{"mesh":0}"#, PRIMITIVE, required);
        let frame = parse_frame(file.as_bytes(), Format::Gltf).unwrap();
        assert_eq!(frame.positions[0], x, "{component_type}");
    }
}

#[test]
fn required_extensions_matter_if_they_concern_geometry() {
    let file = |list: &str| triangle().file(r#"{"mesh":0}"#, PRIMITIVE, &format!(r#",{list}"#));
    let read = |file: &str| MeshFile::parse(file.as_bytes(), Format::Gltf, Polygons::Refuse);
    let harmless = r#""extensionsRequired":["KHR_texture_transform","KHR_texture_basisu","EXT_texture_webp",
"KHR_materials_unlit","KHR_lights_punctual"]"#;
    assert_eq!(read(&file(harmless)).unwrap().notes, []);
    for (extension, remedy) in [
        (
            "KHR_draco_mesh_compression",
            "(export it without compression of meshes",
        ),
        ("EXT_meshopt_compression", "(decompress it with gltf-transform"),
        (
            "VENDOR_unknown",
            "(it may concern geometry: export the file without it)",
        ),
    ] {
        let error = read(&file(&format!(r#""extensionsRequired":["{extension}"]"#)))
            .unwrap_err()
            .to_string();
        assert!(
            error.contains(remedy) && error.ends_with(&format!("found `{extension}`")),
            "{error}"
        );
    }
    let used = read(&file(
        r#""extensionsUsed":["MSFT_lod","KHR_draco_mesh_compression"]"#,
    ))
    .unwrap()
    .notes;
    assert_eq!(used.len(), 1);
    assert!(
        used[0]
            .to_string()
            .starts_with("not read: the extension `MSFT_lod`; "),
        "{}",
        used[0]
    );
    let nodes = triangle().file(r#"{"mesh":0},{"mesh":0}"#, PRIMITIVE, "");
    let left_out = &read(&nodes).unwrap().notes[0];
    assert!(
        left_out
            .to_string()
            .contains("meshes of nodes that are not in the default scene: 1;"),
        "{left_out}"
    );
}
