//! `exact-ccd queries`: the contacts of the queries in files, by any method.

mod answer_rows;
mod curved;
mod tally;

use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use exact_ccd::{AnyKind, EdgeEdge, Kind, Query, Separation, VertexFace, with_kind};
use exact_ccd_data::{Rounding, Sample};
use exact_ccd_methods::parity::RoundingError;
use indicatif::ProgressBar;
use rayon::prelude::*;

use crate::files::inputs::check_file;
use crate::files::outputs::Output;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};
use crate::options::distances;
use crate::query_files::method::{Answer, Method};
use crate::query_files::recognise::{kind_of, no_queries};
use crate::query_files::rows::{self, BATCH};
use crate::view::QueryView;
use answer_rows::AnswerRows;
use tally::Tally;

/// Decide the queries in files, by the exact method or another one
///
/// A query is a row for each of its points at t = 0, then the same at t = 1.
/// The points are, by the kind of the queries,
///   vf  the vertex and the corners of the face: eight rows
///   ee  the ends of the first edge, then of the second: eight rows
///   ve  the vertex and the ends of the edge: six rows
///   vv  the two vertices: four rows
/// A row is the numerators and denominators of x, y and z, six columns; or x, y
/// and z, each a decimal such as 0.1, which stands for the nearest f64, a
/// hexadecimal float such as 0x1.8p-3, or a fraction such as 3/16. In all rows or
/// in none, one more column is the ground truth, 1 for contact and 0 for none.
/// Files whose names end in .parquet have the columns of `exact-ccd convert`
/// instead.
///
/// Files whose names end in .jsonl have queries of curved motion, a JSON object
/// on each line: Bezier curves, or rigid bodies and chains of them.
/// docs/curved-motion.md has the format. They are answered by the exact method.
///
/// Without --kind, the kind is that of the folder, such as vertex-face, of
/// the column kind of a Parquet file, or the only one whose queries fill the rows
/// of a file, which is noted. If it is not certain, that is an error. A --kind that
/// is not that of the folder is noted.
///
/// The answers are CSV, a row for each query:
///   query    the number of the query, from 0, over all files
///   contact  1 or 0
///   count    the number of distinct contact times, -1 for an interval
///   toi      the earliest, rounded down to f64, as the shortest decimal that
///            reads back to it; empty if there is none
///
/// With --min-distance D, primitives at most D apart are in contact. If D is
/// above 0, count is the number of maximal closed intervals of contact times.
/// D is the f64 nearest to the number given, and the distance of the primitives
/// is compared with it exactly.
///
/// Two methods count the parity of the number of contacts, as in the paper
/// "Fast and Exact Root Parity for Continuous Collision Detection" (2022):
/// parity shifts and rounds each query, parity-rational computes in integers.
/// They do not distinguish two contacts from none. Their toi is empty, and
///   contact  is 0 for even, 1 for odd and boundary
///   count    is even, odd, or boundary for a contact at t = 0 or t = 1, with
///            an edge of the face, or with an end of an edge
///
/// The other methods are the same as in `exact-ccd bench`. Their count is empty,
/// and so is the toi if the method has no times. Only the exact method has the
/// kinds ve and vv, and distances above 0.
///
/// If there is ground truth, the numbers of false positives and of false
/// negatives go to standard error.
///
/// With --json, each answer is a JSON object on a line, with the same names.
///
/// Exit status: 0 whatever the answers, 2 error, among them an input without a
/// query. The queries before an error are answered.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// A vertex against a face, an edge against an edge, a vertex against an edge, or a vertex
    /// against a vertex [default: that of the files, if it is certain]
    #[arg(long, value_parser = crate::options::kind::parser(AnyKind::ALL))]
    kind: Option<AnyKind>,
    /// Count primitives at most D apart as touching, in the unit of the coordinates.
    #[arg(long, value_name = "D", default_value = "0", value_parser = distances::parse, allow_hyphen_values = true)]
    min_distance: Separation,
    #[arg(long, default_value = "exact", help = Method::help())]
    method: Method,
    /// Round coordinates that are not exactly f64 to the nearest, instead of refusing them.
    #[arg(long)]
    round_input: bool,
    /// Print JSON lines in place of CSV. docs/reports.md has their schema.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    output: Output,
    #[command(flatten)]
    view: QueryView,
    /// The files; - is standard input.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    // A bar and answers on the same terminal would overwrite each other.
    let bar = if io::stdout().is_terminal() {
        ProgressBar::hidden()
    } else {
        progress::count("queries")
    };
    let (method, d) = (&arguments.method, arguments.min_distance);
    rows::check(&arguments.files, |file| {
        check_file(file, "a query file, CSV or Parquet")
    })?;
    arguments.output.check(&arguments.files)?;
    let kind = if curved::are_curved(&arguments.files)? {
        curved::check(arguments)?;
        None
    } else {
        let kind = kind_of(arguments.kind, &arguments.files, &mut Notes::default())?;
        method.check(kind, d)?;
        Some(kind)
    };
    let tally = during(bar, |progress| {
        arguments.output.stream(|output| {
            let mut run = Run {
                arguments,
                output: AnswerRows::new(output, arguments.json)
                    .map_err(|source| arguments.output.failed(source))?,
                tally: Tally::default(),
                progress,
            };
            match kind {
                None => curved::answer_all(&mut run),
                Some(AnyKind::VertexFace) => run.answer_all::<VertexFace>(&|query| method.answer(query, d)),
                Some(AnyKind::EdgeEdge) => run.answer_all::<EdgeEdge>(&|query| method.answer(query, d)),
                Some(kind) => {
                    with_kind!(kind, K => run.answer_all::<K>(&|query| Ok(Answer::exact(query, d))))
                }
            }?;
            if run.tally.queries() == 0 {
                return Err(no_queries());
            }
            Ok(run.tally)
        })
    });
    match tally {
        Ok(tally) => tally.report(),
        Err(failure) => failure.unless_closed_pipe()?,
    }
    Ok(ExitCode::SUCCESS)
}

/// The decision of one query.
type Decision<'a, K> = &'a (dyn Fn(&Query<K>) -> Result<Answer, RoundingError> + Sync);

/// The answers so far.
struct Run<'a, W> {
    arguments: &'a Arguments,
    output: AnswerRows<W>,
    tally: Tally,
    progress: &'a (dyn Fn(usize) + Sync),
}

impl<W: Write> Run<'_, W> {
    fn answer_all<K: Kind + 'static>(&mut self, decide: Decision<'_, K>) -> Result<(), Failure> {
        let rounding = if self.arguments.round_input {
            Rounding::ToNearest
        } else {
            Rounding::Refuse
        };
        let mut choice = self.arguments.view.choice();
        for file in &self.arguments.files {
            let samples = rows::open::<K>(file, rounding)?;
            let named = rows::name(file);
            let see = &mut |query, sample: &Sample<K>, collides| {
                choice.see(named, query, &sample.query, collides);
            };
            self.answer(
                named,
                samples,
                &|sample| decide(&sample.query),
                &|sample| sample.truth,
                see,
            )?;
        }
        choice.finish(self.arguments.min_distance)
    }

    /// Answers the queries of a file in batches. `see` takes the number of each query, the query, and true
    /// for contact.
    fn answer<T: Sync>(
        &mut self,
        file: &Path,
        mut queries: impl Iterator<Item = Result<T, Failure>>,
        decide: &(impl Fn(&T) -> Result<Answer, RoundingError> + Sync),
        truth: &impl Fn(&T) -> Option<bool>,
        see: &mut impl FnMut(usize, &T, bool),
    ) -> Result<(), Failure> {
        let first = self.tally.queries();
        loop {
            let mut read = Ok(());
            let or_stop = |query: Result<_, _>| query.map_err(|error| read = Err(error)).ok();
            let batch: Vec<T> = queries.by_ref().take(BATCH).map_while(or_stop).collect();
            let answers: Vec<_> = batch.par_iter().map(decide).collect();
            for (query, answer) in batch.iter().zip(answers) {
                let number = self.tally.queries();
                let answer = answer.map_err(|source| rows::failed(file, number - first, source))?;
                self.output
                    .write(number, &answer)
                    .map_err(|source| self.arguments.output.failed(source))?;
                self.tally.add(answer.collides, truth(query));
                see(number, query, answer.collides);
            }
            (self.progress)(batch.len());
            read?;
            if batch.len() < BATCH {
                return Ok(());
            }
        }
    }
}
