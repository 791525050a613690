//! Physical groups.

use exact_ccd_files::{Format, Group, MeshFile, PhysicalTag, Polygons, parse_tet_mesh};

use super::writer::{Contents, Encoding, all, v4};

fn group(dimension: u8, tag: u32, name: &str, vertices: &[u32], cells: &[u32]) -> Group {
    Group {
        name: name.to_owned(),
        physical: Some(PhysicalTag { dimension, tag }),
        vertices: vertices.to_vec(),
        cells: cells.to_vec(),
    }
}

/// Two tetrahedra on both sides of a triangle.
const NODES: &str = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1\n";

/// A file of version 2 with nodes tagged 10, 20 and so on.
fn file_v2() -> String {
    let lines = (1..)
        .zip(NODES.lines())
        .map(|(number, line)| format!("{number}0 {line}\n"));
    let nodes: String = lines.collect();
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
         $PhysicalNames\n3\n2 5 \"the base\"\n3 7 \"up\"\n1 9 \"empty\"\n$EndPhysicalNames\n\
         $Nodes\n5\n{nodes}$EndNodes\n\
         $Elements\n5\n1 2 2 5 1 10 20 30\n2 4 2 7 1 10 20 30 40\n3 4 2 8 1 10 20 30 50\n\
         4 15 2 7 1 40\n5 1 1 0 10 20\n$EndElements\n"
    )
}

#[test]
fn tags_of_version_2_are_the_first_of_each_element() {
    let file = file_v2();
    let (_, groups) = parse_tet_mesh(file.as_bytes()).unwrap();
    let expected = [
        group(0, 7, "", &[3], &[]),
        group(2, 5, "the base", &[0, 1, 2], &[]),
        group(3, 7, "up", &[0, 1, 2, 3], &[0]),
        group(3, 8, "", &[0, 1, 2, 4], &[1]),
    ];
    assert_eq!(groups, expected);
    let error = |from: &str, to: &str| {
        let file = file.replacen(from, to, 1);
        parse_tet_mesh(file.as_bytes()).unwrap_err().to_string()
    };
    let expected = "expected a dimension, a tag and a name in quotes, found ";
    for line in [
        "3 7 up",
        "3 7 \"up",
        "3 7",
        "4 7 \"up\"",
        "3 -7 \"up\"",
        "x 7 \"up\"",
        "\"up\"",
    ] {
        assert_eq!(
            error("3 7 \"up\"", line),
            format!("line 7: {expected}`{}`", line.escape_debug())
        );
    }
    assert_eq!(
        error("s\n3\n", "s\n4\n"),
        format!("line 9: {expected}`$EndPhysicalNames`")
    );
    assert_eq!(
        error("4 2 7 1", "4 2 4294967296 1"),
        "line 21: expected the tag of a physical group, of four bytes, found `4294967296`"
    );
}

/// Of version 4, the entities have the tags: several, or none. The sign is the orientation.
#[test]
fn tags_of_version_4_are_those_of_the_entities() {
    let entities = "0 0 1 2\n3 0 0 0 1 1 0 1 -5 2 1 -2\n1 0 0 0 1 1 1 3 7 8 7 1 3\n2 0 0 -1 1 1 0 0 0\n";
    let nodes = "1 5 1 5\n3 1 0 5\n1\n2\n3\n4\n5\n";
    let elements = "3 3 1 3\n2 3 2 1\n1 1 2 3\n3 1 4 1\n2 1 2 3 4\n3 2 4 1\n3 1 2 3 5\n";
    let file = format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 8 \"up\"\n$EndPhysicalNames\n\
         $Entities\n{entities}$EndEntities\n$Nodes\n{nodes}{NODES}$EndNodes\n\
         $Elements\n{elements}$EndElements\n"
    );
    let (_, groups) = parse_tet_mesh(file.as_bytes()).unwrap();
    let expected = [
        group(2, 5, "", &[0, 1, 2], &[]),
        group(3, 7, "", &[0, 1, 2, 3], &[0]),
        group(3, 8, "up", &[0, 1, 2, 3], &[0]),
    ];
    assert_eq!(groups, expected);
    for (from, to, message) in [
        (
            "0 0 1 2\n",
            "0 0 1\n",
            "line 9: expected the number of entities of a dimension, found the end",
        ),
        (
            "0 0 1 2\n",
            "0 0 1 3\n",
            "line 13: expected the tag of an entity, found `$EndEntities`",
        ),
        (
            "0 0 1 2\n",
            "0 0 1 1\n",
            "line 12: expected `$EndEntities`, found `2`",
        ),
        (
            "1 1 0 1 -5",
            "1 1 0 x -5",
            "line 10: expected the number of physical tags, found `x`",
        ),
        (
            "1 1 0 1 -5",
            "1 1 0 9 -5",
            "line 10: expected the tag of a physical group, found the end",
        ),
        (
            "3 7 8 7 1 3",
            "3 7 8 7 2 3",
            "line 11: expected the tag of a bounding entity, found the end",
        ),
        (
            "3 7 8 7 1 3",
            "3 7 8 7 1 3 4",
            "line 11: expected the end of the line, found `4`",
        ),
        (
            "\n2 0 0 -1",
            "\n1 0 0 -1",
            "line 12: expected an entity of dimension 3 with a tag of its own, found `1`",
        ),
    ] {
        assert!(file.contains(from), "{from}");
        let error = parse_tet_mesh(file.replacen(from, to, 1).as_bytes());
        let error = error.unwrap_err().to_string();
        assert!(error.starts_with(message), "{error}");
    }
    let (start, rest) = file.split_once("$Entities").unwrap();
    let (entities, rest) = rest.split_once("$Nodes").unwrap();
    let error = parse_tet_mesh(format!("{start}$Nodes{rest}$Entities{entities}").as_bytes());
    assert_eq!(
        error.unwrap_err().to_string(),
        "line 31: expected `$Entities` before the elements, found `$Entities`"
    );
}

/// All encodings of a file have the same groups.
#[test]
fn all_encodings_have_the_same_groups() {
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut contents = Contents::new(&positions, &[[0, 1, 2]], &[[0, 1, 2, 3]]);
    contents.physical = [99; 4].map(|tag| vec![tag]);
    for (name, file) in all(&contents) {
        let (_, groups) = parse_tet_mesh(&file).unwrap();
        let expected = [
            group(0, 99, "", &[0], &[]),
            group(1, 99, "", &[0], &[]),
            group(2, 99, "", &[0, 1, 2], &[]),
            group(3, 99, "$body", &[0, 1, 2, 3], &[0]),
        ];
        assert_eq!(groups, expected, "{name}");
    }
}

/// The groups of a frame have names and the vertices that the surface keeps.
#[test]
fn a_frame_has_the_groups_with_names() {
    // A vertex in no cell comes first, and two groups of one name in different dimensions.
    let text = file_v2()
        .replace("$Nodes\n5\n", "$Nodes\n6\n5 9 9 9\n")
        .replace("3 7 \"up\"", "0 7 \"base\"")
        .replace("the base", "base");
    let file = MeshFile::parse(text.as_bytes(), Format::Msh, Polygons::Refuse).unwrap();
    assert_eq!(file.frame.positions.len(), 5);
    let base = Group {
        name: "base".to_owned(),
        vertices: vec![0, 1, 2, 3],
        ..Group::default()
    };
    assert_eq!(file.groups, [base]);
}

/// Each of many groups has each of many elements: an error, before they take too much memory.
#[test]
fn groups_are_bounded_by_the_size_of_the_file() {
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let tetrahedra = [[0, 1, 2, 3]; 5000];
    let mut contents = Contents::new(&positions, &[], &tetrahedra);
    contents.physical[3] = (1..=20_000).collect();
    let error = parse_tet_mesh(&v4(&contents, Encoding::Little))
        .unwrap_err()
        .to_string();
    assert!(error.contains("the data expand to more than "), "{error}");
    assert!(error.starts_with("byte "), "{error}");
}
