//! Legacy VTK files: all types of cells, the versions of lists, and errors.

use exact_ccd_files::{Format, parse_frame};

const HEAD: &str = "# vtk DataFile Version 3.0\na title\nASCII\n";
const POINTS: &str = "POINTS 6 float\n0 0 0  1 0 0  0 1 0  1 1 0\n0 2 0 1 2 0\n";

fn grid(cells: &str, types: &str) -> String {
    let size = cells.split_whitespace().count();
    let count = types.split_whitespace().count();
    format!(
        "{HEAD}DATASET UNSTRUCTURED_GRID\n{POINTS}CELLS {count} {size}\n{cells}\nCELL_TYPES {count}\n{types}\n"
    )
}

#[test]
fn strips_pixels_lines_and_points_are_read() {
    let file = grid("6 0 1 2 3 4 5  4 0 1 2 3  3 4 5 0  1 5  0", "6 8 4 2 0");
    let frame = parse_frame(file.as_bytes(), Format::Vtk).unwrap();
    assert_eq!(
        frame.mesh.faces(),
        [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4], [0, 1, 3], [0, 3, 2]]
    );
    assert_eq!(frame.mesh.loose_edges(), [[0, 5]]);
}

#[test]
fn a_voxel_is_a_hexahedron_with_its_corners_by_coordinates() {
    let mut points = String::new();
    for corner in 0..8 {
        points += &format!("{} {} {}\n", corner % 2, corner / 2 % 2, corner / 4);
    }
    let file = format!(
        "{HEAD}DATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n{points}CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n11\n"
    );
    let frame = parse_frame(file.as_bytes(), Format::Vtk).unwrap();
    assert_eq!((frame.mesh.faces().len(), frame.mesh.edges().len()), (12, 18));
    // Every face lies in a side of the unit cube.
    for face in frame.mesh.faces() {
        let in_side = |axis: usize| {
            let [a, b, c] = face.map(|vertex| frame.positions[vertex as usize][axis]);
            a == b && b == c
        };
        assert!((0..3).any(in_side), "{face:?}");
    }
}

#[test]
fn sections_may_come_in_any_order_and_be_absent() {
    let file = format!(
        "{HEAD}DATASET polydata\npolygons 1 4\n3 0 1 2\n{POINTS}METADATA\nINFORMATION 1\nNAME x LOCATION y\n\n\
         VERTICES 2 4\n1 0 1 5\nCELL_DATA 3\nanything else"
    );
    let frame = parse_frame(file.as_bytes(), Format::Vtk).unwrap();
    assert_eq!(frame.mesh.faces(), [[0, 1, 2]]);
}

#[test]
fn each_error_names_its_line() {
    for (file, message) in [
        (
            "# vtk DataFile Version 6.0\n".to_owned(),
            "line 1: expected `# vtk DataFile Version` 1 to 5.1, found `# vtk DataFile Version 6.0`",
        ),
        (
            HEAD.replace("ASCII", "TEXT"),
            "line 3: expected `ASCII` or `BINARY`, found `TEXT`",
        ),
        (
            format!("{HEAD}DATASET STRUCTURED_GRID\n"),
            "line 4: expected `UNSTRUCTURED_GRID` or `POLYDATA` (in pyvista: extract_surface()), found \
             `STRUCTURED_GRID`",
        ),
        (
            grid("3 0 1 2", "5").replace("0 2 0", "0 two 0"),
            "line 7: expected a number, found `two`",
        ),
        (
            grid("3 0 1 6", "5"),
            "line 8: expected corners of cell 0 among the 6 points, found `[0, 1, 6]`",
        ),
        (grid("3 0 1", "5"), "line 8: the file ends, expected cell 0 of 1"),
        (
            grid("3 0 1 2 3", "5"),
            "line 8: expected 4 integers for 1 cells, found 5",
        ),
        (
            grid("4 0 1 2 3", "24"),
            "line 8: expected a linear cell (types 1 to 14), found cell 0 of type 24 (a quadratic cell; in \
             ParaView: Tessellate, in pyvista: linear_copy()) with 4 \
             corners",
        ),
        (
            grid("3 0 1 2", "5").replace("CELL_TYPES 1\n5\n", ""),
            "line 10: the file ends, expected `CELL_TYPES`",
        ),
        (
            grid("3 0 1 2", "5").replace("CELL_TYPES 1", "CELL_TYPES 99999999999"),
            "line 12: the file ends, expected an integer",
        ),
        (
            grid("3 0 1 2", "5").replace("6 float", "6 string"),
            "line 5: expected a type of numbers such as `float` or `vtktypeint64`, found `string`",
        ),
        (
            format!("{HEAD}DATASET POLYDATA\n{POINTS}POLYGONS 2 3\nOFFSETS Double\n0 3\n"),
            "line 9: expected a type of integers such as `vtktypeint64`, found `Double`",
        ),
    ] {
        let error = parse_frame(file.as_bytes(), Format::Vtk).unwrap_err().to_string();
        assert_eq!(error, message, "{file}");
    }
}

/// Arrays of texts, as pyvista writes them, are skipped. Their lengths have 1, 2, 4 or 8 bytes.
#[test]
fn texts_in_fields_are_skipped() {
    let text = |length: usize, header: &[u8]| [header, "x".repeat(length).as_bytes()].concat();
    let texts = [
        text(0, &[0xc0]),
        text(63, &[0xff]),
        text(129, &[0x80, 0x81]),
        text(70_000, &[0x40, 0x01, 0x11, 0x70]),
        text(3, &[0, 0, 0, 0, 0, 0, 0, 3]),
    ]
    .concat();
    let triangle: Vec<u8> = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]
        .into_iter()
        .flat_map(f32::to_be_bytes)
        .collect();
    let corners: Vec<u8> = [3_i32, 0, 1, 2].into_iter().flat_map(i32::to_be_bytes).collect();
    let head =
        b"# vtk DataFile Version 4.2\n\nBINARY\nDATASET POLYDATA\nFIELD FieldData 1\nnames 1 5 string\n";
    let file = |texts: &[u8]| {
        [
            &head[..],
            texts,
            b"\nPOINTS 3 float\n",
            &triangle,
            b"\nPOLYGONS 1 4\n",
            &corners,
        ]
        .concat()
    };
    let frame = parse_frame(&file(&texts), Format::Vtk).unwrap();
    assert_eq!(frame.mesh.faces(), [[0, 1, 2]]);
    for end in [0, 1, 40, texts.len() - 1] {
        let mut cut = file(&texts);
        cut.truncate(head.len() + end);
        let error = parse_frame(&cut, Format::Vtk).unwrap_err().to_string();
        assert!(error.contains("a text and its length"), "{error}");
    }
}
