//! The published query files converted to Parquet and back.

use std::fs;
use std::path::Path;

use exact_ccd::{CONTACT, ContactTime, EdgeEdge, Kind, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_data::{
    ColumnReader, ColumnWriter, DataKind, QueryReader, QueryWriter, Record, Rounding, Seventh,
};

use crate::{data, scenes};

/// A query file after a round trip through Parquet.
fn round_trip<K: Kind>(file: &Path) -> Vec<u8> {
    let parquet = tempfile::Builder::new().suffix(".parquet").tempfile().unwrap();
    let mut columns = ColumnWriter::<K, _>::new(parquet.as_file()).unwrap();
    for record in QueryReader::open(file, Rounding::Refuse).unwrap() {
        columns.write(record.unwrap()).unwrap();
    }
    columns.finish().unwrap();
    let mut rows = QueryWriter::new(Vec::new(), Seventh::Contact);
    for record in ColumnReader::<K>::open(parquet.path()).unwrap() {
        rows.write(&record.unwrap()).unwrap();
    }
    rows.into_inner()
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn a_round_trip_keeps_all_bytes_of_handcrafted_files() {
    fn check<K: DataKind>() {
        for file in data().handcrafted::<K>().unwrap() {
            assert!(
                round_trip::<K>(&file) == fs::read(&file).unwrap(),
                "{}",
                file.display()
            );
        }
    }
    check::<VertexFace>();
    check::<EdgeEdge>();
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn a_round_trip_keeps_all_bytes_of_files_about_distances() {
    fn check<K: Kind>() -> usize {
        let files = data().separation::<K>().unwrap();
        for file in &files {
            let file = &file.queries;
            assert!(
                round_trip::<K>(file) == fs::read(file).unwrap(),
                "{}",
                file.display()
            );
        }
        files.len()
    }
    let counts = [
        check::<VertexFace>(),
        check::<EdgeEdge>(),
        check::<VertexEdge>(),
        check::<VertexVertex>(),
    ];
    assert_eq!(counts, [10, 10, 11, 11]);
}

/// The query files of the scenes lack the last line break.
#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn a_round_trip_adds_the_last_line_break_to_files_of_scenes() {
    let mut files = 0;
    for scene in scenes() {
        if let Some(file) = scene.queries::<VertexFace>().unwrap() {
            let expected = [fs::read(&file).unwrap().as_slice(), b"\n"].concat();
            assert!(round_trip::<VertexFace>(&file) == expected, "{}", file.display());
            files += 1;
        }
        if let Some(file) = scene.queries::<EdgeEdge>().unwrap() {
            let expected = [fs::read(&file).unwrap().as_slice(), b"\n"].concat();
            assert!(round_trip::<EdgeEdge>(&file) == expected, "{}", file.display());
            files += 1;
        }
    }
    assert_eq!(files, 4);
}

/// The published count of an interval of contact is 1, the exact one −1. 13 queries of one scene have
/// such an interval.
#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn counts_and_times_of_scenes_are_those_of_the_exact_method() {
    let mut intervals = 0;
    for scene in scenes() {
        let motion = scene.motion().unwrap();
        if scene.roots::<EdgeEdge>().unwrap().is_some() {
            let records: Vec<Record<EdgeEdge>> = scene.records(&motion.step().unwrap()).unwrap();
            for record in &records {
                let times = record.sample.query.intervals(CONTACT);
                let count = times.count().map_or(-1, |count| count as i64);
                let answer = (Some(count), times.first_time().map(ContactTime::lower));
                assert_eq!((record.count, record.toi), answer, "{}", scene.name());
            }
            intervals += records.iter().filter(|record| record.count == Some(-1)).count();
        }
    }
    assert_eq!(intervals, 13);
}
