//! Every version and encoding gives the same mesh, bit for bit.

use exact_ccd_files::{Format, MeshFile, Polygons, parse_frame, parse_tet_mesh};
use exact_ccd_mesh::{Frame, Point, TetMesh};
use proptest::prelude::*;

use super::writer::{Contents, all};

fn bits(positions: &[Point]) -> Vec<u64> {
    positions.as_flattened().iter().map(|x| x.to_bits()).collect()
}

/// Two tetrahedra with a common face and extreme coordinates, one of negative volume.
fn sample() -> (Vec<Point>, Vec<[u32; 4]>) {
    let positions = vec![
        [-0.0, 0.1, 0.0],
        [1e300, 1.0 / 3.0, f64::from_bits(1)],
        [0.0, 0.30000000000000004, f64::MIN_POSITIVE / 3.0],
        [0.0, 0.0, 1e-300],
        [f64::MAX, f64::MAX, f64::MAX],
    ];
    (positions, vec![[0, 1, 2, 3], [1, 2, 3, 4]])
}

#[test]
fn all_versions_and_encodings_give_the_same_tetrahedra() {
    let (positions, tetrahedra) = sample();
    let expected = TetMesh::new(positions.clone(), tetrahedra.clone()).unwrap();
    let listed = [expected.surface(), &[[1, 3, 2]]].concat();
    for triangles in [vec![], listed] {
        for tag in [|vertex| vertex + 1, |vertex| 1000 - 7 * vertex] {
            let contents = Contents::tagged(&positions, &triangles, &tetrahedra, tag);
            for (name, bytes) in all(&contents) {
                let (mesh, _) = parse_tet_mesh(&bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
                assert_eq!(mesh, expected, "{name}");
                assert_eq!(bits(mesh.positions()), bits(&positions), "{name}");
                let frame = parse_frame(&bytes, Format::Msh).unwrap();
                assert_eq!(frame, expected.surface_frame().0, "{name}");
                let ids = MeshFile::parse(&bytes, Format::Msh, Polygons::Refuse)
                    .unwrap()
                    .ids;
                let surface = vec![None; expected.surface().len()];
                assert_eq!((ids.faces, ids.face_count), (surface, triangles.len()), "{name}");
            }
        }
    }
}

#[test]
fn triangles_without_tetrahedra_are_a_frame_as_they_are() {
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [5.0, 5.0, 5.0]];
    let frame = Frame::new(positions.to_vec(), vec![[2, 0, 1], [1, 1, 3]]).unwrap();
    for (name, bytes) in all(&Contents::new(&positions, frame.mesh.faces(), &[])) {
        assert_eq!(parse_frame(&bytes, Format::Msh).unwrap(), frame, "{name}");
    }
}

#[test]
fn a_file_without_elements_is_valid() {
    for (name, bytes) in all(&Contents::default()) {
        assert!(
            parse_tet_mesh(&bytes).unwrap().0.tetrahedra().is_empty(),
            "{name}"
        );
    }
}

fn coordinate() -> impl Strategy<Value = f64> {
    use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO, -1.0..1.0]
}

proptest! {
    #[test]
    fn any_tetrahedron_survives_every_encoding(
        positions in prop::collection::vec(prop::array::uniform3(coordinate()), 4..9),
        tags in Just((1..10_000).collect::<Vec<u32>>()).prop_shuffle(),
    ) {
        let mesh = TetMesh::new(positions.clone(), vec![[0, 1, 2, 3]]);
        let contents = Contents::tagged(&positions, &[], &[[0, 1, 2, 3]], |vertex| tags[vertex as usize]);
        for (name, bytes) in all(&contents) {
            match &mesh {
                Ok(mesh) => {
                    let (read, _) = parse_tet_mesh(&bytes).unwrap();
                    prop_assert_eq!(&read, mesh, "{}", &name);
                    prop_assert_eq!(bits(read.positions()), bits(&positions), "{}", &name);
                }
                Err(error) => {
                    let found = parse_tet_mesh(&bytes).unwrap_err().to_string();
                    prop_assert_eq!(found, error.to_string(), "{}", &name);
                }
            }
        }
    }
}
