//! For any bytes, a reader returns an error or a valid frame.

use super::encodings;
use exact_ccd_files::{Format, parse_frame};
use exact_ccd_mesh::Frame;
use proptest::prelude::*;

const FORMATS: [Format; 11] = [
    Format::Ply,
    Format::Obj,
    Format::Stl,
    Format::Off,
    Format::Msh,
    Format::Vtu,
    Format::Vtp,
    Format::Vtk,
    Format::Gltf,
    Format::Npy,
    Format::Npz,
];

/// One file of each encoding, with two triangles.
fn samples() -> Vec<encodings::File> {
    let corners = [[0.0, 0.5, -0.0], [1.0, 0.25, 0.0], [0.0, 1.0, 8.0]].repeat(2);
    let frame = Frame::new(corners, vec![[0, 1, 2], [3, 4, 5]]).unwrap();
    [encodings::indexed(&frame), encodings::soup(&frame)].concat()
}

fn assert_sound_or_error(bytes: &[u8], format: Format) {
    match parse_frame(bytes, format) {
        Ok(frame) => {
            let count = frame.positions.len();
            assert_eq!(count, frame.mesh.vertex_count());
            assert!(frame.positions.as_flattened().iter().all(|x| x.is_finite()));
            assert!(
                frame
                    .mesh
                    .faces()
                    .as_flattened()
                    .iter()
                    .all(|&corner| (corner as usize) < count)
            );
        }
        Err(error) => {
            let message = error.to_string();
            assert!(!message.chars().any(char::is_control), "{message:?}");
            assert!(message.len() < 400, "{message:?}");
        }
    }
}

#[test]
fn every_beginning_of_a_file_is_an_error_or_valid() {
    for (name, format, bytes) in samples() {
        let whole = parse_frame(&bytes, format).unwrap();
        for length in 0..bytes.len() {
            assert_sound_or_error(&bytes[..length], format);
            if name.contains("endian") || name.contains("binary") || name.contains("own") {
                let error = parse_frame(&bytes[..length], format).unwrap_err().to_string();
                assert!(
                    ["the file ends", "found", "the contents are empty"]
                        .iter()
                        .any(|words| error.contains(words)),
                    "{name}: {error}"
                );
            } else if let Ok(part) = parse_frame(&bytes[..length], format) {
                assert!(part.positions.len() <= whole.positions.len());
            }
        }
    }
}

#[test]
fn every_format_reads_as_every_other_without_panic() {
    for (_, _, bytes) in samples() {
        for format in FORMATS {
            assert_sound_or_error(&bytes, format);
        }
    }
}

#[test]
fn counts_beyond_all_bounds_are_errors() {
    for count in [
        "4294967296",
        "1000000000000000000",
        "18446744073709551615",
        "18446744073709551616",
        "1e9",
        "-1",
    ] {
        for (name, format, bytes) in samples() {
            let Ok(text) = String::from_utf8(bytes) else {
                continue;
            };
            for declared in ["element vertex 6", "element face 2", "OFF\n6", "OFF\n6 2"] {
                if !text.contains(declared) {
                    continue;
                }
                let start = declared.trim_end_matches(|c: char| c.is_ascii_digit());
                let changed = text.replacen(declared, &format!("{start}{count}"), 1);
                assert!(
                    parse_frame(changed.as_bytes(), format).is_err(),
                    "{name}: {declared} as {count}"
                );
            }
        }
    }
    let mut stl = vec![0; 80];
    stl.extend([0xff; 4 + 50]);
    assert!(parse_frame(&stl, Format::Stl).is_err());
}

#[test]
fn lists_beyond_all_bounds_are_errors() {
    let header = |list: &str| {
        format!(
            "ply\nformat binary_little_endian 1.0\nelement extra 1\nproperty list {list} values\nelement \
             vertex 0\n\
             property float x\nproperty float y\nproperty float z\nelement face 0\n\
             property list uchar int vertex_indices\nend_header\n"
        )
    };
    for list in ["uint double", "int double", "uint uchar"] {
        let bytes = [header(list).as_bytes(), &[0xff; 100]].concat();
        assert!(parse_frame(&bytes, Format::Ply).is_err());
    }
}

/// Many pieces whose points are the same part of the appended data.
#[test]
fn data_that_are_named_often_are_errors() {
    const LENGTH: u32 = 120_000;
    let piece = "<Piece><Points><DataArray type='Float32' format='appended' offset='0'/></Points></Piece>";
    let file = format!(
        "<VTKFile type='PolyData' byte_order='LittleEndian'><PolyData>{}</PolyData>\
         <AppendedData encoding='raw'>_",
        piece.repeat(600)
    );
    let data = [&LENGTH.to_le_bytes()[..], &[0; LENGTH as usize]].concat();
    let error = parse_frame(&[file.as_bytes(), &data].concat(), Format::Vtp).unwrap_err();
    assert!(
        error.to_string().contains("the data expand to more than"),
        "{error}"
    );
}

#[test]
fn accessors_beyond_all_bounds_are_errors() {
    for (name, format, bytes) in samples()
        .into_iter()
        .filter(|(_, format, _)| *format == Format::Gltf)
    {
        let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
        let count = "\"count\":6";
        assert!(text.contains(count), "{name}");
        for beyond in [u64::MAX, 1 << 63, 1 << 61, u64::MAX / 24 + 1] {
            let changed = text.replacen(count, &format!("\"count\":{beyond}"), 1);
            let grown = changed.len() - text.len();
            let mut bytes: Vec<u8> = changed.chars().map(|byte| byte as u8).collect();
            // The length of the JSON.
            let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) + grown as u32;
            bytes[12..16].copy_from_slice(&length.to_le_bytes());
            assert!(parse_frame(&bytes, format).is_err(), "{name}: {beyond}");
        }
    }
}

/// A change to a file at a position given as a fraction of its length.
#[derive(Clone, Debug)]
enum Edit {
    Set(f64, u8),
    Insert(f64, Vec<u8>),
    Remove(f64, usize),
    Repeat(f64, usize),
    Truncate(f64),
}

impl Edit {
    fn apply(&self, bytes: &mut Vec<u8>) {
        let at = |fraction: f64| (fraction * bytes.len() as f64) as usize;
        match *self {
            Self::Set(fraction, value) => {
                let at = at(fraction);
                bytes[at..].iter_mut().take(1).for_each(|byte| *byte = value);
            }
            Self::Insert(fraction, ref inserted) => {
                let at = at(fraction);
                bytes.splice(at..at, inserted.iter().copied());
            }
            Self::Remove(fraction, length) => {
                let at = at(fraction);
                bytes.drain(at..bytes.len().min(at + length));
            }
            Self::Repeat(fraction, length) => {
                let at = at(fraction);
                let piece = bytes[at..bytes.len().min(at + length)].to_vec();
                bytes.splice(at..at, piece);
            }
            Self::Truncate(fraction) => bytes.truncate(at(fraction)),
        }
    }
}

fn edit() -> impl Strategy<Value = Edit> {
    let words = [
        "\n",
        "\r\n",
        " ",
        "-",
        "1",
        "9999999999",
        "-1",
        "1e999",
        "nan",
        "/",
        "\\\n",
        "#",
        "f ",
        "v ",
        "list",
        "element x 3\n",
        "property int x\n",
        "end_header\n",
        "solid\n",
        "endsolid\n",
        "vertex 0 0 0\n",
        "\0",
        "\u{e9}",
    ];
    let word = prop::sample::select(words.to_vec()).prop_map(|word| word.as_bytes().to_vec());
    let inserted = prop_oneof![word, prop::collection::vec(any::<u8>(), 1..9)];
    prop_oneof![
        (0.0..1.0, any::<u8>()).prop_map(|(at, value)| Edit::Set(at, value)),
        (0.0..1.0, inserted).prop_map(|(at, inserted)| Edit::Insert(at, inserted)),
        (0.0..1.0, 1_usize..40).prop_map(|(at, length)| Edit::Remove(at, length)),
        (0.0..1.0, 1_usize..40).prop_map(|(at, length)| Edit::Repeat(at, length)),
        (0.0..1.0).prop_map(Edit::Truncate),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_edit_of_any_file_is_an_error_or_valid(edits in prop::collection::vec(edit(), 1..6)) {
        for (_, format, mut bytes) in samples() {
            edits.iter().for_each(|edit| edit.apply(&mut bytes));
            assert_sound_or_error(&bytes, format);
        }
    }

    #[test]
    fn any_bytes_are_an_error_or_valid(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        for format in FORMATS {
            assert_sound_or_error(&bytes, format);
        }
    }
}
