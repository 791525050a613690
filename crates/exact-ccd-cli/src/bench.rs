//! `exact-ccd bench`: methods against each other on the queries in a folder.

use std::cell::Cell;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

use clap::value_parser;
use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_bench::DataKind;
use exact_ccd_bench::comparison::{Comparison, Contestant, Peer, Report, Source, Table};

use crate::failure::Failure;
use crate::output::print;
use crate::progress::{self, during};

/// Methods against each other on the queries in a folder: time and wrong answers
///
/// The folder, or folders inside of it, have query files in `edge-edge` and
/// `vertex-face`, or `frames` of a mesh with the queried pairs in `boxes` and the
/// truth on them in `mma_bool`, as the published data sets do. Query files are
/// also asked rounded, each query by itself, and frames also for the candidates of
/// the broad phase. The truth is in the files; where it is not, and for the times
/// of impact, it is the answer of the exact method.
///
/// For each data set and kind, a table has a row for each method: how many queries
/// it answered, the mean time in microseconds (T) of all, of those that collide
/// (TP) and of the others (TN), the time that 99 % take at most and the longest,
/// false positives and false negatives, and, of methods that tell times of impact,
/// how far these are from the true ones and how many are after them.
///
/// Methods take turns on the same queries, on one thread. One that has spent its
/// budget on a data set leaves; the table says how many queries it answered.
///
/// A peer is a program that answers queries through a pipe, in any language; see
/// docs/benchmark.md.
///
/// Exit status: 0 whatever the answers, 2 error. With --out, the report is written
/// anew after each data set.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The folder.
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Ask only these, separated by commas; if not given, all.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    methods: Vec<String>,
    /// Ask a random sample of at most this many queries of each data set and kind, half of them in contact if there are
    /// as many.
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = value_parser!(u32).range(2..))]
    sample: u32,
    /// How long a method may take for each data set and kind, in seconds.
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0, value_parser = budget)]
    budget: f64,
    /// Ask the methods of another program too; may be repeated.
    #[arg(long = "peer", value_name = "COMMAND")]
    peers: Vec<String>,
    /// Write the report to this folder, as Markdown, CSV and JSON, with plots.
    #[arg(long, value_name = "REPORT_DIR")]
    out: Option<PathBuf>,
}

fn budget(text: &str) -> Result<f64, String> {
    let budget = text.parse().ok().filter(|budget| (1e-3..=1e6).contains(budget));
    budget.ok_or_else(|| "expected from 0.001 to 1000000 seconds".to_owned())
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let sources = Source::all(&arguments.folder)?;
    if sources.is_empty() {
        return Err(Failure::NoDataSet(arguments.folder.clone()));
    }
    let contestants = contestants(arguments)?;
    let mut report = Report::new(&contestants);
    let mut comparison = Comparison::new(contestants, Duration::from_secs_f64(arguments.budget));
    print(&format!("{}\n", report.markdown().trim_end()))?;

    let bar = progress::thousandths(2 * 1000 * sources.len() as u64);
    during(bar, |progress| {
        for source in &sources {
            for kind in [compare::<VertexFace>, compare::<EdgeEdge>] {
                let Some(table) = kind(&mut comparison, source, arguments.sample, progress)? else {
                    continue;
                };
                print(&table.markdown())?;
                report.tables.push(table);
                if let Some(folder) = &arguments.out {
                    report
                        .write(folder)
                        .map_err(|source| Failure::write(folder, source))?;
                }
            }
        }
        Ok(ExitCode::SUCCESS)
    })
}

/// The methods that were asked for, and the peers.
fn contestants(arguments: &Arguments) -> Result<Vec<Contestant>, Failure> {
    let mut contestants: Vec<_> = exact_ccd_methods::all()
        .into_iter()
        .map(Contestant::Method)
        .collect();
    for command in &arguments.peers {
        contestants.extend(Peer::start(command)?.into_iter().map(Contestant::Peer));
    }
    for (index, contestant) in contestants.iter().enumerate() {
        let name = contestant.name();
        if contestants[..index]
            .iter()
            .any(|other| other.name().eq_ignore_ascii_case(name))
        {
            return Err(Failure::SameMethod(name.to_owned()));
        }
    }
    if arguments.methods.is_empty() {
        return Ok(contestants);
    }
    let is = |name: &str, contestant: &Contestant| contestant.name().eq_ignore_ascii_case(name);
    for name in &arguments.methods {
        if !contestants.iter().any(|contestant| is(name, contestant)) {
            return Err(Failure::Method {
                name: name.clone(),
                known: contestants
                    .iter()
                    .map(|contestant| contestant.name().to_owned())
                    .collect(),
            });
        }
    }
    contestants.retain(|contestant| arguments.methods.iter().any(|name| is(name, contestant)));
    Ok(contestants)
}

/// The table of a data set and kind, if there are any such queries; it is a thousand steps of progress.
fn compare<K: DataKind>(
    comparison: &mut Comparison,
    source: &Source,
    sample: u32,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Option<Table>, Failure> {
    let told = Cell::new(0);
    let tell = |done: f64| {
        let thousandths = (1000.0 * done) as usize;
        progress(thousandths.saturating_sub(told.get()));
        told.set(told.get().max(thousandths));
    };
    let subjects = source.read::<K>(sample as usize / 2)?;
    let table = if subjects.population() == [0, 0] {
        None
    } else {
        Some(comparison.run(source.name(), &subjects, &tell)?)
    };
    tell(1.0);
    Ok(table)
}
