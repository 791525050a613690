//! For any bytes, the reader returns an error or a valid mesh.

use exact_ccd_files::{Format, parse_frame, parse_tet_mesh};
use exact_ccd_mesh::{Frame, TetMesh};
use proptest::prelude::*;

use super::writer::{Contents, all};

fn samples() -> Vec<(String, Vec<u8>)> {
    let positions = [
        [0.0; 3],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    let tetrahedra = [[0, 1, 2, 3], [0, 1, 2, 4]];
    let mut contents = Contents::new(&positions, &[[0, 1, 2], [0, 1, 3]], &tetrahedra);
    contents.physical = [vec![], vec![], vec![5], vec![99, -7]];
    all(&contents)
}

fn assert_sound_or_error(bytes: &[u8]) {
    let mesh = parse_tet_mesh(bytes);
    if let Ok((mesh, groups)) = &mesh {
        for group in groups {
            let is_increasing = |numbers: &[u32]| numbers.is_sorted_by(|a, b| a < b);
            assert!(
                is_increasing(&group.vertices) && is_increasing(&group.cells),
                "{group:?}"
            );
            let below =
                |numbers: &[u32], count: usize| numbers.last().is_none_or(|&last| (last as usize) < count);
            assert!(below(&group.vertices, mesh.positions().len()));
            assert!(below(&group.cells, mesh.tetrahedra().len()));
            assert!(!group.name.contains(char::is_control), "{group:?}");
        }
    }
    let frame = parse_frame(bytes, Format::Msh);
    for error in [mesh.as_ref().err(), frame.as_ref().err()].into_iter().flatten() {
        let message = error.to_string();
        assert!(!message.chars().any(char::is_control), "{message:?}");
        assert!(message.len() < 400, "{message:?}");
    }
    if let Ok((mesh, _)) = mesh {
        let count = mesh.positions().len();
        let indices = [mesh.tetrahedra().as_flattened(), mesh.surface().as_flattened()].concat();
        assert!(indices.iter().all(|&vertex| (vertex as usize) < count));
        assert_eq!(
            TetMesh::new(mesh.positions().to_vec(), mesh.tetrahedra().to_vec()),
            Ok(mesh)
        );
    }
    if let Ok(frame) = frame {
        assert_eq!(
            Frame::new(frame.positions.clone(), frame.mesh.faces().to_vec()),
            Ok(frame)
        );
    }
}

#[test]
fn every_beginning_of_a_file_is_an_error_or_valid() {
    for (_, bytes) in samples() {
        for length in 0..bytes.len() {
            assert_sound_or_error(&bytes[..length]);
        }
    }
}

#[test]
fn every_byte_may_be_any_other() {
    for (_, mut bytes) in samples() {
        for at in 0..bytes.len() {
            let before = bytes[at];
            for value in [
                0,
                1,
                b'\n',
                b'0',
                b'9',
                b'$',
                0x7f,
                0xff,
                before ^ 1,
                before ^ 0x80,
            ] {
                bytes[at] = value;
                assert_sound_or_error(&bytes);
            }
            bytes[at] = before;
        }
    }
}

proptest! {
    #[test]
    fn pieces_of_files_in_any_order(
        pieces in prop::collection::vec((any::<prop::sample::Index>(), 0.0..1.0, 1..200_usize), 0..6)
    ) {
        let samples = samples();
        let mut bytes = Vec::new();
        for (sample, start, length) in pieces {
            let file = &sample.get(&samples).1;
            let start = (start * file.len() as f64) as usize;
            bytes.extend(&file[start..file.len().min(start + length)]);
        }
        assert_sound_or_error(&bytes);
        for (_, file) in &samples {
            for end in ["$EndMeshFormat\n", "$EndNodes\n"] {
                let cut = file.windows(end.len()).position(|window| window == end.as_bytes());
                if let Some(cut) = cut {
                    assert_sound_or_error(&[&file[..cut + end.len()], &bytes].concat());
                }
            }
        }
    }
}
