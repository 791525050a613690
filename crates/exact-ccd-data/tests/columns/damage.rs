//! Files that are cut short, damaged, forged, or not Parquet.

use exact_ccd::VertexFace;
use exact_ccd_data::{ColumnReader, DataError};

use crate::{Reader, bits, full, written};

#[test]
fn files_cut_short_are_an_error() {
    let (reader, bytes) = (Reader::new(), written(&[full(0), full(1), full(2)]));
    for length in 0..bytes.len() {
        let error = reader.error::<VertexFace>(&bytes[..length]);
        assert!(
            error.starts_with(": expected a Parquet file of queries: "),
            "{length}: {error}"
        );
    }
}

/// A wrong byte is an error or changes no query: the queries have checksums.
#[test]
fn damage_is_an_error_or_does_not_matter() {
    let records = [full(0), full(1), full(2)];
    let (reader, sound) = (Reader::new(), written(&records));
    let mut errors = 0;
    for index in 0..sound.len() {
        for mask in [0x01, 0x10, 0x80, 0xff] {
            let mut bytes = sound.clone();
            bytes[index] ^= mask;
            match reader.read::<VertexFace>(&bytes) {
                Ok(read) => assert!(
                    read.iter().map(bits).eq(records.iter().map(bits)),
                    "{index}, {mask:#x}"
                ),
                Err(_) => errors += 1,
            }
        }
    }
    assert!(errors > 2 * sound.len(), "{errors}");
}

/// The header of a page states a size of 2³⁰ bytes.
#[test]
fn pages_that_are_too_large_are_refused() {
    let mut bytes = written(&[full(0)]);
    // The first page: its type is dictionary, and its size is a number of one byte, which five
    // bytes now stand for.
    assert_eq!(bytes[4..8], [0x15, 0x04, 0x15, bytes[7] & 0x7f]);
    bytes.splice(7..8, [0x80, 0x80, 0x80, 0x80, 0x08]);
    let error = Reader::new().error::<VertexFace>(&bytes);
    assert_eq!(
        error,
        ": expected a Parquet file of queries: a page of 1073741824 bytes"
    );
}

#[test]
fn other_files_are_an_error() {
    let reader = Reader::new();
    for bytes in [
        &b""[..],
        b"PAR1",
        b"PAR1PAR1",
        b"0,1,0,1,0,1\n",
        &[0; 1000],
        &[0xff; 1000],
    ] {
        let error = reader.error::<VertexFace>(bytes);
        assert!(
            error.starts_with(": expected a Parquet file of queries: "),
            "{error}"
        );
    }
    let missing = ColumnReader::<VertexFace>::open(&reader.0.path().join("missing"))
        .err()
        .unwrap();
    assert!(matches!(missing, DataError::Io { .. }));
    let folder = ColumnReader::<VertexFace>::open(reader.0.path()).err().unwrap();
    assert!(folder.to_string().contains("irectory"), "{folder}");
}
