//! The panic hook of the process: it belongs to the program, not to a library.

use std::fs;
use std::panic::{self, PanicHookInfo};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use exact_ccd::{Query, VertexFace};
use exact_ccd_data::{ColumnReader, ColumnWriter, Record, Sample};

type Hook = Box<dyn Fn(&PanicHookInfo<'_>) + Sync + Send>;

fn address(hook: &Hook) -> *const () {
    (&raw const **hook).cast()
}

#[test]
fn reading_leaves_the_hook_as_it_is() {
    let calls = Arc::new(AtomicUsize::new(0));
    let counter = calls.clone();
    let hook: Hook = Box::new(move |_| {
        counter.fetch_add(1, Ordering::Relaxed);
    });
    let before = address(&hook);
    panic::set_hook(hook);

    let query = Query::<VertexFace>::new([[0.0; 3]; 4], [[1.0; 3]; 4]).unwrap();
    let mut writer = ColumnWriter::new(Vec::new()).unwrap();
    writer.write(Record::from(Sample { query, truth: None })).unwrap();
    let sound = writer.finish().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("q.parquet");
    for length in [sound.len(), sound.len() - 1, 20] {
        fs::write(&file, &sound[..length]).unwrap();
        let read = ColumnReader::<VertexFace>::open(&file).map(Iterator::count);
        assert_eq!(read.is_ok(), length == sound.len());
    }

    let after = address(&panic::take_hook());
    assert_eq!(after, before);
    assert_eq!(calls.load(Ordering::Relaxed), 0);
}
