//! The same mesh in all encodings of PLY that are covered, and files that are refused.

use exact_ccd_check::Failure;
use exact_ccd_check::ply::{Frame, read};

const HEADER: &str = "comment none\nelement vertex 6\nproperty double x\nproperty float y\nproperty float z\n\
                      property uchar red\nelement face 2\nproperty list uchar int vertex_indices\n\
                      element edge 1\nproperty uint vertex1\nproperty short vertex2\nend_header\n";
const X: [f64; 6] = [0.1, -2.5, 1e-300, 4.0, 1e17, -0.0];

fn text() -> Vec<u8> {
    let rows: String = X.iter().map(|x| format!("{x:?} 0.5 -1.25 255\n")).collect();
    format!("ply\nformat ascii 1.0\n{HEADER}{rows}3 0 1 2\n4 3 2 1 4\n4 5\n").into_bytes()
}

/// The same in binary, with the bytes of each number in an order.
fn binary(format: &str, ordered: impl Fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
    let mut file = format!("ply\nformat {format} 1.0\n{HEADER}").into_bytes();
    for x in X {
        file.extend(ordered(&x.to_le_bytes()));
        file.extend([0.5_f32, -1.25].iter().flat_map(|x| ordered(&x.to_le_bytes())));
        file.push(255);
    }
    for face in [&[0, 1, 2][..], &[3, 2, 1, 4]] {
        file.push(face.len() as u8);
        file.extend(face.iter().flat_map(|corner: &i32| ordered(&corner.to_le_bytes())));
    }
    file.extend(ordered(&4_u32.to_le_bytes()));
    file.extend(ordered(&5_i16.to_le_bytes()));
    file
}

#[test]
fn encodings_agree() {
    let frame: Frame = read(&text()).unwrap();
    assert_eq!(frame.positions[2], [1e-300, 0.5, -1.25]);
    // The polygon is a fan from its lowest vertex.
    assert_eq!(frame.mesh.faces, [[0, 1, 2], [1, 4, 3], [1, 3, 2]]);
    assert_eq!(frame.mesh.edges[..3], [[0, 1], [0, 2], [1, 2]]);
    assert_eq!(frame.mesh.edges[frame.mesh.face_edges..], [[4, 5]]);
    assert_eq!(read(&binary("binary_little_endian", <[u8]>::to_vec)).unwrap(), frame);
    let reversed = |bytes: &[u8]| bytes.iter().rev().copied().collect();
    assert_eq!(read(&binary("binary_big_endian", reversed)).unwrap(), frame);
}

#[test]
fn other_files_are_unreadable() {
    let text = String::from_utf8(text()).unwrap();
    assert!(read(text.as_bytes()).is_ok());
    for (from, to) in [
        ("ply", "obj"),
        ("ascii", "utf8"),
        ("element edge 1", "element strip 1"),
        ("element edge 1", "element face 1"),
        ("element edge 1", "element edge 2"),
        ("property double x", "property int x"),
        ("property double x", "property double w"),
        ("property float y", "property float x"),
        ("property uchar red", "property list uchar int red"),
        ("3 0 1 2", "2 0 1"),
        ("3 0 1 2", "3 0 1 6"),
        ("3 0 1 2", "3 0 1 -1"),
        ("3 0 1 2", "99999999999 0 1 2"),
        ("4 3 2 1 4", "4 3 1 1 4"),
        ("4 5\n", "4 5\n4 5\n"),
    ] {
        let file = text.replacen(from, to, 1);
        assert_ne!(file, text);
        assert!(matches!(read(file.as_bytes()), Err(Failure::Unreadable(_))), "{from} as {to}");
    }
    for length in 0..text.len() - 1 {
        assert!(read(&text.as_bytes()[..length]).is_err(), "{length} bytes");
    }
}
