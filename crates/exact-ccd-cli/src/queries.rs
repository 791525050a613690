//! `exact-ccd queries`: the contact times of the queries in CSV files.

use std::io::{self, BufWriter, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use ccd_bench::{DataKind, QueryReader, Rounding, Sample};
use exact_ccd::{ContactTime, ContactTimes, PointTriangle, SegmentSegment};
use indicatif::ProgressBar;
use rayon::prelude::*;

use crate::failure::Failure;
use crate::kind::Kind;
use crate::progress::{self, during};
use crate::shortest::shortest;
use crate::tally::Tally;

/// How many queries are read before they are answered, all at once.
const BATCH: usize = 4096;

/// The contact times of the queries in CSV files
///
/// A query is eight rows: its four points at t = 0, then the same at t = 1.
/// These are the vertex and the corners of the face, or the ends of the first
/// edge and those of the second. A row is the numerators and denominators of
/// x, y and z. In all rows or in none, a seventh column is the ground truth,
/// 1 for contact and 0 for none.
///
/// The answers are CSV, a row for each query:
///   query    its number, from 0, which runs on from one file to the next
///   contact  1 or 0
///   count    how many distinct contact times there are, -1 for an interval
///   toi      the earliest, rounded down to f64, as the shortest decimal that
///            reads back to it; empty if there is none
///
/// How many answers differ from the ground truth is told on standard error.
///
/// Exit status: 0 whatever the answers, 2 error. The queries before an error
/// are answered.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// A vertex against a face, or an edge against an edge.
    #[arg(long)]
    kind: Kind,
    /// Round coordinates that are not exactly f64 to the nearest, instead of refusing them.
    #[arg(long)]
    round_input: bool,
    /// The files; - is standard input.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    // Answers on the same terminal show progress enough.
    let bar = if io::stdout().is_terminal() {
        ProgressBar::hidden()
    } else {
        progress::queries()
    };
    let tally = during(bar, |progress| match arguments.kind {
        Kind::Vf => answer_all::<PointTriangle>(arguments, progress),
        Kind::Ee => answer_all::<SegmentSegment>(arguments, progress),
    });
    match tally {
        Ok(tally) => tally.report(),
        Err(failure) => failure.unless_closed_pipe()?,
    }
    Ok(ExitCode::SUCCESS)
}

fn answer_all<K: DataKind>(
    arguments: &Arguments,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Tally, Failure> {
    let rounding = if arguments.round_input {
        Rounding::ToNearest
    } else {
        Rounding::Refuse
    };
    let mut output = BufWriter::new(io::stdout().lock());
    writeln!(output, "query,contact,count,toi")?;
    let mut tally = Tally::default();
    let mut answer_file = |file: &PathBuf| {
        if file == Path::new("-") {
            let reader = QueryReader::<K, _>::new("standard input", io::stdin().lock(), rounding);
            answer(reader, &mut tally, &mut output, progress)
        } else {
            let reader = QueryReader::<K, _>::open(file, rounding)?;
            answer(reader, &mut tally, &mut output, progress)
        }
    };
    let answered = arguments.files.iter().try_for_each(&mut answer_file);
    let flushed = output.flush();
    answered?;
    flushed?;
    Ok(tally)
}

fn answer<K: DataKind>(
    mut reader: QueryReader<K, impl Read>,
    tally: &mut Tally,
    output: &mut impl Write,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<(), Failure> {
    loop {
        let mut read = Ok(());
        let or_stop = |sample: Result<_, _>| sample.map_err(|error| read = Err(error)).ok();
        let batch: Vec<Sample<K>> = reader.by_ref().take(BATCH).map_while(or_stop).collect();
        let answers: Vec<_> = batch
            .par_iter()
            .map(|sample| sample.query.contact_times())
            .collect();
        for (sample, times) in batch.iter().zip(&answers) {
            write_row(output, tally.queries(), times)?;
            tally.add(times.first().is_some(), sample.truth);
        }
        progress(batch.len());
        read?;
        if batch.len() < BATCH {
            return Ok(());
        }
    }
}

fn write_row(output: &mut impl Write, query: usize, times: &ContactTimes) -> io::Result<()> {
    let toi = times.first().map(ContactTime::lower);
    let count = times.count().map_or("-1".to_owned(), |count| count.to_string());
    let contact = u8::from(toi.is_some());
    writeln!(
        output,
        "{query},{contact},{count},{}",
        toi.map_or(String::new(), shortest)
    )
}
