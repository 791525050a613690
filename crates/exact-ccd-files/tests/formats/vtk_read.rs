//! VTK files of other programs, and invalid files.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use exact_ccd_files::{Format, MeshFile, Polygons, UnstructuredGrid, parse_frame, read_pvd, write_vtu};
use exact_ccd_mesh::{Frame, TetMesh};
use proptest::prelude::*;

use crate::loose::vtu;

const TRIANGLE: [[f64; 3]; 3] = [[0.0, 0.5, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.25]];

fn sample() -> String {
    let mut file = Vec::new();
    let frame = Frame::new(TRIANGLE.to_vec(), vec![[2, 0, 1]]).unwrap();
    write_vtu(&mut file, &frame).unwrap();
    String::from_utf8(file).unwrap()
}

#[track_caller]
fn assert_error(file: impl AsRef<[u8]>, message: &str) {
    assert_eq!(
        parse_frame(file.as_ref(), Format::Vtu).unwrap_err().to_string(),
        message
    );
}

#[test]
fn big_endian_with_short_headers_and_numbers() {
    let array = |data: Vec<[u8; 4]>| {
        let data = data.concat();
        STANDARD.encode([&(data.len() as u32).to_be_bytes(), data.as_slice()].concat())
    };
    let coordinates = TRIANGLE
        .as_flattened()
        .iter()
        .map(|&x| (x as f32).to_be_bytes())
        .collect();
    let integers = |integers: &[i32]| array(integers.iter().map(|i| i.to_be_bytes()).collect());
    let file = format!(
        "<VTKFile type=\"UnstructuredGrid\" byte_order=\"BigEndian\"><UnstructuredGrid><Piece>\
         <Points><DataArray type=\"Float32\" format=\"binary\">\n  {}\n</DataArray></Points><Cells>\
         <DataArray type=\"Int32\" Name=\"connectivity\" format=\"binary\">{}</DataArray>\
         <DataArray type=\"Int32\" Name=\"offsets\" format=\"binary\">{}</DataArray>\
         <DataArray type=\"UInt8\" Name=\"types\" format=\"binary\">{}</DataArray>\
         </Cells></Piece></UnstructuredGrid></VTKFile>",
        array(coordinates),
        integers(&[2, 0, 1]),
        integers(&[3]),
        STANDARD.encode([0, 0, 0, 1, 5]),
    );
    let frame = parse_frame(file.as_bytes(), Format::Vtu).unwrap();
    assert_eq!(frame, Frame::new(TRIANGLE.to_vec(), vec![[2, 0, 1]]).unwrap());
}

#[test]
fn tetrahedra_read_as_their_surface() {
    let positions = [TRIANGLE.as_slice(), &[[5.0; 3], [9.0; 3]]].concat();
    let mesh = TetMesh::new(positions, vec![[0, 2, 1, 4]]).unwrap();
    let mut file = Vec::new();
    write_vtu(&mut file, &mesh).unwrap();
    assert_eq!(parse_frame(&file, Format::Vtu).unwrap(), mesh.surface_frame().0);
}

#[test]
fn the_surface_does_not_depend_on_positions() {
    // An octahedron of eight tetrahedra around vertex 0, which may lie outside the octahedron.
    let sphere = |z: f64| -> Vec<[f64; 3]> {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let around = axes.into_iter().chain(axes.map(|axis| axis.map(|x: f64| -x)));
        [[0.0, 0.0, z]].into_iter().chain(around).collect()
    };
    let quarters = [[1, 2], [2, 4], [4, 5], [5, 1]];
    let tetrahedra = quarters.map(|[a, b]| [[0, a, b, 3], [0, b, a, 6]]).concat();
    let frame = |z: f64| {
        let grid = UnstructuredGrid {
            positions: &sphere(z),
            tetrahedra: &tetrahedra,
            ..UnstructuredGrid::default()
        };
        let mut file = Vec::new();
        write_vtu(&mut file, grid).unwrap();
        parse_frame(&file, Format::Vtu).unwrap()
    };
    let round = TetMesh::new(sphere(0.0), tetrahedra.clone()).unwrap();
    assert_eq!(frame(0.0), round.surface_frame().0);
    // Vertex 0 at a corner: four tetrahedra have no volume. Outside: some are inside out.
    for z in [1.0, 3.0, -8.0] {
        assert_eq!(frame(z), frame(0.0));
    }
}

#[test]
fn shells_are_kept_beside_the_surface_of_solids() {
    // A tetrahedron, one of its faces, a shell that shares its corner 3, and the unused vertices 4
    // and 8.
    let positions: Vec<[f64; 3]> = (0..9)
        .map(|i| [i, i * i % 5, i * i * i % 7].map(f64::from))
        .collect();
    let grid = UnstructuredGrid {
        positions: &positions,
        tetrahedra: &[[0, 1, 2, 3]],
        triangles: &[[2, 0, 1], [3, 5, 6], [5, 7, 6]],
        velocities: Some(&positions),
        ..UnstructuredGrid::default()
    };
    let mut file = Vec::new();
    write_vtu(&mut file, grid).unwrap();
    let frame = parse_frame(&file, Format::Vtu).unwrap();
    assert_eq!(frame.positions, [&positions[..4], &positions[5..8]].concat());
    let surface = TetMesh::new(positions.clone(), vec![[0, 1, 2, 3]]).unwrap();
    assert_eq!(
        frame.mesh.faces(),
        [surface.surface(), &[[3, 4, 5], [4, 6, 5]]].concat()
    );
}

#[test]
fn each_error_names_its_line() {
    let sample = sample();
    let changed = |from: &str, to: &str| {
        assert!(sample.contains(from));
        sample.replacen(from, to, 1)
    };
    assert_error(b"<VTKFile>\xff", "byte 9: expected UTF-8, found other bytes");
    assert!(
        parse_frame(b"<a>\n<b>\n</a>", Format::Vtu)
            .unwrap_err()
            .to_string()
            .starts_with("line 3: expected XML, ")
    );
    assert_error("<a/>", "line 1: expected `VTKFile`, found `a`");
    for (from, to, message) in [
        (
            "type=\"UnstructuredGrid\"",
            "type=\"PolyData\"",
            "the contents are VTK PolyData, expected VTK UnstructuredGrid; rename the file to end in .vtp",
        ),
        (
            "byte_order=\"LittleEndian\" ",
            "",
            "line 2: expected an attribute `byte_order`, found none",
        ),
        (
            "LittleEndian\"",
            "Little\"",
            "line 2: expected `LittleEndian` or `BigEndian`, found `Little`",
        ),
        (
            "LittleEndian\"",
            "LittleEndian\" compressor=\"zlib\"",
            "line 2: expected data compressed by zlib, by LZ4 or not, found `zlib`",
        ),
        (
            "\"UInt64\"",
            "\"UInt16\"",
            "line 2: expected `UInt32` or `UInt64`, found `UInt16`",
        ),
        (
            "\"UInt64\"",
            "\"UInt32\"",
            "line 6: expected 72 bytes, as the array begins with, found more",
        ),
        (
            "<Points>",
            "<Points><DataArray/>",
            "line 5: expected one element `DataArray`, found 2",
        ),
        (
            "NumberOfPoints=\"3\"",
            "NumberOfPoints=\"4\"",
            "line 4: expected as many elements as `NumberOfPoints` says, `4`, found 3",
        ),
        (
            "NumberOfCells=\"1\"",
            "NumberOfCells=\"2\"",
            "line 4: expected as many elements as `NumberOfCells` says, `2`, found 1",
        ),
        (
            "NumberOfComponents=\"3\"",
            "NumberOfComponents=\"2\"",
            "line 6: expected three components of each point, found `2`",
        ),
        (
            "\"Float64\"",
            "\"String\"",
            "line 6: expected `Float32`, `Float64` or a type of integers, found `String`",
        ),
        (
            "\"binary\"",
            "\"appended\"",
            "line 6: expected an attribute `offset`, found none",
        ),
        ("\"binary\"", "\"ascii\"", ""),
        (
            "\"offsets\"",
            "\"ends\"",
            "line 8: expected an array `offsets`, found none",
        ),
        (
            "\"Int64\"",
            "\"Float64\"",
            "line 9: expected `Int8` to `UInt64`, found `Float64`",
        ),
    ] {
        let file = changed(from, to);
        if message.is_empty() {
            let error = parse_frame(file.as_bytes(), Format::Vtu).unwrap_err().to_string();
            assert!(error.starts_with("line 6: expected a number, found `"), "{error}");
        } else {
            assert_error(file, message);
        }
    }
}

/// A grid of three points, as text.
fn cells(connectivity: &str, offsets: &str, types: &str) -> String {
    let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    vtu(&points, connectivity, offsets, types)
}

#[test]
fn invalid_cells_are_errors() {
    let sound = parse_frame(cells("0 1 2", "3", "5").as_bytes(), Format::Vtu).unwrap();
    assert_eq!(sound.mesh.faces(), [[0, 1, 2]]);
    for (connectivity, offsets, types, message) in [
        (
            "0 1 2",
            "3",
            "5 5",
            "as many offsets as types, found 1 offsets and 2 types",
        ),
        ("0 1 2", "4", "5", "the end of cell 0, found offset 4"),
        ("0 1 2", "-1", "5", "the end of cell 0, found offset -1"),
        ("0 1 2", "3 2", "5 5", "the end of cell 1, found offset 2"),
        (
            "0 1 2",
            "3 9223372036854775807",
            "5 5",
            "the end of cell 1, found offset 9223372036854775807",
        ),
        (
            "0 1 3",
            "3",
            "5",
            "corners of cell 0 among the 3 points, found `[0, 1, 3]`",
        ),
        (
            "0 1 -1",
            "3",
            "5",
            "corners of cell 0 among the 3 points, found `[0, 1, -1]`",
        ),
        (
            "0 1 2",
            "3",
            "9",
            "a linear cell (types 1 to 14), found cell 0 of type 9 with 3 corners",
        ),
        (
            "0 1",
            "2",
            "5",
            "a linear cell (types 1 to 14), found cell 0 of type 5 with 2 corners",
        ),
        ("0 1 2 0", "3", "5", "3 corners, found 4"),
    ] {
        assert_error(
            cells(connectivity, offsets, types),
            &format!("line 4: expected {message}"),
        );
    }
    assert_error(cells("0 1 2 2", "4", "10"), "tetrahedron 0 has no volume");
}

/// A surface whose numbers are interrupted by a comment, with as many faces as its list has.
#[test]
fn comments_do_not_end_an_array() {
    let file = |count: usize| {
        format!(
            "<VTKFile type='PolyData' byte_order='LittleEndian'><PolyData>\n\
             <Piece NumberOfPoints='4' NumberOfPolys='{count}'>\n<Points>\n\
             <DataArray type='Float64' format='ascii'>0 0 0 1 0 0 0 1 0 <!-- one more --> 1 1 1</DataArray></Points>\n\
             <Polys><DataArray type='Int64' Name='connectivity' format='ascii'>0 1 2 <!-- --> 1 2 3</DataArray>\n\
             <DataArray type='Int64' Name='offsets' format='ascii'>3 <!-- --> 6</DataArray></Polys>\n\
             </Piece></PolyData></VTKFile>"
        )
    };
    let frame = parse_frame(file(2).as_bytes(), Format::Vtp).unwrap();
    assert_eq!(
        (frame.positions.len(), frame.mesh.faces()),
        (4, &[[0, 1, 2], [1, 2, 3]][..])
    );
    let error = parse_frame(file(3).as_bytes(), Format::Vtp).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 2: expected as many elements as `NumberOfPolys` says, `3`, found 2"
    );
}

#[test]
fn sides_of_cells_that_are_listed_as_faces_are_counted_once() {
    let file = "<VTKFile type='UnstructuredGrid' byte_order='LittleEndian'><UnstructuredGrid><Piece><Points>\n\
                <DataArray type='Float64' format='ascii'>9 9 9 0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 \n\
                5 0 0 6 0 0 6 1 0 5 1 0 7 7 7</DataArray></Points>\n<Cells>\n\
                <DataArray type='Int64' Name='connectivity' format='ascii'>1 2 3 4 9 10 11 12 9 10 11 \n\
                1 2 3 4 5 6 7 8 5 6 7 8</DataArray>\n\
                <DataArray type='Int64' Name='offsets' format='ascii'>4 8 11 19 23</DataArray>\n\
                <DataArray type='UInt8' Name='types' format='ascii'>9 9 5 12 9</DataArray></Cells></Piece>\n\
                </UnstructuredGrid></VTKFile>";
    let file = MeshFile::parse(file.as_bytes(), Format::Vtu, Polygons::Triangulate).unwrap();
    // Six sides, and one of three quadrilaterals of the file.
    assert_eq!((file.contents.polygons, file.contents.faces), (7, 15));
    assert_eq!(file.ids.vertices, (1..=12).collect::<Vec<_>>());
    assert_eq!(file.ids.faces[..12], [None; 12]);
    assert_eq!(file.ids.faces[12..], [Some(1), Some(1), Some(2)]);
    assert_eq!((file.ids.vertex_count, file.ids.face_count), (14, 4));
}

#[test]
fn deep_nesting_is_an_error() {
    let deep = "<a>".repeat(200_000);
    assert!(parse_frame(deep.as_bytes(), Format::Vtu).is_err());
    let closed = deep + &"</a>".repeat(200_000);
    assert!(parse_frame(closed.as_bytes(), Format::Vtu).is_err());
}

#[test]
fn a_collection_that_is_missing_is_an_error() {
    let error = read_pvd("no/such/file.pvd").unwrap_err().to_string();
    assert!(error.starts_with("no/such/file.pvd: "), "{error}");
}

proptest! {
    #[test]
    fn any_change_is_an_error_or_valid(
        at in any::<prop::sample::Index>(),
        removed in 0..30_usize,
        inserted in prop::sample::select(
            vec!["", "<", ">", "\"", "&amp;", "AAAA", "=", "1", "-", "<a>", "\0", "\u{e9}"]),
    ) {
        for sample in [sample(), cells("0 1 2", "3", "5")] {
            let mut bytes = sample.into_bytes();
            let at = at.index(bytes.len());
            let end = bytes.len().min(at + removed);
            bytes.splice(at..end, inserted.bytes());
            match parse_frame(&bytes, Format::Vtu) {
                Ok(frame) => prop_assert!(Frame::new(frame.positions, frame.mesh.faces().to_vec()).is_ok()),
                Err(error) => prop_assert!(!error.to_string().chars().any(char::is_control)),
            }
        }
    }
}
