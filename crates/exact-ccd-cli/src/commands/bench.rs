//! `exact-ccd bench`: methods against each other on the queries in a folder.

use std::cell::Cell;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use clap::value_parser;
use exact_ccd::{Ccd, Decide, EdgeEdge, VertexFace};
use exact_ccd_compare::{Comparison, Contestant, Peer, Report, Source, Table};
use exact_ccd_data::DataKind;
use exact_ccd_methods::UnknownMethod;

use crate::files::inputs::check_folder;
use crate::files::outputs::print;
use crate::messages::failure::Failure;
use crate::messages::progress::{self, during};
use crate::text::json::to_json;

/// Compare methods on the queries in a folder: time and wrong answers
///
/// The folder, or folders inside of it, have query files in `edge-edge` and
/// `vertex-face`, or `frames` of a mesh with the queried pairs in `boxes` and the
/// ground truth in `mma_bool`, as the published data sets do. Query files are two
/// data sets: as they are, and with each query shifted and rounded by itself.
/// Frames are two as well: the queried pairs, and the candidates of the broad
/// phase. The exact method replaces ground truth that is missing.
///
/// For each data set and kind, a table has a row for each method: the number of
/// queries that it answered, the mean time in microseconds of all (T), of those
/// that collide (TP) and of the others (TN), the 99th percentile and the longest
/// time, the numbers of false positives and of false negatives, and, of methods
/// with times of impact, their errors and the number of late ones.
///
/// Methods take turns on the same queries, on one thread. A method that has spent
/// its budget on a data set answers no more of it.
///
/// A peer is a program that answers queries through a pipe, in any language; see
/// docs/benchmark.md. A peer that fails, or is silent for a minute longer than its
/// budget, answers no more; the report has a note.
///
/// Exit status: 0 whatever the answers, 2 error, among them a peer that failed.
/// With --output, the report is written anew after each data set.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The folder.
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    #[arg(long, value_name = "NAME", value_delimiter = ',', help = method_help())]
    method: Vec<String>,
    /// The size of the random sample of each data set and kind. Half of it are queries in contact,
    /// if there are enough.
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = value_parser!(u32).range(2..))]
    sample: u32,
    /// The time that a method has for each data set and kind, in seconds.
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0, value_parser = budget)]
    budget: f64,
    /// A program whose methods take part; may be repeated.
    #[arg(long = "peer", value_name = "COMMAND")]
    peers: Vec<String>,
    /// Write the report to this folder, as Markdown, CSV and JSON, with plots.
    #[arg(long, short, value_name = "REPORT_DIR")]
    output: Option<PathBuf>,
    /// Print the report as a JSON object at the end, in place of the tables. docs/reports.md has its
    /// schema.
    #[arg(long)]
    json: bool,
}

fn method_help() -> String {
    let names = exact_ccd_methods::names().join(", ");
    format!(
        "A method that takes part, in upper or lower case, of {names} and those of --peer; may be repeated, or several \
         with commas between them [default: all]"
    )
}

/// The time that a peer has to start, and for an answer beyond its budget.
const GRACE: Duration = Duration::from_secs(60);

fn budget(text: &str) -> Result<f64, String> {
    let budget = text.parse().ok().filter(|budget| (1e-3..=1e6).contains(budget));
    budget.ok_or_else(|| "expected from 0.001 to 1000000 seconds".to_owned())
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    check_folder(&arguments.folder, "a folder of data sets")?;
    let sources = Source::all(&arguments.folder)?;
    if sources.is_empty() {
        return Err(no_data_set(&arguments.folder));
    }
    let contestants = contestants(arguments)?;
    let mut report = Report::new(&contestants);
    let mut comparison = Comparison::new(contestants, Duration::from_secs_f64(arguments.budget));
    let print_table = |text: &str| if arguments.json { Ok(()) } else { print(text) };
    print_table(&format!("{}\n", report.markdown().trim_end()))?;

    let bar = progress::thousandths(2 * 1000 * sources.len() as u64);
    during(bar, |progress| {
        let mut noted = 0;
        for source in &sources {
            for compare in [compare::<VertexFace>, compare::<EdgeEdge>] {
                let Some(table) = compare(&mut comparison, source, arguments.sample, progress)? else {
                    continue;
                };
                print_table(&table.markdown())?;
                for (name, error) in comparison.failures().skip(noted) {
                    let note = format!("{name} has failed and answers no more: {error}.");
                    print_table(&format!("{note}\n"))?;
                    report.notes.push(note);
                    noted += 1;
                }
                report.tables.push(table);
                if let Some(folder) = &arguments.output {
                    report
                        .write(folder)
                        .map_err(|source| Failure::write(folder, source))?;
                }
            }
        }
        Ok::<_, Failure>(())
    })?;
    if report.tables.is_empty() {
        return Err(no_data_set(&arguments.folder));
    }
    if arguments.json {
        print(&to_json("bench", &report))?;
    }
    comparison.finish()?;
    Ok(ExitCode::SUCCESS)
}

fn no_data_set(folder: &Path) -> Failure {
    Failure::of(
        folder,
        "expected folders `edge-edge` or `vertex-face` with .csv or .parquet files, \
         or `frames` with meshes",
    )
}

/// The chosen methods, including the peers' methods.
fn contestants(arguments: &Arguments) -> Result<Vec<Contestant>, Failure> {
    let mut contestants: Vec<_> = exact_ccd_methods::all()
        .into_iter()
        .map(Contestant::Method)
        .collect();
    for command in &arguments.peers {
        contestants.extend(Peer::start(command, GRACE)?.into_iter().map(Contestant::Peer));
    }
    for (index, contestant) in contestants.iter().enumerate() {
        let name = contestant.name();
        if contestants[..index]
            .iter()
            .any(|other| other.name().eq_ignore_ascii_case(name))
        {
            return Err(Failure::new(format_args!("there are two methods called {name}")));
        }
    }
    if arguments.method.is_empty() {
        return Ok(contestants);
    }
    let is = |name: &str, contestant: &Contestant| contestant.name().eq_ignore_ascii_case(name);
    for name in &arguments.method {
        if !contestants.iter().any(|contestant| is(name, contestant)) {
            let known = contestants.iter().map(|contestant| contestant.name().to_owned());
            let (name, known) = (name.clone(), known.collect());
            return Err(UnknownMethod { name, known }.into());
        }
    }
    contestants.retain(|contestant| arguments.method.iter().any(|name| is(name, contestant)));
    Ok(contestants)
}

/// The table of a data set and kind, if there are such queries. It is a thousand steps of progress.
fn compare<K: DataKind>(
    comparison: &mut Comparison,
    source: &Source,
    sample: u32,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Option<Table>, Failure>
where
    dyn Ccd: Decide<K>,
{
    let reported = Cell::new(0);
    let report = |done: f64| {
        let thousandths = (1000.0 * done) as usize;
        progress(thousandths.saturating_sub(reported.get()));
        reported.set(reported.get().max(thousandths));
    };
    let subjects = source.read::<K>(sample as usize / 2)?;
    let table = if subjects.population() == [0, 0] {
        None
    } else {
        Some(comparison.run(source.name(), &subjects, &report))
    };
    report(1.0);
    Ok(table)
}
