//! The names of the parts of a mesh, in PLY files.

use std::ops::Range;

use exact_ccd_files::{Format, Group, MeshFile, NamedPart, Polygons, write_ply, write_ply_with_parts};
use exact_ccd_mesh::Frame;

fn frame() -> Frame {
    let at = |x: f64| [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.0]];
    Frame::new([at(0.0), at(5.0)].concat(), vec![[0, 1, 2], [3, 4, 5]]).unwrap()
}

fn part(name: &str, vertices: Range<u32>) -> NamedPart {
    let name = name.to_owned();
    NamedPart { name, vertices }
}

fn group(name: &str, vertices: &[u32]) -> Group {
    Group {
        name: name.to_owned(),
        vertices: vertices.to_vec(),
        ..Group::default()
    }
}

fn read(file: &[u8]) -> MeshFile {
    MeshFile::parse(file, Format::Ply, Polygons::Refuse).unwrap()
}

#[test]
fn names_are_read_as_they_were_written() {
    let parts = [
        part("a block: ü", 0..2),
        part("tip", 2..3),
        part("a block: ü", 3..6),
    ];
    let mut file = Vec::new();
    write_ply_with_parts(&mut file, &frame(), &parts).unwrap();
    let found = read(&file);
    // Parts of one name are one group.
    let expected = [group("a block: ü", &[0, 1, 3, 4, 5]), group("tip", &[2])];
    assert_eq!(found.groups, expected);
    assert_eq!(found.frame, frame());
    let mut plain = Vec::new();
    write_ply(&mut plain, &frame()).unwrap();
    assert!(read(&plain).groups.is_empty());
}

#[test]
fn names_keep_their_blanks() {
    let parts = [
        part(" cube ", 0..2),
        part("cube", 2..3),
        part("  ", 3..5),
        part("\u{3000}", 5..6),
    ];
    let mut file = Vec::new();
    write_ply_with_parts(&mut file, &frame(), &parts).unwrap();
    let expected = [
        group(" cube ", &[0, 1]),
        group("cube", &[2]),
        group("  ", &[3, 4]),
        group("\u{3000}", &[5]),
    ];
    assert_eq!(read(&file).groups, expected);
}

#[test]
fn other_comments_and_parts_with_gaps_name_nothing() {
    let mut plain = Vec::new();
    write_ply(&mut plain, &frame()).unwrap();
    let with = |comments: &str| {
        let end = plain.windows(8).position(|bytes| bytes == b"element ").unwrap();
        read(&[&plain[..end], comments.as_bytes(), &plain[end..]].concat()).groups
    };
    assert_eq!(
        with("comment part 0 6 all\n"),
        [group("all", &[0, 1, 2, 3, 4, 5])]
    );
    // An empty name names nothing, and the other parts keep theirs. A carriage return ends a line, too.
    assert_eq!(
        with("comment part 0 4 \ncomment part 4 6 tip\r\n"),
        [group("tip", &[4, 5])]
    );
    for comments in [
        "comment part 0 6\n",
        "comment part 0 5 a\n",
        "comment part 1 6 a\n",
        "comment part 0 7 a\n",
        "comment part 0 4 a\ncomment part 3 6 b\n",
        "comment part 4 0 a\n",
        "comment a part 0 6 b\n",
        "comment part -1 6 a\n",
    ] {
        assert!(with(comments).is_empty(), "{comments}");
    }
}

#[test]
fn parts_that_a_file_cannot_hold_are_not_written() {
    let error = |parts: &[NamedPart]| {
        let mut file = Vec::new();
        let error = write_ply_with_parts(&mut file, &frame(), parts).unwrap_err();
        assert!(file.is_empty());
        error.to_string()
    };
    let gap = "the parts do not cover all vertices in their order";
    assert_eq!(error(&[part("a", 0..5)]), gap);
    assert_eq!(error(&[part("a", 3..6), part("b", 0..3)]), gap);
    assert_eq!(error(&[part("", 0..6)]), "the name of a part is empty");
    assert_eq!(
        error(&[part("a\nb", 0..6)]),
        "the name \"a\\nb\" has a control character"
    );
}
