//! `exact-ccd convert`: query files from rows to columns and back.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use exact_ccd::{AnyKind, EdgeEdge, Kind, Separation, VertexFace, with_kind};
use exact_ccd_data::{DataKind, Record, RecordedStep, Rounding};
use exact_ccd_files::Format;
use rayon::prelude::*;
use serde::Serialize;

use crate::files::inputs::{check_folder, check_path};
use crate::files::outputs::{is_dash, print};
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};
use crate::options::distances;
use crate::options::kind;
use crate::query_files::method::answered;
use crate::query_files::recognise::kind_of;
use crate::query_files::rows::{self, BATCH, Records};
use crate::text::json::to_json;

/// Convert query files from rows to columns and back, without loss
///
/// An input is a CSV file as of `exact-ccd queries`, a file whose name ends in
/// .parquet, or the folder of a scene of the published data sets. All queries
/// go to one file, which is Parquet if its name ends in .parquet, else CSV.
///
/// Parquet has a row for each query, with these columns:
///   kind        vf, ee, ve or vv
///   points      a list of f64: x, y, z of the points at t = 0, then at t = 1;
///               24 for vf and ee, 18 for ve, 12 for vv
///   truth       the ground truth: true for contact
///   count       the number of distinct contact times, -1 for an interval
///   toi         the earliest, rounded down to f64
///   scene       the name of the scene
///   id_a, id_b  the ids of the two primitives in the scene, which count its
///               vertices, then its edges, then its faces
/// All but kind and points may be null. CSV files fill in truth only. A scene
/// fills in truth, scene and ids, and, if it has a folder `roots`, count and toi;
/// it has queries of the kinds vf and ee.
///
/// In Parquet, every f64 keeps its bits. A CSV file that is converted to Parquet
/// and back has the same bytes if it has the form that this program writes:
/// fractions in lowest terms with positive denominators, no blanks, LF at the
/// end of each row. CSV has no -0, which becomes 0, and none of the columns from
/// count on.
///
/// Exit status: 0 success, 2 error. An error leaves the output file unchanged.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// A vertex against a face, an edge against an edge, a vertex against an edge, or a vertex
    /// against a vertex [default: that of the files, if it is certain]
    #[arg(long, value_parser = kind::parser(AnyKind::ALL))]
    kind: Option<AnyKind>,
    /// Fill in count and toi of all queries, as computed by the exact method.
    #[arg(long)]
    answers: bool,
    /// With --answers, count primitives at most D apart as touching. If D is above 0, count is the
    /// number of maximal closed intervals of times within D, and toi the first such time.
    #[arg(long, value_name = "D", default_value = "0", requires = "answers", value_parser = distances::parse, allow_hyphen_values = true)]
    min_distance: Separation,
    /// The seventh column of CSV files, read or written, is the number of contact times instead of
    /// the ground truth: 0 or more, or -1 for infinitely many.
    #[arg(long)]
    roots: bool,
    /// The file to write; - is CSV on standard output.
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
    /// Print the numbers of queries as a JSON object. docs/reports.md has its schema.
    #[arg(long)]
    json: bool,
    /// Query files, with - for CSV on standard input, or folders of scenes.
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
}

/// The numbers of queries, in the shape of the JSON object.
#[derive(Default, Serialize)]
struct Report {
    output: String,
    kind: &'static str,
    /// The number of all queries.
    queries: usize,
    /// The numbers of queries with ground truth, in contact and free.
    colliding: usize,
    free: usize,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    if arguments.json && is_dash(&arguments.output) {
        return Err(Failure::new(
            "--json needs a file of --output: with -, standard output has the queries",
        ));
    }
    rows::check(&arguments.inputs, |input| {
        check_path(input, "a query file, CSV or Parquet, or the folder of a scene")
    })?;
    for input in &arguments.inputs {
        refuse_mesh(input)?;
    }
    let kind = kind_of(arguments.kind, &arguments.inputs, &mut Notes::default())?;
    let report = during(progress::count("queries"), |progress| match kind {
        AnyKind::VertexFace => convert::<VertexFace>(arguments, scene, progress),
        AnyKind::EdgeEdge => convert::<EdgeEdge>(arguments, scene, progress),
        _ => with_kind!(kind, K => convert::<K>(arguments, no_scene, progress)),
    })?;
    if arguments.json {
        print(&to_json("convert", &report))?;
    }
    Ok(ExitCode::SUCCESS)
}

/// Refuses a mesh, which has no queries.
fn refuse_mesh(input: &Path) -> Result<(), Failure> {
    match Format::of_path(input) {
        None => Ok(()),
        Some(_) => Err(Failure::of(
            input,
            "this is a mesh, and `convert` converts files of queries, from CSV to Parquet and back; `exact-ccd step` and \
             `exact-ccd audit` read meshes, and meshio or ParaView convert them",
        )),
    }
}

/// Converts queries of a kind; `scene` reads those of a scene.
fn convert<K: Kind>(
    arguments: &Arguments,
    scene: fn(&Path) -> Result<Records<K>, Failure>,
    progress: &(dyn Fn(usize) + Sync),
) -> Result<Report, Failure> {
    let seventh = rows::seventh(arguments.roots);
    let open = |input: &PathBuf| {
        let records = if input.is_dir() {
            scene(input)
        } else {
            rows::records(input, Rounding::Refuse, seventh)
        };
        records.unwrap_or_else(|failure| Box::new(std::iter::once(Err(failure))))
    };
    let mut records = arguments.inputs.iter().flat_map(open);
    let batches = std::iter::from_fn(|| {
        let batch: Vec<Result<Record<K>, Failure>> = records.by_ref().take(BATCH).collect();
        progress(batch.len());
        (!batch.is_empty()).then_some(batch)
    });
    let answered = batches.flat_map(|batch| {
        if arguments.answers {
            let d = arguments.min_distance;
            let answer = |record: Result<Record<K>, _>| record.map(|record| answered(record, d));
            batch.into_par_iter().map(answer).collect()
        } else {
            batch
        }
    });
    let mut report = Report {
        output: arguments.output.display().to_string(),
        kind: K::KIND.short(),
        ..Report::default()
    };
    let counted = answered.inspect(|record| {
        let truth = record.as_ref().ok().map(|record| record.sample.truth);
        report.queries += usize::from(truth.is_some());
        report.colliding += usize::from(truth == Some(Some(true)));
        report.free += usize::from(truth == Some(Some(false)));
    });
    rows::write(&arguments.output, seventh, counted)?;
    Ok(report)
}

/// The queries of a scene.
fn scene<K: DataKind>(folder: &Path) -> Result<Records<K>, Failure> {
    check_folder(
        &folder.join("frames"),
        "the frames of a scene of the published data sets",
    )?;
    let scene = RecordedStep::new(folder.to_owned());
    let motion = scene.motion()?;
    let records = scene.records(&motion.step()?)?;
    Ok(Box::new(records.into_iter().map(Ok)))
}

/// The error of a folder of queries of another kind than those of scenes.
fn no_scene<K: Kind>(folder: &Path) -> Result<Records<K>, Failure> {
    Err(Failure::of(
        folder,
        format_args!(
            "a folder is a scene, which has queries of the kinds vf and ee, not {}",
            K::KIND.short()
        ),
    ))
}
