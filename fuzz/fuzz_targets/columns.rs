//! Parquet files of queries: no bytes make the reader panic, and queries that are read survive a round trip.

#![no_main]

use std::fs;
use std::path::PathBuf;
use std::sync::LazyLock;

use arbitrary::{Result, Unstructured};
use exact_ccd::{Query, VertexFace};
use exact_ccd_data::{ColumnReader, ColumnWriter, Record, Sample};
use exact_ccd_fuzz::positions;
use libfuzzer_sys::fuzz_target;

static FILE: LazyLock<PathBuf> =
    LazyLock::new(|| std::env::temp_dir().join(format!("exact-ccd-columns-{}.parquet", std::process::id())));

fuzz_target!(
    // The reader catches panics of its library, and a hook that aborts would come before. Others end the run.
    init: std::panic::set_hook(Box::new(|_| {})),
    |bytes: &[u8]| {
        // Too few bytes are no file.
        let _ = check(Unstructured::new(bytes));
    }
);

fn check(mut bytes: Unstructured) -> Result<()> {
    let mut records = Vec::new();
    for _ in 0..bytes.int_in_range(0..=3)? {
        let [start, end] = positions(&mut bytes, 4)?;
        let four = |x: &[_]| [x[0], x[1], x[2], x[3]];
        let Ok(query) = Query::new(four(&start), four(&end)) else {
            continue;
        };
        records.push(Record {
            sample: Sample {
                query,
                truth: bytes.arbitrary()?,
            },
            count: bytes
                .arbitrary::<Option<u32>>()?
                .map(|count| i64::from(count) - 1),
            toi: None,
            scene: None,
            ids: None,
        });
    }
    let mut file = written(&records);
    assert!(read(&file).is_some_and(|read| read == records), "{records:?}");
    // A sound file with damage, or any bytes.
    for _ in 0..bytes.int_in_range(0..=4)? {
        let index = bytes.choose_index(file.len())?;
        file[index] = bytes.arbitrary()?;
    }
    let _ = read(&file);
    let _ = read(bytes.take_rest());
    Ok(())
}

fn written(records: &[Record<VertexFace>]) -> Vec<u8> {
    let mut writer = ColumnWriter::new(Vec::new()).expect("writing into memory cannot fail");
    records
        .iter()
        .for_each(|record| writer.write(record.clone()).expect("there are no ids"));
    writer.finish().expect("writing into memory cannot fail")
}

/// The queries, if there is no error.
fn read(bytes: &[u8]) -> Option<Vec<Record<VertexFace>>> {
    fs::write(&*FILE, bytes).expect("a temporary file");
    ColumnReader::open(&FILE)
        .ok()?
        .collect::<std::result::Result<_, _>>()
        .ok()
}
