//! `exact-ccd queries`: the contact times of the queries in CSV files.

use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use ccd_bench::{DataKind, QueryReader, Rounding, Sample};
use exact_ccd::{ContactTime, ContactTimes, PointTriangle, SegmentSegment};
use rayon::prelude::*;

use crate::failure::Failure;
use crate::shortest::shortest;

/// How many queries are read before they are answered, all at once.
const BATCH: usize = 4096;

/// The contact times of the queries in CSV files.
///
/// A query is eight rows, its four points at t = 0 and then at t = 1: the vertex and the corners of the face, or the
/// ends of the first edge and those of the second. A row is the numerators and denominators of x, y and z, and may end
/// in the ground truth, 1 for contact and 0 for none.
///
/// Prints a CSV row a query: `query`, its number from 0, which runs on from one file to the next; `contact`, 1 or 0;
/// `count`, the number of distinct contact times, -1 if contact lasts for an interval; `toi`, the time of impact
/// rounded down to f64, as the shortest decimal that reads back to it, or nothing. What differs from the ground truth
/// is counted on standard error. Exit status: 0 whatever the answers, 2 error; what comes before an error in the files
/// is answered.
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// What the queries are: a vertex against a face, or an edge against an edge.
    #[arg(long)]
    kind: Kind,
    /// Round coordinates that are not exactly f64 to the nearest, instead of refusing them.
    #[arg(long)]
    round_input: bool,
    /// The files; - is standard input.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Kind {
    /// A vertex against a face.
    Vf,
    /// An edge against an edge.
    Ee,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let tally = match arguments.kind {
        Kind::Vf => answer_all::<PointTriangle>(arguments),
        Kind::Ee => answer_all::<SegmentSegment>(arguments),
    };
    match tally {
        Ok(tally) => tally.report(),
        Err(failure) => failure.unless_closed_pipe()?,
    }
    Ok(ExitCode::SUCCESS)
}

fn answer_all<K: DataKind>(arguments: &Arguments) -> Result<Tally, Failure> {
    let rounding = if arguments.round_input {
        Rounding::ToNearest
    } else {
        Rounding::Refuse
    };
    let mut output = BufWriter::new(io::stdout().lock());
    let mut tally = Tally::default();
    writeln!(output, "query,contact,count,toi")?;
    for file in &arguments.files {
        if file == Path::new("-") {
            let reader = QueryReader::<K, _>::new("standard input", io::stdin().lock(), rounding);
            answer(reader, &mut tally, &mut output)?;
        } else {
            answer(
                QueryReader::<K, _>::open(file, rounding)?,
                &mut tally,
                &mut output,
            )?;
        }
    }
    output.flush()?;
    Ok(tally)
}

fn answer<K: DataKind>(
    mut reader: QueryReader<K, impl Read>,
    tally: &mut Tally,
    output: &mut impl Write,
) -> Result<(), Failure> {
    loop {
        let mut failed = None;
        let or_stop = |sample: Result<_, _>| sample.map_err(|error| failed = Some(error)).ok();
        let batch: Vec<Sample<K>> = reader.by_ref().take(BATCH).map_while(or_stop).collect();
        let answers: Vec<_> = batch
            .par_iter()
            .map(|sample| sample.query.contact_times())
            .collect();
        for (sample, times) in batch.iter().zip(&answers) {
            write_row(output, tally.queries, times)?;
            tally.add(times.first().is_some(), sample.truth);
        }
        match failed {
            Some(error) => {
                output.flush()?;
                return Err(error.into());
            }
            None if batch.len() < BATCH => return Ok(()),
            None => {}
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

/// Answers counted, and those among them that differ from the ground truth.
#[derive(Default)]
struct Tally {
    queries: usize,
    contacts: usize,
    judged: usize,
    false_positives: usize,
    false_negatives: usize,
}

impl Tally {
    fn add(&mut self, contact: bool, truth: Option<bool>) {
        self.queries += 1;
        self.contacts += usize::from(contact);
        self.judged += usize::from(truth.is_some());
        self.false_positives += usize::from(contact && truth == Some(false));
        self.false_negatives += usize::from(!contact && truth == Some(true));
    }

    /// Tells how the answers compare with the ground truth, if there is any.
    fn report(&self) {
        let Self {
            queries,
            contacts,
            judged,
            false_positives,
            false_negatives,
        } = self;
        if *judged == 0 {
            return;
        }
        let of = if judged == queries {
            String::new()
        } else {
            format!(" of {judged} of them")
        };
        // The answers are out: that nobody listens to the summary is no failure.
        let _ = writeln!(
            io::stderr(),
            "{queries} queries, {contacts} in contact; against the ground truth{of}: \
             {false_positives} false positives, {false_negatives} false negatives",
        );
    }
}
