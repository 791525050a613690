//! The roles of arrays in `.npz` files: nothing is guessed without a word.

use super::npz::{self, archive, floats, integers};
use super::temporary;
use exact_ccd_files::{Format, FrameSequence, MeshFile, ParseError, Polygons, parse_frame};

/// Two triangles, one above the other.
const POSITIONS: [f64; 18] = [
    0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, //
    0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 0.0, 1.0, 1.0,
];

fn read(arrays: &[(&str, Vec<u8>)]) -> Result<MeshFile, ParseError> {
    MeshFile::parse(&archive(arrays), Format::Npz, Polygons::Triangulate)
}

fn positions() -> Vec<u8> {
    floats("(6, 3)", &POSITIONS)
}

#[track_caller]
fn assert_error(arrays: &[(&str, Vec<u8>)], parts: &[&str]) {
    let error = read(arrays).unwrap_err().to_string();
    for part in parts {
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn a_list_with_counts_reads_as_its_faces() {
    let faces = integers("(8,)", &[3, 0, 1, 2, 3, 3, 4, 5]);
    let file = read(&[("points", positions()), ("faces", faces)]).unwrap();
    assert_eq!(file.frame.mesh.faces(), [[0, 1, 2], [3, 4, 5]]);
    // Twelve numbers, which are also four triangles.
    let faces = integers("(12,)", &[3, 0, 1, 2, 3, 3, 4, 5, 3, 0, 1, 5]);
    let file = read(&[("points", positions()), ("faces", faces)]).unwrap();
    assert_eq!(file.frame.mesh.faces(), [[0, 1, 2], [3, 4, 5], [0, 1, 5]]);
    let mixed = integers("(9,)", &[4, 0, 1, 4, 3, 3, 0, 1, 2]);
    let file = read(&[("points", positions()), ("faces", mixed)]).unwrap();
    assert_eq!((file.contents.faces, file.contents.polygons), (3, 1));
    let lines = integers("(7,)", &[3, 0, 1, 2, 2, 4, 5]);
    let file = read(&[("points", positions()), ("lines", lines)]).unwrap();
    assert_eq!(file.frame.mesh.loose_edges(), [[0, 1], [1, 2], [4, 5]]);
}

#[test]
fn a_list_of_another_form_is_an_error() {
    let flat = || integers("(6,)", &[0, 1, 2, 3, 4, 5]);
    let counted = || integers("(12,)", &[3, 0, 1, 2, 3, 3, 4, 5, 3, 0, 1, 5]);
    assert_error(
        &[("points", positions()), ("faces", flat())],
        &["reshape(-1, 3)", "in `faces`", "begin with [0, 1, 2, 3, 4, 5]"],
    );
    for name in ["triangles", "tri_indices", "indices"] {
        let file = read(&[("points", positions()), (name, flat())]).unwrap();
        assert_eq!(file.frame.mesh.faces(), [[0, 1, 2], [3, 4, 5]]);
        assert_error(
            &[("points", positions()), (name, counted())],
            &["reshape(-1, 3)", name, "may have the number of corners"],
        );
    }
    // The rows of `mesh.faces.reshape(-1, 4)` of pyvista, with the counts as the first column.
    let rows = integers("(2, 4)", &[3, 0, 1, 2, 3, 3, 4, 5]);
    assert_error(
        &[("points", positions()), ("faces", rows)],
        &["[:, 1:]", "in `faces`"],
    );
}

#[test]
fn several_candidates_for_the_positions_are_an_error() {
    let faces = || integers("(2, 3)", &[0, 1, 2, 3, 4, 5]);
    let x = || floats("(2, 3, 3)", &POSITIONS);
    assert_error(
        &[("x", x()), ("v", x()), ("faces", faces())],
        &[
            "an array named `positions`",
            "found `x` <f8 (2, 3, 3), `v` <f8 (2, 3, 3)",
        ],
    );
    assert_error(
        &[
            ("vertices", positions()),
            ("points", positions()),
            ("faces", faces()),
        ],
        &[
            "rename the others",
            "found `vertices` <f8 (6, 3), `points` <f8 (6, 3)",
        ],
    );
    for name in ["pos", "positions", "Vertices"] {
        let file = read(&[("v", x()), (name, positions()), ("faces", faces())]).unwrap();
        assert_eq!(file.frame.positions.len(), 6);
        let arrays = format!("positions from `{name}`, faces from `faces`, not read: `v`");
        assert_eq!(file.arrays, Some(arrays));
    }
    let file = read(&[("u", positions()), ("faces", faces())]).unwrap();
    assert_eq!(file.arrays.unwrap(), "positions from `u`, faces from `faces`");
}

#[test]
fn a_known_name_with_another_type_or_shape_is_an_error() {
    let edges = || integers("(1, 2)", &[0, 1]);
    let faces = || floats("(2, 3)", &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_error(
        &[("points", positions()), ("edges", edges()), ("faces", faces())],
        &[
            "expected integers of shape (F, k)",
            "as `faces`, found <f8 (2, 3)",
        ],
    );
    assert_error(
        &[
            ("points", floats("(9, 2)", &POSITIONS)),
            ("x", positions()),
            ("edges", edges()),
        ],
        &["(T, N, 3) or (N, 3) as `points`, found <f8 (9, 2)"],
    );
    let quads = integers("(1, 4)", &[0, 1, 4, 3]);
    assert_error(
        &[("points", positions()), ("triangles", quads)],
        &["(F, 3) or (3 F) as `triangles`, found <i4 (1, 4)"],
    );
    let texts = npz::array("<U2", "(1,)", &[0; 8]);
    assert_error(
        &[("points", texts), ("x", positions())],
        &["or of integers, found `<U2`"],
    );
}

#[test]
fn integers_without_a_known_name_are_not_faces() {
    let names_them = ["`faces`, `edges` or `tets`", "found `edge_indices` <i4 (1, 4)"];
    let unnamed = || ("edge_indices", integers("(1, 4)", &[0, 1, 2, 3]));
    assert_error(&[("points", positions()), unnamed()], &names_them);
    let edges = || ("edges", integers("(1, 2)", &[0, 1]));
    assert_error(&[("points", positions()), unnamed(), edges()], &names_them);
    let faces = || ("faces", integers("(1, 3)", &[0, 1, 2]));
    let file = read(&[("points", positions()), unnamed(), faces()]).unwrap();
    assert_eq!(
        file.arrays.unwrap(),
        "positions from `points`, faces from `faces`, not read: `edge_indices`"
    );
    let file = read(&[("points", positions())]).unwrap();
    assert_eq!((file.contents.loose_vertices, file.contents.edges), (6, 0));
}

#[test]
fn tetrahedra_read_as_their_surface_in_every_frame() {
    // A tetrahedron of four around vertex 1, and a particle, in two frames.
    let frame = [
        [5.0, 5.0, 5.0],
        [0.1, 0.1, 0.1],
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
    ];
    let moved = frame.map(|position: [f64; 3]| position.map(|x| x + 0.5));
    let numbers: Vec<f64> = [frame, moved].as_flattened().as_flattened().to_vec();
    let corners = [1, 3, 4, 5, 2, 1, 4, 5, 2, 3, 1, 5, 2, 3, 4, 1];
    for shape in ["(4, 4)", "(16,)"] {
        let file = archive(&[
            ("particle_q", floats("(2, 6, 3)", &numbers)),
            ("tet_indices", integers(shape, &corners)),
        ]);
        let path = temporary("numpy/tetrahedra.npz", &file);
        let sequence = FrameSequence::open(path, Polygons::Refuse).unwrap();
        for (file, positions) in sequence.iter().zip([frame, moved]) {
            let file = file.unwrap();
            assert_eq!(
                (
                    file.contents.faces,
                    file.contents.solids,
                    file.contents.loose_vertices
                ),
                (4, 4, 1)
            );
            assert_eq!(file.ids.vertices, [0, 2, 3, 4, 5]);
            let kept = file.ids.vertices.iter().map(|&vertex| positions[vertex as usize]);
            assert_eq!(file.frame.positions, kept.collect::<Vec<_>>());
        }
    }
    let beyond = archive(&[
        ("points", positions()),
        ("tets", integers("(1, 4)", &[0, 1, 2, 6])),
    ]);
    let error = parse_frame(&beyond, Format::Npz).unwrap_err().to_string();
    assert!(error.starts_with("tetrahedron 0 names vertex 6"), "{error}");
}

/// A member of an archive: its name, its flags, the number of its compression, and its data as they are.
type Member<'a> = (&'a str, u16, u16, Vec<u8>);

/// An archive in the bytes that PKWARE's specification states, independent of the library.
fn zip_of(members: &[Member]) -> Vec<u8> {
    let (mut data, mut list) = (Vec::new(), Vec::new());
    for (name, flags, method, contents) in members {
        let mut crc = flate2::Crc::new();
        crc.update(contents);
        let size = contents.len() as u32;
        let short = |numbers: &[u16]| numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>();
        let long = |numbers: &[u32]| numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>();
        let common = [
            short(&[20, *flags, *method, 0, 0]),
            long(&[crc.sum(), size, size]),
            short(&[name.len() as u16, 0]),
        ]
        .concat();
        let place = [short(&[0, 0, 0, 0, 0]), long(&[data.len() as u32])].concat();
        list.extend([b"PK\x01\x02\x14\0", &common[..], &place, name.as_bytes()].concat());
        data.extend([b"PK\x03\x04", &common[..], name.as_bytes(), contents].concat());
    }
    let count = [0, 0, members.len() as u16, members.len() as u16].map(u16::to_le_bytes);
    let place = [list.len() as u32, data.len() as u32].map(u32::to_le_bytes);
    [
        &data[..],
        &list,
        b"PK\x05\x06",
        &count.concat(),
        &place.concat(),
        b"\0\0",
    ]
    .concat()
}

#[test]
fn members_that_are_not_read_may_be_of_any_kind() {
    const ENCRYPTED: u16 = 1;
    const BZIP2: u16 = 12;
    let odd = || {
        [
            ("notes.npy", 0, BZIP2, vec![1, 2, 3]),
            ("picture.png", ENCRYPTED, 0, vec![4]),
        ]
    };
    let mesh = |method| {
        [
            ("faces.npy", 0, 0, integers("(1, 3)", &[0, 1, 2])),
            ("points.npy", 0, method, positions()),
        ]
    };
    let file = MeshFile::parse(&zip_of(&[odd(), mesh(0)].concat()), Format::Npz, Polygons::Refuse);
    let file = file.unwrap();
    assert_eq!(file.frame.mesh.faces(), [[0, 1, 2]]);
    assert_eq!(
        file.arrays.unwrap(),
        "positions from `points`, faces from `faces`, not read: `notes`"
    );
    let error = parse_frame(&zip_of(&mesh(BZIP2)), Format::Npz).unwrap_err();
    assert_eq!(
        error.to_string(),
        "expected member `points.npy`, stored or compressed by deflate, found `compression method not supported: \
         12`"
    );
}

#[test]
fn a_checksum_that_is_wrong_and_a_name_that_occurs_twice_are_errors() {
    let mut file = zip_of(&[("points.npy", 0, 0, positions())]);
    let last = 30 + "points.npy".len() + positions().len() - 1;
    file[last] ^= 1;
    let error = parse_frame(&file, Format::Npz).unwrap_err().to_string();
    assert!(
        error.contains("member `points.npy`, stored or compressed by deflate, found"),
        "{error}"
    );
    let twice = zip_of(&[
        ("points.npy", 0, 0, positions()),
        ("points.npy", 0, 0, positions()),
    ]);
    let error = parse_frame(&twice, Format::Npz).unwrap_err().to_string();
    assert!(error.contains("the same name twice"), "{error}");
}
