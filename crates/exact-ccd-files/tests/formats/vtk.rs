//! VTK files, read back with a general XML reader.

use std::io::ErrorKind;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use exact_ccd_files::{Format, PointArray, UnstructuredGrid, parse_frame, write_pvd, write_vtp, write_vtu};
use exact_ccd_mesh::{Frame, Point, TetMesh};
use proptest::prelude::*;
use roxmltree::{Document, Node};

fn child<'a, 'b>(node: Node<'a, 'b>, name: &str) -> Node<'a, 'b> {
    let mut children = node.children().filter(|child| child.has_tag_name(name));
    let child = children.next().unwrap();
    assert!(children.next().is_none());
    child
}

fn root<'a>(document: &'a Document<'a>, kind: &str) -> Node<'a, 'a> {
    let root = document.root_element();
    assert!(root.has_tag_name("VTKFile"));
    let attributes =
        ["type", "version", "byte_order", "header_type"].map(|name| root.attribute(name).unwrap());
    assert_eq!(attributes, [kind, "1.0", "LittleEndian", "UInt64"]);
    root
}

/// The values of an array with this name and type, as bytes, without the header.
fn array<const N: usize>(parent: Node, name: &str, kind: &str) -> Vec<[u8; N]> {
    let is_it = |node: &Node| node.attribute("Name") == Some(name);
    let node = parent.children().find(is_it).unwrap();
    assert_eq!(
        (node.attribute("type"), node.attribute("format")),
        (Some(kind), Some("binary"))
    );
    let bytes = STANDARD.decode(node.text().unwrap()).unwrap();
    let (&length, data) = bytes.split_first_chunk().unwrap();
    assert_eq!(u64::from_le_bytes(length), data.len() as u64);
    let (values, rest) = data.as_chunks();
    assert!(rest.is_empty());
    values.to_vec()
}

/// The bits of the coordinates of a grid, and the corners and types of its cells.
fn parse(file: &[u8]) -> (Vec<u64>, Vec<Vec<i64>>, Vec<u8>) {
    let document = Document::parse(std::str::from_utf8(file).unwrap()).unwrap();
    let piece = child(
        child(root(&document, "UnstructuredGrid"), "UnstructuredGrid"),
        "Piece",
    );
    let count = |name| piece.attribute(name).unwrap().parse::<usize>().unwrap();
    let points = child(piece, "Points");
    assert_eq!(
        child(points, "DataArray").attribute("NumberOfComponents"),
        Some("3")
    );
    let coordinates: Vec<u64> = array(points, "Points", "Float64")
        .into_iter()
        .map(u64::from_le_bytes)
        .collect();
    assert_eq!(coordinates.len(), 3 * count("NumberOfPoints"));
    let cells = child(piece, "Cells");
    let integers = |name| array(cells, name, "Int64").into_iter().map(i64::from_le_bytes);
    let connectivity: Vec<i64> = integers("connectivity").collect();
    let mut start = 0;
    let corners = integers("offsets").map(|end| {
        let end = usize::try_from(end).unwrap();
        let cell = connectivity[start..end].to_vec();
        start = end;
        cell
    });
    let corners: Vec<_> = corners.collect();
    assert_eq!(
        (start, corners.len()),
        (connectivity.len(), count("NumberOfCells"))
    );
    let types = array(cells, "types", "UInt8")
        .into_iter()
        .map(u8::from_le_bytes)
        .collect();
    (coordinates, corners, types)
}

fn bits(positions: &[Point]) -> Vec<u64> {
    positions.as_flattened().iter().map(|x| x.to_bits()).collect()
}

fn wide<const N: usize>(cells: &[[u32; N]]) -> Vec<Vec<i64>> {
    cells
        .iter()
        .map(|corners| corners.map(i64::from).to_vec())
        .collect()
}

proptest! {
    #[test]
    fn a_frame_reads_back_bit_for_bit(
        positions in prop::collection::vec(prop::array::uniform3(
            any::<f64>().prop_filter("finite", |x| x.is_finite())), 0..20),
        seeds in prop::collection::vec(prop::array::uniform3(any::<u32>()), 0..20),
    ) {
        let count = positions.len() as u32;
        let seeds = seeds.into_iter().filter(|_| count > 0);
        let faces: Vec<_> = seeds.map(|face| face.map(|k| k % count)).collect();
        let frame = Frame::new(positions.clone(), faces.clone()).unwrap();
        let mut file = Vec::new();
        write_vtu(&mut file, &frame).unwrap();
        let types = vec![5; faces.len()];
        prop_assert_eq!(parse(&file), (bits(&positions), wide(&faces), types));
    }
}

#[test]
fn tetrahedra_read_back_bit_for_bit() {
    let positions = vec![
        [-0.0, 5e-324, 0.1],
        [1e300, 0.0, 0.0],
        [0.0, 1.0 / 3.0, 0.0],
        [0.0, 0.0, 1.0],
        [7.0; 3],
    ];
    let tetrahedra = vec![[0, 1, 2, 3], [3, 2, 1, 4]];
    let mesh = TetMesh::new(positions.clone(), tetrahedra.clone()).unwrap();
    let mut file = Vec::new();
    write_vtu(&mut file, &mesh).unwrap();
    assert_eq!(parse(&file), (bits(&positions), wide(&tetrahedra), vec![10, 10]));
}

/// Two tetrahedra, a separate triangle, and velocities.
const GRID: UnstructuredGrid<'_> = UnstructuredGrid {
    positions: &[
        [0.1, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 1.0, 1.0],
        [2.0, 0.0, 0.0],
        [2.0, 1.0, 0.0],
        [2.0, 0.0, 1.0],
    ],
    tetrahedra: &[[0, 1, 2, 3], [1, 2, 3, 4]],
    triangles: &[[5, 6, 7]],
    lines: &[],
    points: &[],
    ids: None,
    velocities: Some(&[[0.1, -0.0, 5e-324]; 8]),
    bodies: None,
};

#[test]
fn solids_and_shells_share_a_grid() {
    let mut file = Vec::new();
    write_vtu(&mut file, GRID).unwrap();
    let cells = [wide(GRID.tetrahedra), wide(GRID.triangles)].concat();
    assert_eq!(parse(&file), (bits(GRID.positions), cells, vec![10, 10, 5]));

    let document = Document::parse(std::str::from_utf8(&file).unwrap()).unwrap();
    let piece = child(
        child(root(&document, "UnstructuredGrid"), "UnstructuredGrid"),
        "Piece",
    );
    let data = child(piece, "PointData");
    assert_eq!(data.attribute("Vectors"), Some("velocity"));
    assert_eq!(
        child(data, "DataArray").attribute("NumberOfComponents"),
        Some("3")
    );
    let written: Vec<u64> = array(data, "velocity", "Float64")
        .into_iter()
        .map(u64::from_le_bytes)
        .collect();
    assert_eq!(written, bits(GRID.velocities.unwrap()));
}

/// Vertices and cells have the number of their body.
#[test]
fn bodies_are_data_of_points_and_cells() {
    let of_vertices = [0, 0, 0, 0, 0, 1, 1, 1];
    let grid = UnstructuredGrid {
        bodies: Some(&of_vertices),
        ..GRID
    };
    let mut file = Vec::new();
    write_vtu(&mut file, grid).unwrap();
    let document = Document::parse(std::str::from_utf8(&file).unwrap()).unwrap();
    let all = child(root(&document, "UnstructuredGrid"), "UnstructuredGrid");
    let piece = child(all, "Piece");
    let ids = |element: &str| -> Vec<i32> {
        let array = array::<4>(child(piece, element), "body", "Int32");
        array.into_iter().map(i32::from_le_bytes).collect()
    };
    assert_eq!(ids("PointData"), of_vertices.map(|body| body as i32));
    assert_eq!(ids("CellData"), [0, 0, 1]);
    // The mesh is read as without bodies.
    let mut plain = Vec::new();
    write_vtu(&mut plain, GRID).unwrap();
    assert_eq!(parse_frame(&file, Format::Vtu), parse_frame(&plain, Format::Vtu));
}

#[test]
fn invalid_grids_are_not_written() {
    for (grid, error) in [
        (
            UnstructuredGrid {
                triangles: &[[5, 6, 8]],
                ..GRID
            },
            "a cell names vertex 8, but there are only 8 vertices",
        ),
        (
            UnstructuredGrid {
                bodies: Some(&[0]),
                ..GRID
            },
            "1 bodies of vertices, expected one for each of 8 vertices",
        ),
        (
            UnstructuredGrid {
                velocities: Some(&[]),
                ..GRID
            },
            "0 velocities, expected one for each of 8 vertices",
        ),
        (
            UnstructuredGrid {
                velocities: Some(&[[f64::INFINITY; 3]; 8]),
                ..GRID
            },
            "a velocity has the component inf, expected a finite number",
        ),
    ] {
        let mut file = Vec::new();
        let found = write_vtu(&mut file, grid).unwrap_err();
        assert_eq!(
            (found.kind(), found.to_string().as_str()),
            (ErrorKind::InvalidInput, error)
        );
        assert!(file.is_empty());
    }
}

#[test]
fn positions_that_do_not_fit_are_not_written() {
    let mut frame = Frame::new(vec![[0.0; 3]; 3], vec![[0, 1, 2]]).unwrap();
    frame.positions[1][2] = f64::NAN;
    let mut file = Vec::new();
    let error = write_vtu(&mut file, &frame).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::InvalidInput);
    assert_eq!(
        error.to_string(),
        "vertex 1 has z = NaN, expected a finite number"
    );
    assert!(file.is_empty());
}

#[test]
fn a_collection_names_times_and_files() {
    let frames = [
        (0.0, "frame 0.vtu"),
        (0.1, "a/<b> & \"c\" 'd'.vtu"),
        (1e300, "line\nbreak\t\u{e9}\u{1f600}.vtu"),
        (5e-324, ""),
    ];
    let mut file = Vec::new();
    write_pvd(&mut file, frames).unwrap();
    let document = Document::parse(std::str::from_utf8(&file).unwrap()).unwrap();
    let collection = child(root(&document, "Collection"), "Collection");
    let entries = collection.children().filter(Node::is_element).map(|node| {
        assert!(node.has_tag_name("DataSet"));
        (
            node.attribute("timestep").unwrap().parse().unwrap(),
            node.attribute("file").unwrap(),
        )
    });
    assert_eq!(entries.collect::<Vec<(f64, &str)>>(), frames);
}

#[test]
fn collections_that_xml_cannot_represent_are_errors() {
    for (time, path) in [
        (f64::NAN, "0.vtu"),
        (f64::INFINITY, "0.vtu"),
        (0.0, "\0.vtu"),
        (0.0, "\u{1b}"),
    ] {
        let mut file = Vec::new();
        let error = write_pvd(&mut file, [(time, path)]).unwrap_err();
        assert_eq!(
            (error.kind(), file.as_slice()),
            (ErrorKind::InvalidInput, [].as_slice())
        );
    }
}

#[test]
fn points_keep_their_data() {
    let points = [[0.1, -0.0, 5e-324], [1.0, 2.0, f64::MAX]];
    let normals = [[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]];
    let data = [
        ("time", PointArray::Reals(&[0.25, 1.0])),
        ("normal", PointArray::Vectors(&normals)),
        ("a\"b<c", PointArray::Integers(&[-1, i64::MAX])),
    ];
    let mut file = Vec::new();
    write_vtp(&mut file, &points, &data).unwrap();
    assert_eq!(parse_frame(&file, Format::Vtp).unwrap().positions, points);
    let text = String::from_utf8(file).unwrap();
    let document = Document::parse(&text).unwrap();
    let piece = child(child(root(&document, "PolyData"), "PolyData"), "Piece");
    assert_eq!(
        (
            piece.attribute("NumberOfPoints"),
            piece.attribute("NumberOfVerts")
        ),
        (Some("2"), Some("2"))
    );
    let values = child(piece, "PointData");
    let reals = |name: &str| {
        array(values, name, "Float64")
            .into_iter()
            .map(f64::from_le_bytes)
            .collect::<Vec<_>>()
    };
    assert_eq!(reals("time"), [0.25, 1.0]);
    assert_eq!(reals("normal"), normals.as_flattened());
    let ids = array(values, "a\"b<c", "Int64")
        .into_iter()
        .map(i64::from_le_bytes);
    assert_eq!(ids.collect::<Vec<_>>(), [-1, i64::MAX]);
    let cells = child(piece, "Verts");
    let integers = |name: &str| {
        array(cells, name, "Int64")
            .into_iter()
            .map(i64::from_le_bytes)
            .collect::<Vec<_>>()
    };
    assert_eq!(
        (integers("connectivity"), integers("offsets")),
        (vec![0, 1], vec![1, 2])
    );
}

#[test]
fn points_with_other_numbers_of_values_are_refused() {
    let write = |points: &[Point], data: &[(&str, PointArray)]| {
        let error = write_vtp(std::io::sink(), points, data).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::InvalidInput);
        error.to_string()
    };
    assert_eq!(
        write(&[[0.0; 3]], &[("time", PointArray::Reals(&[]))]),
        "0 values of time, expected one for each of 1 points"
    );
    write(&[[0.0, f64::NAN, 0.0]], &[]);
    assert_eq!(
        write(&[[0.0; 3]], &[("a\0", PointArray::Reals(&[1.0]))]),
        "the name \"a\\0\" does not fit into XML"
    );
}
