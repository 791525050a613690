//! Files in which a few bytes would cost much.

use exact_ccd::VertexFace;

use crate::{Reader, full, written};

/// A Parquet file with these metadata and no data.
fn file(metadata: &[u8]) -> Vec<u8> {
    let length = (metadata.len() as u32).to_le_bytes();
    [b"PAR1", metadata, &length, b"PAR1"].concat()
}

/// A schema of these elements, without the number of its field.
fn elements(elements: &[&[u8]]) -> Vec<u8> {
    let count = elements.len();
    assert!(count < 1 << 14);
    let count = [0x80 | (count & 0x7f) as u8, (count >> 7) as u8];
    [&[0xfc][..], &count, &elements.concat()].concat()
}

/// Version 1 and a schema of these elements.
fn schema(list: &[&[u8]]) -> Vec<u8> {
    file(&[&[0x15, 0x02, 0x19][..], &elements(list), &[0]].concat())
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

/// The library would recurse in these files too, which state the levels in another form than its writers.
#[track_caller]
fn assert_damaged(file: &[u8]) {
    let error = Reader::new().error::<VertexFace>(file);
    assert_eq!(
        error,
        ": expected a Parquet file of queries: the metadata are damaged"
    );
}

/// A file of many columns. Each states in this way that it has one child.
fn hidden_levels(child: &[u8]) -> Vec<u8> {
    // 32,000, which is 16,000 as a signed number.
    let root = [0x48, 0x01, b'a', 0x15, 0x80, 0xfa, 0x01, 0];
    let level = [&[0x15, 0x00, 0x38, 0x01, b'a'], child, &[0]].concat();
    let levels = vec![level.as_slice(); 15_999];
    schema(&[vec![&root[..]], levels, vec![COLUMN]].concat())
}

/// The library takes the first of two schemas.
#[test]
fn a_second_schema_is_refused() {
    let levels = elements(&[vec![GROUP; 16_000], vec![COLUMN]].concat());
    let few = elements(&[GROUP, COLUMN]);
    assert_damaged(&file(
        &[&[0x15, 0x02, 0x19], &levels[..], &[0x09, 0x04], &few, &[0]].concat(),
    ));
}

/// The library takes an i64 where an i32 belongs.
#[test]
fn numbers_of_children_of_another_type_are_refused() {
    assert_damaged(&hidden_levels(&[0x16, 0x02]));
}

/// The library takes the low 16 bits: 65,541 is field 5.
#[test]
fn numbers_of_fields_beyond_16_bits_are_refused() {
    assert_damaged(&hidden_levels(&[0x05, 0x8a, 0x80, 0x08, 0x02]));
}

/// Truth values in a list take a byte each. The library takes these bytes for the next fields.
#[test]
fn collections_of_truth_values_are_refused() {
    for kind in [1, 2] {
        let children = [0x05, 0x0a, 0x02];
        for collection in [0x79, 0x7a] {
            assert_damaged(&hidden_levels(
                &[&[collection, 0x30 | kind], &children[..]].concat(),
            ));
        }
        let children = [0x05, 0x0a, 0x82, 0x00];
        assert_damaged(&hidden_levels(
            &[&[0x7b, 0x02, kind << 4 | kind], &children[..]].concat(),
        ));
    }
}

/// A header can state the size of its page elsewhere than the library writes it.
#[test]
fn headers_of_pages_in_another_form_are_refused() {
    let sound = written(&[full(0)]);
    // The type is dictionary, and the size is a number of one byte.
    assert_eq!(sound[4..8], [0x15, 0x04, 0x15, sound[7] & 0x7f]);
    let size = [0x80, 0x80, 0x80, 0x80, 0x08];
    for header in [
        // The size before the type.
        [&[0x25][..], &size, &[0x05, 0x02, 0x04]].concat(),
        // Another size before the size.
        [&[0x15, 0x04, 0x15, 0x00, 0x05, 0x04], &size[..]].concat(),
        // The number of the field in more than 16 bits.
        [&[0x15, 0x04, 0x05, 0x84, 0x80, 0x08], &size[..]].concat(),
        // An i64.
        [&[0x15, 0x04, 0x16], &size[..]].concat(),
    ] {
        let mut bytes = sound.clone();
        bytes.splice(4..8, header);
        let error = Reader::new().error::<VertexFace>(&bytes);
        assert_eq!(
            error,
            ": expected a Parquet file of queries: the header of a page is damaged"
        );
    }
    // The number of the field in full, where the size is checked.
    let mut bytes = sound;
    bytes.splice(4..8, [&[0x15, 0x04, 0x05, 0x04], &size[..]].concat());
    let error = Reader::new().error::<VertexFace>(&bytes);
    assert!(error.contains("a page of 1073741824 bytes"), "{error}");
}

/// Dictionaries and runs make a million equal queries a few bytes each column. The writer adds zeros.
#[test]
fn queries_of_a_far_larger_size_than_the_file_are_refused() {
    let records = vec![full(0); 60_000];
    let mut bytes = written(&records);
    assert!(Reader::new().read::<VertexFace>(&bytes).is_ok());
    let start = bytes.windows(100).position(|bytes| bytes == [0; 100]).unwrap();
    let length = bytes[start..].iter().position(|&byte| byte != 0).unwrap();
    bytes.drain(start..start + length);
    let error = Reader::new().error::<VertexFace>(&bytes);
    assert!(error.contains("60000 queries take 11520000 bytes"), "{error}");
    assert!(
        Reader::new()
            .read::<VertexFace>(&written(&records[..2000]))
            .is_ok()
    );
}
