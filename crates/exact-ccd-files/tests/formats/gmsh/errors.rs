//! Each error names its place and what was expected there, on one line.

use exact_ccd_files::{Format, parse_frame, parse_tet_mesh};

use super::writer::{Contents, Encoding, v2, v4};

#[track_caller]
fn assert_error(bytes: impl AsRef<[u8]>, message: &str) {
    let bytes = bytes.as_ref();
    assert_eq!(parse_tet_mesh(bytes).unwrap_err().to_string(), message);
    assert_eq!(parse_frame(bytes, Format::Msh).unwrap_err().to_string(), message);
}

fn contents() -> Contents {
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    Contents::new(&positions, &[[0, 1, 2]], &[[0, 1, 2, 3]])
}

/// The sample as text with one replacement.
#[track_caller]
fn changed(version: fn(&Contents, Encoding) -> Vec<u8>, from: &str, to: &str) -> String {
    let text = String::from_utf8(version(&contents(), Encoding::Text)).unwrap();
    assert!(text.contains(from), "{text}");
    text.replacen(from, to, 1)
}

#[test]
fn header() {
    let error = parse_tet_mesh(b"").unwrap_err().to_string();
    assert_eq!(error, "line 1: the file ends, expected `$MeshFormat`");
    assert_error("mesh\n", "line 1: expected `$MeshFormat`, found `mesh`");
    assert_error(
        "$MeshFormat\n3.0 0 8\n",
        "line 2: expected version 1, 2, 2.2, 4 or 4.1 (save it with gmsh -save -format msh41), found `3.0`",
    );
    assert_error(
        "$MeshFormat\n4.1 2 8\n",
        "line 2: expected `0` for text or `1` for binary, found `2`",
    );
    assert_error(
        "$MeshFormat\n4.1 1 4\n",
        "line 2: expected `8`, the size of a number, found `4`",
    );
    assert_error(
        "$MeshFormat\n4.1 0 8\n",
        "line 3: the file ends, expected `$EndMeshFormat`",
    );
    assert_error(
        b"$MeshFormat\n4.1 1 8\n\0\0\x01\0\n$EndMeshFormat\n",
        "byte 20: expected the number 1 in four bytes, found [0, 0, 1, 0]",
    );
    let header = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    assert_error(header, "line 4: the file ends, expected `$Nodes`");
    assert_error(
        format!("{header}Nodes\n"),
        "line 4: expected a section such as `$Nodes`, found `Nodes`",
    );
    assert_error(
        format!("{header}$Elements\n"),
        "line 4: expected `$Nodes` before the elements, found `$Elements`",
    );
    assert_error(
        format!("{header}$Comments\n$Nodes\n"),
        "line 6: the file ends, expected `$EndComments`",
    );
    let nodes = "$Nodes\n0 0 0 0\n$EndNodes\n";
    assert_error(
        format!("{header}{nodes}"),
        "line 7: the file ends, expected `$Elements`",
    );
    assert_error(
        format!("{header}{nodes}{nodes}"),
        "line 7: expected a section of which there is no other, found `$Nodes`",
    );
}

#[test]
fn version_2() {
    // The nodes begin in line 8, the elements in line 15.
    for (from, to, message) in [
        (
            "\n4\n1 0.0",
            "\nfour\n1 0.0",
            "line 9: expected the number of nodes, found `four`",
        ),
        (
            "2 1.0 0.0 0.0",
            "2 1.0 x 0.0",
            "line 11: expected the coordinate y, found `x`",
        ),
        (
            "2 1.0 0.0 0.0",
            "2 1.0 0.0",
            "line 11: expected the coordinate z, found the end of the line",
        ),
        (
            "2 1.0 0.0 0.0",
            "2 1.0 0.0 0.0 0",
            "line 11: expected the end of the line, found `0`",
        ),
        (
            "2 1.0 0.0 0.0",
            "1 1.0 0.0 0.0",
            "line 11: expected a node with a tag of its own, found `1`",
        ),
        (
            "2 1.0 0.0 0.0",
            "-2 1.0 0.0 0.0",
            "line 11: expected the tag of a node, found `-2`",
        ),
        (
            "2 1.0 0.0 0.0",
            "2 1.0 inf 0.0",
            "vertex 1 has y = inf, expected a finite number",
        ),
        (
            "\n4\n1 0.0",
            "\n5\n1 0.0",
            "line 14: expected the tag of a node, found `$EndNodes`",
        ),
        (
            "\n4\n1 0.0",
            "\n3\n1 0.0",
            "line 13: expected `$EndNodes`, found `4`",
        ),
        (
            "4 4 2 99 2 1 2 3 4",
            "4 11 2 99 2 1 2 3 4",
            "line 20: expected an element of first order, of type 1 to 7 or 15 (save the mesh again with gmsh -order 1 \
             -save), found `11`",
        ),
        (
            "4 4 2 99 2 1 2 3 4",
            "4 4 2 99 2 1 2 3 5",
            "line 20: expected the tag of one of the 4 nodes, found `5`",
        ),
        (
            "4 4 2 99 2 1 2 3 4",
            "4 4 2 99 2 1 2 3",
            "line 20: expected the tag of a node, found the end of the line",
        ),
        (
            "4 4 2 99 2 1 2 3 4",
            "4 4 2 99 2 1 2 3 4 1",
            "line 20: expected the end of the line, found `1`",
        ),
        (
            "4 4 2 99 2 1 2 3 4",
            "4 4 2 99 2 1 2 3 3",
            "tetrahedron 0 has no volume",
        ),
        (
            "4 4 2 99 2 1 2 3 4 \n$EndElements\n",
            "",
            "line 20: the file ends, expected element 3 of 4",
        ),
    ] {
        assert_error(changed(v2, from, to), message);
    }
}

#[test]
fn version_4() {
    // The nodes begin in line 7, their blocks in lines 9, 14 and 15, the elements in line 21.
    for (from, to, message) in [
        (
            "3 4 1 4",
            "3 4 1",
            "line 8: expected the greatest tag of a node, found the end of the line",
        ),
        ("3 4 1 4", "3 5 1 4", "line 8: expected 5 nodes, found 4"),
        ("3 4 1 4", "2 4 1 4", "line 8: expected 4 nodes, found 2"),
        (
            "2 1 1 2 \n",
            "4 1 1 2 \n",
            "line 9: expected a dimension from 0 to 3, found `4`",
        ),
        (
            "2 1 1 2 \n",
            "2 1 0 2 \n",
            "line 12: expected the end of the line, found `0.5 0.5`",
        ),
        (
            "2 1 1 2 \n",
            "3 1 1 2 \n",
            "line 12: expected a parameter, found the end of the line",
        ),
        (
            "2 1 1 2 \n",
            "2 1 1 18446744073709551615 \n",
            "line 12: expected the tag of a node, found `0.0`",
        ),
        (
            "4 4 1 4 \n",
            "4 5 1 4 \n",
            "line 22: expected 5 elements, found 4",
        ),
        (
            "3 1 4 1 \n",
            "3 1 11 1 \n",
            "line 29: expected an element of first order, of type 1 to 7 or 15 (save the mesh again with gmsh -order 1 \
             -save), found `11`",
        ),
        (
            "4 1 2 3 4 \n",
            "4 1 2 3 0 \n",
            "line 30: expected the tag of one of the 4 nodes, found `0`",
        ),
        (
            "4 1 2 3 4 \n$",
            "$",
            "line 30: expected the tag of an element, found `$EndElements`",
        ),
    ] {
        assert_error(changed(v4, from, to), message);
    }
}

#[test]
fn a_triangle_inside_or_out_that_belongs_to_no_tetrahedron() {
    let mut contents = contents();
    contents.nodes.push((5, [9.0, 9.0, 9.0]));
    contents.triangles.push([1, 2, 5]);
    assert_error(
        v4(&contents, Encoding::Big),
        "face 1 is no side of a cell with volume",
    );
}

#[test]
fn binary() {
    let file = v2(&contents(), Encoding::Big);
    let start = |section: &str| {
        let section = format!("${section}\n");
        file.windows(section.len())
            .position(|window| window == section.as_bytes())
            .unwrap()
            + section.len()
    };
    let nodes = start("Nodes");
    assert_error(
        &file[..nodes + 2 + 28 + 20],
        &format!(
            "byte {}: the file ends, expected the coordinate z in node 1 of 4",
            nodes + 2 + 28 + 20
        ),
    );
    let elements = start("Elements");
    let block = elements + 2;
    let mut changed = file.clone();
    changed[block + 7] = 5;
    assert_error(
        changed,
        &format!(
            "byte {}: expected a block of at most 4 elements, found `5`",
            block + 4
        ),
    );
    let mut changed = file.clone();
    changed[block + 4] = 0xff;
    assert_error(
        changed,
        &format!(
            "byte {}: expected a block of at most 4 elements, found `-16777215`",
            block + 4
        ),
    );
    let end = file.len() - "$EndElements\n".len();
    assert_error(
        &file[..end],
        &format!("byte {end}: the file ends, expected `$EndElements`"),
    );
}
