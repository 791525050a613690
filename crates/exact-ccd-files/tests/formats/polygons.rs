//! Faces with more than three corners, and cells with volume: the same triangles in every format.

use exact_ccd_files::{Format, MeshFile, Polygons, parse_frame, parse_tet_mesh};

/// A square and a pentagon, with corner k of each first, in every text format.
fn files(k: usize) -> Vec<(Format, String)> {
    let turned = |corners: &[u32], from: u32| {
        let mut corners = corners.to_vec();
        let by = k % corners.len();
        corners.rotate_left(by);
        let words: Vec<String> = corners.iter().map(|corner| (corner + from).to_string()).collect();
        words.join(" ")
    };
    let quad = |from| turned(&[3, 1, 0, 2], from);
    let pentagon = |from| turned(&[6, 4, 2, 3, 5], from);
    let points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n0.5 3 0\n";
    let numbered = |tag: &str| {
        let lines = points.lines().enumerate();
        lines
            .map(|(k, line)| format!("{} {line}\n", tag.replace('#', &(k + 1).to_string())))
            .collect::<String>()
    };
    let (q, p) = (quad(0), pentagon(0));
    let array = |name: &str, numbers: &str| {
        format!("<DataArray type='Int64' Name='{name}' format='ascii'>{numbers}</DataArray>")
    };
    let vtk_points =
        format!("<Points><DataArray type='Float32' format='ascii'>{points}</DataArray></Points>");
    let lists = array("connectivity", &format!("{q} {p}")) + &array("offsets", "4 9");
    let xml = |kind: &str, cells: String| {
        format!(
            "<VTKFile type='{kind}' byte_order='LittleEndian'><{kind}><Piece>{vtk_points}{cells}</Piece></{kind}>\
             </VTKFile>"
        )
    };
    vec![
        (
            Format::Obj,
            format!("{}f {}\nf {}\n", numbered("v"), quad(1), pentagon(1)),
        ),
        (Format::Off, format!("OFF\n7 2 0\n{points}4 {q}\n5 {p}\n")),
        (
            Format::Ply,
            format!(
                "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\nproperty float z\n\
                 element face 2\nproperty list uchar int vertex_index\nend_header\n{points}4 {q}\n5 {p}\n"
            ),
        ),
        (
            Format::Vtu,
            xml(
                "UnstructuredGrid",
                format!("<Cells>{lists}{}</Cells>", array("types", "9 7")),
            ),
        ),
        (Format::Vtp, xml("PolyData", format!("<Polys>{lists}</Polys>"))),
        (
            Format::Vtk,
            format!(
                "# vtk DataFile Version 2.0\n\nASCII\nDATASET POLYDATA\nPOINTS 7 float\n{points}\
                 POLYGONS 2 11\n4 {q}\n5 {p}\n"
            ),
        ),
    ]
}

#[test]
fn fans_begin_at_the_lowest_vertex_whichever_corner_is_first() {
    for k in 0..5 {
        for (format, file) in files(k) {
            let file = MeshFile::parse(file.as_bytes(), format, Polygons::Triangulate).unwrap();
            assert_eq!(
                file.frame.mesh.faces(),
                [[0, 2, 3], [0, 3, 1], [2, 3, 5], [2, 5, 6], [2, 6, 4]],
                "{format:?}"
            );
            assert_eq!(
                file.contents.to_string(),
                "7 vertices, 11 edges, 5 faces, 1 component; 2 polygons triangulated, each as a fan from its \
                 lowest vertex"
            );
        }
    }
}

#[test]
fn polygons_can_be_refused() {
    for (format, file) in files(0) {
        let error = MeshFile::parse(file.as_bytes(), format, Polygons::Refuse).unwrap_err();
        let error = error.to_string();
        // OBJ counts from 1.
        let face = u8::from(format == Format::Obj);
        let expected = format!("face {face} has 4 corners, but only triangles are allowed");
        assert!(error.ends_with(&expected), "{error}");
    }
}

/// Gmsh elements over 12 nodes, three layers of a square.
fn msh(elements: &[&str]) -> String {
    let mut nodes = String::new();
    for node in 0..12 {
        nodes += &format!("{} {} {} {}\n", node + 1, node % 2, node / 2 % 2, node / 4);
    }
    let lines = elements.iter().enumerate();
    let lines: String = lines
        .map(|(k, element)| format!("{} {element}\n", k + 1))
        .collect();
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n12\n{nodes}$EndNodes\n$Elements\n{}\n{lines}$EndElements\n",
        elements.len()
    )
}

const LOWER: &str = "5 0 1 2 4 3 5 6 8 7";
const UPPER: &str = "5 0 5 6 8 7 9 10 12 11";

#[test]
fn hexahedra_read_as_the_sides_that_occur_once() {
    // The quadrilateral on the boundary is one of the sides; the line is an edge of a cell.
    let file = msh(&[LOWER, UPPER, "3 0 1 2 4 3", "1 0 1 5", "15 0 3"]);
    let file = MeshFile::parse(file.as_bytes(), Format::Msh, Polygons::Triangulate).unwrap();
    assert_eq!(file.frame.mesh.faces().len(), 20);
    assert_eq!(file.frame.positions.len(), 12);
    assert_eq!(
        file.contents.to_string(),
        "12 vertices, 30 edges, 20 faces, 1 component; the surface of 2 cells with volume; 10 polygons \
         triangulated, each as a fan from its lowest vertex"
    );
    let error = parse_tet_mesh(msh(&[LOWER]).as_bytes()).unwrap_err().to_string();
    assert_eq!(
        error,
        "expected no cells with volume but tetrahedra, found hexahedra, wedges or pyramids"
    );
}

#[test]
fn cells_of_all_kinds_share_sides() {
    // The lower hexahedron, and above it a wedge, or a pyramid and two tetrahedra.
    let wedges = ["6 0 5 7 9 6 8 10"];
    let others = ["7 0 5 6 8 7 9", "4 0 6 8 9 10", "4 0 8 7 9 12"];
    for upper in [&wedges[..], &others[..]] {
        let file = msh(&[&[LOWER], upper].concat());
        let frame = parse_frame(file.as_bytes(), Format::Msh).unwrap();
        // A closed surface: each edge belongs to two faces.
        let faces = frame.mesh.faces().len();
        assert_eq!(frame.mesh.edges().len() * 2, faces * 3, "{upper:?}");
        // The side between the cells is not on the surface.
        let inside = |face: &&[u32; 3]| {
            face.iter()
                .all(|&vertex| frame.positions[vertex as usize][2] == 1.0)
        };
        assert_eq!(frame.mesh.faces().iter().find(inside), None, "{upper:?}");
    }
}

#[test]
fn cells_that_share_a_side_with_two_others_are_errors() {
    let error = parse_frame(msh(&[LOWER, UPPER, UPPER]).as_bytes(), Format::Msh);
    assert_eq!(
        error.unwrap_err().to_string(),
        "cells 0, 1 and 2 share one side, expected at most two"
    );
    let sheet = parse_frame(msh(&[LOWER, "3 0 9 10 12 11"]).as_bytes(), Format::Msh);
    assert!(sheet.unwrap_err().to_string().starts_with("face 0 is no side"));
}
