//! Each error names its place and what was expected there, on one line.

use exact_ccd_files::{Format, parse_frame};

#[track_caller]
fn assert_error(format: Format, bytes: impl AsRef<[u8]>, message: &str) {
    assert_eq!(
        parse_frame(bytes.as_ref(), format).unwrap_err().to_string(),
        message
    );
}

/// A header of a PLY file of 3 vertices and 1 face, with more lines before its end.
fn ply_header(encoding: &str, more: &str) -> String {
    format!(
        "ply\nformat {encoding} 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty \
         double z\n\
         element face 1\nproperty list uchar int vertex_indices\n{more}end_header\n"
    )
}

#[track_caller]
fn assert_ply_text_error(body: &str, message: &str) {
    assert_error(Format::Ply, ply_header("ascii", "") + body, message);
}

#[track_caller]
fn assert_ply_header_error(header: &str, message: &str) {
    assert_error(Format::Ply, header, message);
}

#[test]
fn ply_text() {
    assert_ply_text_error("0 0 0\n1 0 x\n", "line 11: expected a number, found `x`");
    assert_ply_text_error(
        "0 0 0\n1 0\n",
        "line 11: expected a number, found the end of the line",
    );
    assert_ply_text_error(
        "0 0 0\n",
        "line 11: the file ends, expected element `vertex`, row 1 of 3",
    );
    let vertices = "0 0 0\n1 0 0\n0 1 0\n";
    let error = |face: &str, message| assert_ply_text_error(&format!("{vertices}{face}\n"), message);
    error("2 0 1", "line 13: face 0 has 2 corners, expected at least 3");
    error("-1", "line 13: face 0 has -1 corners, expected at least 3");
    error(
        "3 0 1 3",
        "line 13: face 0 names vertex 3, but there are 3 vertices, counted from 0",
    );
    error(
        "3 0 1 -1",
        "line 13: face 0 names vertex -1, but there are 3 vertices, counted from 0",
    );
    error("3 0 1 1.0", "line 13: expected an integer, found `1.0`");
    error(
        "3 0 1 99999999999999999999",
        "line 13: expected an integer, found `99999999999999999999`",
    );
    error(
        "3 0 1 2\n\n3 0 1 2",
        "line 15: expected the end of the file, found `3 0 1 2`",
    );
    assert_ply_text_error(
        "0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n",
        "vertex 2 has y = NaN, expected a finite number",
    );
    assert_ply_text_error(
        "0 0 0\n1 0 1e999\n0 0 0\n3 0 1 2\n",
        "vertex 1 has z = inf, expected a finite number",
    );
}

#[test]
fn ply_binary() {
    let header = ply_header("binary_little_endian", "");
    let file = |body: &[u8]| [header.as_bytes(), body].concat();
    let offset = header.len();
    let message = |at: usize, what: &str| format!("byte {}: {what}", offset + at);
    let vertices = [0; 72];

    let error = |body: &[u8], at, what| assert_error(Format::Ply, file(body), &message(at, what));
    error(
        &[],
        0,
        "the file ends, expected a number in element `vertex`, row 0 of 3",
    );
    error(
        &vertices[..71],
        64,
        "the file ends, expected a number in element `vertex`, row 2 of 3",
    );
    error(
        &vertices,
        72,
        "the file ends, expected the length of a list in element `face`, row 0 of 1",
    );
    let face = |face: &[u8]| [&vertices, face].concat();
    error(
        &face(&[1, 0, 0, 0, 0]),
        72,
        "face 0 has 1 corners, expected at least 3",
    );
    error(
        &face(&[3, 0, 0, 0, 0, 9, 0, 0, 0]),
        77,
        "face 0 names vertex 9, but there are 3 vertices, counted from 0",
    );
    error(
        &face(&[3, 0, 0, 0, 0, 1, 0, 0]),
        77,
        "the file ends, expected an integer in element `face`, row 0 of 1",
    );
    error(
        &face(&[3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 7, 7]),
        85,
        "expected the end of the file, found 2 more bytes",
    );

    let mut infinite = face(&[3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]);
    infinite[24..32].copy_from_slice(&f64::NEG_INFINITY.to_le_bytes());
    assert_error(
        Format::Ply,
        file(&infinite),
        "vertex 1 has x = -inf, expected a finite number",
    );

    let more = "element extra 1\nproperty list int int values\n";
    let header = ply_header("binary_big_endian", more)
        .replace("vertex 3", "vertex 0")
        .replace("face 1", "face 0");
    let at = header.len();
    let negative = [header.as_bytes(), &[0xff; 4]].concat();
    assert_error(
        Format::Ply,
        negative,
        &format!("byte {at}: expected the length of a list, found `-1`"),
    );
}

#[test]
fn ply_headers() {
    let statement = "`format`, `comment`, `element`, `property` or `end_header`";
    let error = assert_ply_header_error;
    error("", "the contents are empty, expected PLY; export the mesh again");
    error(
        "PK\u{3}\u{5}\u{14}\n",
        "line 1: expected `ply`, found `PK\\u{3}\\u{5}\\u{14}`",
    );
    error(
        "ply\nformat ascii 1.0\n",
        "line 3: the file ends, expected `end_header`",
    );
    error("ply\nformat ascii 2.0\n", "line 2: expected `1.0`, found `2.0`");
    error(
        "ply\nformat binary 1.0\n",
        "line 2: expected `ascii`, `binary_little_endian` or `binary_big_endian`, found `binary`",
    );
    error(
        "ply\nend_header\n",
        "line 2: expected `format`, found `end_header`",
    );
    error(
        "ply\nvertex 3\n",
        &format!("line 2: expected {statement}, found `vertex`"),
    );
    error(
        "ply\nelement vertex many\n",
        "line 2: expected the number of rows, found `many`",
    );
    error(
        "ply\nelement vertex -3\n",
        "line 2: expected the number of rows, found `-3`",
    );
    error(
        "ply\nproperty float x\n",
        "line 2: expected `element`, found `property`",
    );
    error(
        "ply\nelement vertex 3\nproperty real x\n",
        "line 3: expected a type such as `int`, `float` or `double`, found `real`",
    );
    error(
        "ply\nelement face 3\nproperty list float int vertex_indices\n",
        "line 3: expected a type of integers, found `float`",
    );
    error(
        "ply\nelement vertex 3\nproperty float x\nproperty float x\n",
        "line 4: expected a property with a name of its own, found `x`",
    );
    error(
        "ply\nelement a 3\nelement a 3\n",
        "line 3: expected an element with a name of its own, found `a`",
    );
    error(
        "ply\nformat ascii 1.0\nend_header\n",
        "line 3: expected an element `vertex` in the header, found none; export the mesh with its vertices and \
         faces",
    );
    error(
        "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n3 0 1 2\n",
        "line 5: expected an element `vertex` in the header, found none; export the mesh with its vertices and \
         faces",
    );
    let points = "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n";
    error(
        &format!("{points}end_header\n"),
        "line 3: expected a property `z` of element `vertex`, a number, found none",
    );
    let faces = "element face 0\nproperty list uchar float vertex_indices\nend_header\n";
    error(
        &format!("{points}{faces}"),
        "line 3: expected a property `z` of element `vertex`, a number, found none",
    );
    error(
        &format!("{points}property float z\n{faces}"),
        "line 7: expected a property `vertex_indices` of element `face`, a list of integers, found none",
    );
    let long = format!("ply\n{}\n", "long".repeat(1000));
    let quote = format!("`{}…`", "long".repeat(10));
    error(&long, &format!("line 2: expected {statement}, found {quote}"));
}

#[test]
fn obj() {
    let error = |text: &str, message| assert_error(Format::Obj, text, message);
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let face = |face: &str, message: &str| {
        assert_error(Format::Obj, format!("{triangle}f 1 2 3\n{face}\n"), message);
    };
    error(
        "",
        "the contents are empty, expected Wavefront OBJ; export the mesh again",
    );
    error("\u{7f}elk\n\n", "line 3: the file ends, expected a statement `v`");
    error("v 0\n", "line 1: expected a number, found the end of the line");
    error(
        "v 0 0 0\nv 0 0\n",
        "line 2: expected three coordinates, as other vertices have, found two",
    );
    error("\nv 0 \\\n0 o\n", "line 2: expected a number, found `o`");
    face("f 1", "line 5: face 2 has 1 corners, expected at least 3");
    face(
        "f 1 2 4",
        "line 5: face 2 names vertex 4, but there are 3 vertices, counted from 1",
    );
    face(
        "f 1 2 0",
        "line 5: face 2 names vertex 0, but there are 3 vertices, counted from 1",
    );
    face(
        "f -1 -2 -4",
        "line 5: face 2 names vertex -4, but there are 3 vertices, counted from 1",
    );
    for corner in [
        "a",
        "1/a",
        "1//a",
        "1/1/1/1",
        "1///",
        "/1",
        "1.5",
        "99999999999999999999",
    ] {
        let message = format!("line 5: expected a corner such as 1, 1/2, 1/2/3 or 1//3, found `{corner}`");
        face(&format!("f 1 2 {corner}"), &message);
    }
    error("v 0 0 -inf\n", "line 1: expected a finite number, found `-inf`");
    error("v 0 0 1e999\n", "line 1: expected a finite number, found `1e999`");
}

#[test]
fn off() {
    let error = |text: &str, message| assert_error(Format::Off, text, message);
    error("# nothing\n", "line 2: the file ends, expected `OFF`");
    error("4OFF\n", "line 1: expected `OFF`, found `4OFF`");
    error(
        "OFF BINARY\n",
        "line 1: expected the number of vertices, found `BINARY`",
    );
    error(
        "OFF\n",
        "line 2: the file ends, expected the numbers of vertices and faces",
    );
    error(
        "OFF\n3\n",
        "line 2: expected the number of faces, found the end of the line",
    );
    error(
        "OFF\n2 1 0\n0 0 0\n",
        "line 4: the file ends, expected vertex 1 of 2",
    );
    error(
        "OFF\n1 1 0\n0 0 zero\n",
        "line 3: expected a number, found `zero`",
    );
    error(
        "OFF\n1 2 0\n0 0 0\n3 0 0 0\n",
        "line 5: the file ends, expected face 1 of 2",
    );
    error(
        "OFF\n1 1 0\n0 0 0\n0\n",
        "line 4: face 0 has 0 corners, expected at least 3",
    );
    let message = "line 4: face 0 names vertex 1, but there are 1 vertices, counted from 0";
    error("OFF\n1 1 0\n0 0 0\n3 0 0 1\n", message);
    error(
        "OFF\n1 1 0\n0 0 0\n3 0 0\n",
        "line 5: the file ends, expected the index of a vertex",
    );
    error(
        "OFF\n1 0 0\n0 0 0\n3 0 0 0\n",
        "line 4: expected the end of the file, found `3 0 0 0`",
    );
    error(
        "OFF\n1 0 0\ninf 0 0\n",
        "line 3: expected a finite number, found `inf`",
    );
}

#[test]
fn stl() {
    let error = |text: &str, message| assert_error(Format::Stl, text, message);
    error("", "the contents are empty, expected STL; export the mesh again");
    error("solid", "line 1: the file ends, expected `facet` or `endsolid`");
    error(
        "solid a\nfacets\n",
        "line 2: expected `facet` or `endsolid`, found `facets`",
    );
    error("solid a\nfacet 0 0 1\n", "line 2: expected `normal`, found `0`");
    let vertices = "vertex 0 0 0\nvertex 1 0 0\n";
    let facet = format!("solid a\nfacet normal 0 0 1\nouter loop\n{vertices}");
    error(
        &format!("{facet}vertex 0 up 0\n"),
        "line 6: expected a number, found `up`",
    );
    error(
        &format!("{facet}vertex 0"),
        "line 6: the file ends, expected a number",
    );
    error(
        &format!("{facet}endloop\n"),
        "line 6: expected 3 corners of face 0, found 2",
    );
    error(
        &format!("{facet}{vertices}endloop\n"),
        "line 8: expected 3 corners of face 0, found 4",
    );
    error(&facet, "line 6: the file ends, expected `vertex` or `endloop`");
    error(
        &format!("{facet}vertex 0 1 NaN\nendloop\nendfacet\nendsolid\n"),
        "line 6: expected a finite number, found `NaN`",
    );
    error(
        &format!("{facet}vertex 0 1 0\nendloop\nendsolid\n"),
        "line 8: expected `endfacet`, found `endsolid`",
    );
    error(
        "solid\nendsolid\nv 0 0 0\n",
        "line 3: expected `solid`, found `v`",
    );

    let mut binary = vec![0; 80];
    assert_error(
        Format::Stl,
        &binary,
        "byte 80: the file ends, expected the number of triangles",
    );
    binary.extend([2, 0, 0, 0]);
    binary.extend([0; 99]);
    assert_error(
        Format::Stl,
        &binary,
        "byte 134: the file ends, expected triangle 1 of 2",
    );
    binary.extend([0; 2]);
    assert_error(
        Format::Stl,
        &binary,
        "byte 184: expected the end of the file, found 1 more bytes",
    );
}
