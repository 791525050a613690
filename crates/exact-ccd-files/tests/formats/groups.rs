//! Objects and groups of OBJ files.

use exact_ccd_files::{Format, Group, MeshFile, Polygons};

fn groups(text: &str) -> Vec<(String, Vec<u32>)> {
    let file = MeshFile::parse(text.as_bytes(), Format::Obj, Polygons::Triangulate).unwrap();
    let parts = |Group { name, vertices, .. }: Group| (name, vertices);
    file.groups.into_iter().map(parts).collect()
}

/// Seven vertices.
const VERTICES: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\n";

#[test]
fn an_element_belongs_to_the_last_name_before_it() {
    let text = format!(
        "{VERTICES}f 1 2 3\no Cube\nf 2 3 4\ng left  side\nf 4 5 6\nl 6 7\no Cube\np 7\ng\nf 1 2 5\no empty\n"
    );
    let named = |name: &str, vertices: &[u32]| (name.to_owned(), vertices.to_vec());
    assert_eq!(
        groups(&text),
        [named("Cube", &[1, 2, 3, 6]), named("left side", &[3, 4, 5, 6])]
    );
    assert_eq!(groups(&format!("{VERTICES}f 1 2 3\n")), []);
}

/// Vertices of a group may come after its elements, and names may be anything.
#[test]
fn any_name_is_a_group() {
    let text = format!("g a:b/c\nf 1 2 -1\n{VERTICES}o \u{e9}\nf -1 -2 -3 -4\n");
    let error = MeshFile::parse(text.as_bytes(), Format::Obj, Polygons::Triangulate).unwrap_err();
    assert!(error.to_string().contains("line 2"), "{error}");
    let text = format!("g a:b/c\nf 1 2 7\n{VERTICES}o \u{e9}\nf -1 -2 -3 -4\n");
    assert_eq!(
        groups(&text),
        [
            ("a:b/c".to_owned(), vec![0, 1, 6]),
            ("é".to_owned(), vec![3, 4, 5, 6])
        ]
    );
    let broken = [VERTICES.as_bytes(), b"o \xff\nf 1 2 3\n"].concat();
    let file = MeshFile::parse(&broken, Format::Obj, Polygons::Triangulate).unwrap();
    assert_eq!(file.groups[0].name, "\u{fffd}");
}

/// The time is proportional to the file, for many names too.
#[test]
fn many_groups_are_read() {
    let mut text = VERTICES.to_owned();
    for number in 0..100_000 {
        text += &format!("g {}\nf 1 2 3\n", number % 60_000);
    }
    assert_eq!(groups(&text).len(), 60_000);
}
