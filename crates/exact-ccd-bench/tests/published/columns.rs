//! The published query files to Parquet and back.

use std::fs;
use std::path::Path;

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_data::{
    ColumnReader, ColumnWriter, DataKind, QueryReader, QueryWriter, Record, Rounding, Seventh,
};

use crate::{data, scenes};

/// A query file after a round trip through Parquet.
fn there_and_back<K: DataKind>(file: &Path) -> Vec<u8> {
    let parquet = tempfile::Builder::new().suffix(".parquet").tempfile().unwrap();
    let mut columns = ColumnWriter::<K, _>::new(parquet.as_file()).unwrap();
    for record in QueryReader::open(file, Rounding::Refuse).unwrap().records() {
        columns.write(record.unwrap()).unwrap();
    }
    columns.finish().unwrap();
    let mut rows = QueryWriter::new(Vec::new(), Seventh::Contact);
    for record in ColumnReader::<K>::open(parquet.path()).unwrap().records() {
        rows.write(&record.unwrap()).unwrap();
    }
    rows.into_inner()
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are not there: set EXACT_CCD_DATA")]
fn handcrafted_files_come_back_byte_for_byte() {
    fn check<K: DataKind>() {
        for file in data().handcrafted::<K>().unwrap() {
            assert!(
                there_and_back::<K>(&file) == fs::read(&file).unwrap(),
                "{}",
                file.display()
            );
        }
    }
    check::<VertexFace>();
    check::<EdgeEdge>();
}

/// The query files of the scenes lack the last line break.
#[test]
#[cfg_attr(no_data, ignore = "the published data sets are not there: set EXACT_CCD_DATA")]
fn query_files_of_scenes_come_back_with_a_last_line_break() {
    let mut files = 0;
    for scene in scenes() {
        if let Some(file) = scene.queries::<VertexFace>().unwrap() {
            let expected = [fs::read(&file).unwrap().as_slice(), b"\n"].concat();
            assert!(
                there_and_back::<VertexFace>(&file) == expected,
                "{}",
                file.display()
            );
            files += 1;
        }
        if let Some(file) = scene.queries::<EdgeEdge>().unwrap() {
            let expected = [fs::read(&file).unwrap().as_slice(), b"\n"].concat();
            assert!(
                there_and_back::<EdgeEdge>(&file) == expected,
                "{}",
                file.display()
            );
            files += 1;
        }
    }
    assert_eq!(files, 4);
}

/// 13 queries of one scene are in contact for an interval of time, for which the published count is 1.
#[test]
#[cfg_attr(no_data, ignore = "the published data sets are not there: set EXACT_CCD_DATA")]
fn counts_and_times_of_scenes_are_those_of_the_exact_method() {
    let mut intervals = 0;
    for scene in scenes() {
        let motion = scene.motion().unwrap();
        if scene.roots::<EdgeEdge>().unwrap().is_some() {
            let records: Vec<Record<EdgeEdge>> = scene.records(&motion.step().unwrap()).unwrap();
            let answered: Vec<_> = records.iter().cloned().map(Record::answered).collect();
            assert_eq!(records, answered, "{}", scene.name());
            intervals += records.iter().filter(|record| record.count == Some(-1)).count();
        }
    }
    assert_eq!(intervals, 13);
}
