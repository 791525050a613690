//! Rods and points in every format that supports them.

use exact_ccd_files::{
    Format, UnstructuredGrid, parse_frame, parse_tet_mesh, write_obj, write_ply, write_vtu,
};
use exact_ccd_mesh::{Frame, Point, TetMesh};
use proptest::prelude::*;

const POINTS: [Point; 6] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [2.0, 0.0, 0.5],
    [3.0, 0.0, 0.25],
];

fn frame(faces: &[[u32; 3]], edges: &[[u32; 2]]) -> Frame {
    Frame::with_edges(POINTS.to_vec(), faces.to_vec(), edges).unwrap()
}

/// The six vertices as statements of OBJ, on lines 1 to 6.
fn obj(statements: &str) -> String {
    let vertex = |[x, y, z]: &Point| format!("v {x} {y} {z}\n");
    POINTS.iter().map(vertex).collect::<String>() + statements
}

#[track_caller]
fn assert_error(bytes: impl AsRef<[u8]>, format: Format, message: &str) {
    let error = parse_frame(bytes.as_ref(), format).unwrap_err();
    assert_eq!(error.to_string(), message);
}

proptest! {
    #[test]
    fn frames_with_rods_read_back_bit_for_bit(
        positions in prop::collection::vec(prop::array::uniform3(
            any::<f64>().prop_filter("finite", |x| x.is_finite())), 1..12),
        faces in prop::collection::vec(prop::array::uniform3(any::<prop::sample::Index>()), 0..6),
        edges in prop::collection::vec(prop::array::uniform2(any::<prop::sample::Index>()), 0..12),
    ) {
        let index = |index: prop::sample::Index| index.index(positions.len()) as u32;
        let faces: Vec<_> = faces.into_iter().map(|face| face.map(index)).collect();
        let edges: Vec<_> = edges.into_iter().map(|edge| edge.map(index)).collect();
        let frame = Frame::with_edges(positions.clone(), faces, &edges).unwrap();
        let mut files = [(Format::Ply, Vec::new()), (Format::Obj, Vec::new()), (Format::Vtu, Vec::new())];
        write_ply(&mut files[0].1, &frame).unwrap();
        write_obj(&mut files[1].1, &frame).unwrap();
        write_vtu(&mut files[2].1, &frame).unwrap();
        for (format, bytes) in files {
            let read = parse_frame(&bytes, format).unwrap();
            prop_assert_eq!(&read, &frame);
            let bits = |frame: &Frame| {
                let coordinates = frame.positions.as_flattened().iter();
                coordinates.map(|x| x.to_bits()).collect::<Vec<_>>()
            };
            prop_assert_eq!(bits(&read), bits(&frame));
        }
    }
}

#[test]
fn obj_polylines_are_rods() {
    let statements = "f 1 2 3\nl 1 2\nl 3/1 4/2 \\\n -2\nl 5 6 5\np 1 -1\n";
    let read = parse_frame(obj(statements).as_bytes(), Format::Obj).unwrap();
    assert_eq!(read, frame(&[[0, 1, 2]], &[[2, 3], [3, 4], [4, 5]]));
    // A polyline may come before its vertices.
    let early = parse_frame(b"l 1 2\nv 0 0 0\nv 1 0 0\n", Format::Obj).unwrap();
    assert_eq!(early.mesh.loose_edges(), [[0, 1]]);
}

#[test]
fn obj_errors_name_the_line_and_the_element() {
    for (statements, message) in [
        (
            "l 1 2\nl 3\n",
            "line 8: expected at least two vertices of a polyline, found 1",
        ),
        (
            "l\n",
            "line 7: expected at least two vertices of a polyline, found 0",
        ),
        (
            "l 1 2\nl 1 7 2\n",
            "line 8: polyline 2 names vertex 7, but there are 6 vertices, counted from 1",
        ),
        (
            "l 1 -7\n",
            "line 7: polyline 1 names vertex -7, but there are 6 vertices, counted from 1",
        ),
        (
            "l 1 b\n",
            "line 7: expected a corner such as 1, 1/2, 1/2/3 or 1//3, found `b`",
        ),
        (
            "\np 0\n",
            "line 8: point 1 names vertex 0, but there are 6 vertices, counted from 1",
        ),
    ] {
        assert_error(obj(statements), Format::Obj, message);
    }
}

/// A PLY file as text: the six vertices, elements, and their rows, which begin on line 16 for one
/// edge element.
fn ply(elements: &str, rows: &str) -> String {
    let vertex = |[x, y, z]: &Point| format!("{x} {y} {z}\n");
    let vertices: String = POINTS.iter().map(vertex).collect();
    format!(
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty double z\n\
         {elements}end_header\n{vertices}{rows}"
    )
}

const EDGES: &str = "element edge 2\nproperty int vertex1\nproperty int vertex2\n";

#[test]
fn ply_edges_are_rods() {
    let faces = "element face 1\nproperty list uchar int vertex_indices\n";
    let read = |elements: &str, rows: &str| {
        let file = ply(elements, rows);
        parse_frame(file.as_bytes(), Format::Ply).unwrap()
    };
    let both = format!("{faces}{EDGES}");
    assert_eq!(read(&both, "3 0 1 2\n1 2\n4 3\n"), frame(&[[0, 1, 2]], &[[3, 4]]));
    let coloured = "element edge 1\nproperty uchar red\nproperty uint vertex2\nproperty ushort vertex1\n";
    assert_eq!(read(coloured, "255 5 4\n"), frame(&[], &[[4, 5]]));
    // Without faces, a file is one of rods.
    assert_eq!(read(EDGES, "0 5\n2 0\n"), frame(&[], &[[0, 2], [0, 5]]));
}

#[test]
fn ply_errors_name_the_line_and_the_edge() {
    assert_error(
        ply(EDGES, "0 1\n1 6\n"),
        Format::Ply,
        "line 18: edge 1 names vertex 6, but there are 6 vertices, counted from 0",
    );
    assert_error(
        ply(EDGES, "0 1\n-1 2\n"),
        Format::Ply,
        "line 18: edge 1 names vertex -1, but there are 6 vertices, counted from 0",
    );
    assert_error(
        ply(EDGES, "0 1\n1\n"),
        Format::Ply,
        "line 18: expected an integer, found the end of the line",
    );
    assert_error(
        ply(EDGES, "0 1\n"),
        Format::Ply,
        "line 18: the file ends, expected element `edge`, row 1 of 2",
    );
    assert_error(
        ply("element edge 0\nproperty int vertex1\n", ""),
        Format::Ply,
        "line 9: expected an element `face` in the header, found none; export the mesh with its vertices and faces",
    );
}

/// A grid as text, with cells from line 4 on.
pub(crate) fn vtu(points: &[Point], connectivity: &str, offsets: &str, types: &str) -> String {
    let array = |name: &str, text: &str| {
        format!("<DataArray type='Int64' Name='{name}' format='ascii'>{text}</DataArray>\n")
    };
    let coordinates: String = points.as_flattened().iter().map(|x| format!("{x} ")).collect();
    format!(
        "<VTKFile type='UnstructuredGrid' byte_order='LittleEndian'><UnstructuredGrid><Piece>\n<Points>\n\
         <DataArray type='Float64' format='ascii'>{coordinates}</DataArray></Points>\n<Cells>\n\
          {}{}{}</Cells>\n\
         </Piece></UnstructuredGrid></VTKFile>",
        array("connectivity", connectivity),
        array("offsets", offsets),
        array("types", types),
    )
}

#[test]
fn vtk_lines_and_polylines_are_rods() {
    let read = |file: String| parse_frame(file.as_bytes(), Format::Vtu).unwrap();
    assert_eq!(
        read(vtu(&POINTS, "0 1 2 1 0 3 2 3 4 5", "3 5 9 10", "5 3 4 1")),
        frame(&[[0, 1, 2]], &[[3, 2], [3, 4]])
    );
    // Beside tetrahedra: an edge of one is not loose, and a vertex stays if it is in a line or
    // listed as a point.
    let beside = read(vtu(&POINTS, "0 1 2 3 0 3 3 4 5 0 5", "4 6 8 11", "10 3 3 2"));
    let tetrahedron = TetMesh::new(POINTS.to_vec(), vec![[0, 1, 2, 3]]).unwrap();
    assert_eq!(beside, frame(tetrahedron.surface(), &[[3, 4]]));
    assert_eq!(beside.mesh.loose_vertices().collect::<Vec<_>>(), [5]);
}

#[test]
fn vtk_errors_name_the_cell() {
    for (connectivity, offsets, types, found) in [
        ("0 1 2", "3", "3", "cell 0 of type 3 with 3 corners"),
        ("0 1 2", "2 3", "3 4", "cell 1 of type 4 with 1 corners"),
        ("0 1", "2", "1", "cell 0 of type 1 with 2 corners"),
    ] {
        assert_error(
            vtu(&POINTS, connectivity, offsets, types),
            Format::Vtu,
            &format!("line 4: expected a linear cell (types 1 to 14), found {found}"),
        );
    }
    assert_error(
        vtu(&POINTS, "0 6", "2", "3"),
        Format::Vtu,
        "line 4: expected corners of cell 0 among the 6 points, found `[0, 6]`",
    );
}

#[test]
fn grids_of_all_cells_read_back() {
    let grid = UnstructuredGrid {
        positions: &POINTS,
        tetrahedra: &[[0, 1, 2, 3]],
        triangles: &[[2, 3, 4]],
        lines: &[[1, 4], [0, 1]],
        points: &[5, 0],
        velocities: None,
        bodies: None,
        ids: None,
    };
    let mut file = Vec::new();
    write_vtu(&mut file, grid).unwrap();
    let read = parse_frame(&file, Format::Vtu).unwrap();
    let surface = TetMesh::new(POINTS.to_vec(), vec![[0, 1, 2, 3]]).unwrap();
    let faces = [surface.surface(), &[[2, 3, 4]]].concat();
    assert_eq!(read, frame(&faces, &[[1, 4]]));
    for (lines, points) in [(&[[0, 6]][..], &[][..]), (&[], &[6])] {
        let grid = UnstructuredGrid {
            lines,
            points,
            ..grid
        };
        let error = write_vtu(&mut Vec::new(), grid).unwrap_err();
        assert_eq!(
            error.to_string(),
            "a cell names vertex 6, but there are only 6 vertices"
        );
    }
}

/// A Gmsh file of version 2.2 with these elements, whose nodes are the six vertices, from 1.
fn msh(elements: &[&str]) -> String {
    let node = |(number, [x, y, z]): (usize, &Point)| format!("{} {x} {y} {z}\n", number + 1);
    let nodes: String = POINTS.iter().enumerate().map(node).collect();
    let elements_text: String = (1..)
        .zip(elements)
        .map(|(tag, element)| format!("{tag} {element}\n"))
        .collect();
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n{nodes}$EndNodes\n\
         $Elements\n{}\n{elements_text}$EndElements\n",
        elements.len()
    )
}

#[test]
fn gmsh_lines_are_rods_unless_they_are_edges() {
    let read = |elements: &[&str]| parse_frame(msh(elements).as_bytes(), Format::Msh).unwrap();
    // A line along the boundary of a surface is not a rod.
    assert_eq!(
        read(&["15 0 1", "1 0 1 2", "1 2 7 7 4 5", "2 0 1 2 3"]),
        frame(&[[0, 1, 2]], &[[3, 4]])
    );
    assert_eq!(read(&["1 0 6 1", "1 0 2 1"]), frame(&[], &[[0, 1], [0, 5]]));
    // Beside tetrahedra. Points belong to the geometry: vertex 5 is not there.
    let elements = ["15 0 6", "1 0 1 2", "1 0 4 5", "4 0 1 2 3 4"];
    let tetrahedron = TetMesh::new(POINTS.to_vec(), vec![[0, 1, 2, 3]]).unwrap();
    let expected = Frame::with_edges(POINTS[..5].to_vec(), tetrahedron.surface().to_vec(), &[[3, 4]]);
    assert_eq!(read(&elements), expected.unwrap());
    assert_eq!(parse_tet_mesh(msh(&elements).as_bytes()).unwrap().0, tetrahedron);
}

#[test]
fn gmsh_errors_name_the_line() {
    assert_error(
        msh(&["1 0 1 2", "1 0 1 7"]),
        Format::Msh,
        "line 16: expected the tag of one of the 6 nodes, found `7`",
    );
    assert_error(
        msh(&["1 0 1"]),
        Format::Msh,
        "line 15: expected the tag of a node, found the end of the line",
    );
}

#[test]
fn an_obj_file_without_vertices_is_not_written() {
    let empty = Frame::new(vec![], vec![]).unwrap();
    let error = write_obj(&mut Vec::new(), &empty).unwrap_err();
    assert_eq!(error.to_string(), "no vertices, expected at least one");
}
