//! `exact-ccd queries` of curved motion: files with a JSON object on each line.

use std::io::Write;
use std::path::{Path, PathBuf};

use exact_ccd::{Separation, with_kind};
use exact_ccd_data::{CurvedReader, CurvedRecord};

use super::{Arguments, Run};
use crate::messages::failure::Failure;
use crate::query_files::method::{Answer, Method};

/// Returns true if the files have curved motion, by their names.
pub(super) fn are_curved(files: &[PathBuf]) -> Result<bool, Failure> {
    let (curved, others): (Vec<_>, Vec<_>) = files.iter().partition(|file| is_curved(file));
    match others.first() {
        Some(other) if !curved.is_empty() => Err(Failure::of(
            other,
            "not a file of curved motion, beside others that are; run the program for each sort of files",
        )),
        _ => Ok(!curved.is_empty()),
    }
}

fn is_curved(file: &Path) -> bool {
    let extension = file.extension();
    extension.is_some_and(|extension| extension.eq_ignore_ascii_case("jsonl"))
}

/// Refuses the options that do not apply.
pub(super) fn check(arguments: &Arguments) -> Result<(), Failure> {
    let refusals = [
        (
            arguments.kind.is_some(),
            "--kind does not apply to curved motion: each line of a .jsonl file names its kind",
        ),
        (
            !matches!(arguments.method, Method::Exact),
            "curved motion needs --method exact: the other methods decide straight motion",
        ),
        (
            arguments.round_input,
            "--round-input does not apply to curved motion: a number in a .jsonl file is the nearest f64",
        ),
        (
            arguments.view.is_asked_for(),
            "--view shows straight motion; leave it out for .jsonl files",
        ),
    ];
    match refusals.iter().find(|(applies, _)| *applies) {
        Some((_, message)) => Err(Failure::new(message)),
        None => Ok(()),
    }
}

/// Answers all queries of the files.
pub(super) fn answer_all<W: Write>(run: &mut Run<'_, W>) -> Result<(), Failure> {
    let d = run.arguments.min_distance;
    for file in &run.arguments.files {
        let records = CurvedReader::open(file)?.map(|record| record.map_err(Failure::from));
        let truth = |record: &CurvedRecord| record.count.map(|count| count != 0);
        run.answer(
            file,
            records,
            &|record| Ok(answer(record, d)),
            &truth,
            &mut |_, _, _| {},
        )?;
    }
    Ok(())
}

fn answer(record: &CurvedRecord, d: Separation) -> Answer {
    with_kind!(record.kind(), K => {
        let intervals = record.query::<K>().map(|query| query.intervals(d));
        Answer::of_intervals(&intervals.unwrap_or_default(), d)
    })
}
