//! Files in which a few bytes would cost much.

use exact_ccd::VertexFace;

use crate::{Reader, full, written};

/// A Parquet file with these metadata and no data.
fn file(metadata: &[u8]) -> Vec<u8> {
    let length = (metadata.len() as u32).to_le_bytes();
    [b"PAR1", metadata, &length, b"PAR1"].concat()
}

/// Version 1 and a schema of these elements.
fn schema(elements: &[&[u8]]) -> Vec<u8> {
    let count = elements.len();
    assert!(count < 1 << 14);
    let count = [0x80 | (count & 0x7f) as u8, (count >> 7) as u8];
    let head = [&[0x15, 0x02, 0x19, 0xfc][..], &count].concat();
    file(&[&head, elements.concat().as_slice(), &[0]].concat())
}

/// A group `a` with one child: fields 4 and 5.
const GROUP: &[u8] = &[0x48, 0x01, b'a', 0x15, 0x02, 0];
/// A column `a` of truth values: fields 1 and 4.
const COLUMN: &[u8] = &[0x15, 0x00, 0x38, 0x01, b'a', 0];

/// The library would recurse once for each level, and end the process where the stack ends.
#[test]
fn schemas_of_many_levels_are_refused() {
    for levels in [32, 16_000] {
        let elements = [vec![GROUP; levels], vec![COLUMN]].concat();
        let error = Reader::new().error::<VertexFace>(&schema(&elements));
        assert_eq!(
            error,
            ": expected a Parquet file of queries: the columns are not one tree of few levels"
        );
    }
    let few = schema(&[vec![GROUP; 8], vec![COLUMN]].concat());
    let error = Reader::new().error::<VertexFace>(&few);
    assert!(!error.contains("one tree"), "{error}");
}

/// The library would reserve memory for as many children.
#[test]
fn groups_that_announce_many_children_are_refused() {
    let many = [0x48, 0x01, b'a', 0x15, 0xfe, 0xff, 0xff, 0xff, 0x0f, 0];
    let error = Reader::new().error::<VertexFace>(&schema(&[&many, COLUMN]));
    assert!(error.contains("one tree of few levels"), "{error}");
}

/// Dictionaries and runs make a million equal queries a few bytes each column.
#[test]
fn queries_of_a_far_larger_size_than_the_file_are_refused() {
    let records = vec![full(0); 60_000];
    let error = Reader::new().error::<VertexFace>(&written(&records));
    assert!(error.contains("60000 queries take 11520000 bytes"), "{error}");
    assert!(
        Reader::new()
            .read::<VertexFace>(&written(&records[..2000]))
            .is_ok()
    );
}
