//! `exact-ccd round`: queries and meshes shifted and rounded, so that differences of coordinates are exact.

mod histogram;
mod meshes;
mod plot;
mod queries;
mod report;

use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

use exact_ccd::{AnyKind, EdgeEdge, VertexFace};
use exact_ccd_mesh::Aabb;
use exact_ccd_methods::parity::{Displacement, RoundingError};

use crate::files::inputs::check_file;
use crate::files::outputs::{check_is_no_input, print, write_file};
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};
use crate::options::kind;
use crate::query_files::recognise::note_other_folders;
use crate::query_files::rows;
use crate::text::json::to_json;

/// Shift and round queries or meshes, so that differences of coordinates are exact
///
/// The parity of the number of contacts is counted on differences of
/// coordinates, which must be exact f64. Section 4.2 of the paper "Fast and
/// Exact Root Parity for Continuous Collision Detection" (2022) makes them so:
/// along each axis, every coordinate x becomes fl(x + e), which is x + e rounded
/// to f64. The displacement e is 0 along an axis where the differences are exact.
///
/// As in the paper, a data set or a simulation is moved as a whole: there is
/// one displacement for all files, which follows from the box around them.
///
/// The output is the displacement and the histogram of the rounding errors
/// |x + e - fl(x + e)| of all coordinates: the number of zeros, and the number
/// in each decade, from one power of ten to the next. The errors are exact.
///
/// Exit status: 0 success, 2 error.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The files are query files of this kind, a vertex against a face or an edge against an edge;
    /// without it, they are meshes.
    #[arg(long, value_parser = kind::parser(KINDS))]
    kind: Option<AnyKind>,
    /// Move each query by a displacement of its own.
    #[arg(long, requires = "kind")]
    per_query: bool,
    /// Write the rounded input: all queries to one query file, a mesh to a PLY file, several meshes
    /// to PLY files of the same names in this folder. The ground truth of the queries is left out,
    /// because rounding can change it. A query file whose name ends in .parquet has the columns of
    /// `exact-ccd convert`.
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
    /// Write the number of contact times of each rounded query, -1 for an interval, as the seventh
    /// column of the query file, in place of the ground truth.
    #[arg(long, requires = "kind", requires = "output")]
    roots: bool,
    /// Draw the histogram as an SVG file.
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Print the report as a JSON object. docs/reports.md has its schema.
    #[arg(long)]
    json: bool,
    /// Query files, with - for standard input, or mesh files. docs/files.md lists their formats.
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
}

/// The kinds for which parity is defined.
/// The kinds of the queries that are rounded.
const KINDS: &[AnyKind] = &[AnyKind::VertexFace, AnyKind::EdgeEdge];

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    rows::check(&arguments.inputs, |input| {
        check_file(input, "a mesh file, or a query file with --kind")
    })?;
    // A mesh can take the place of its input. A query file would lose its answers.
    let output = arguments.output.iter().filter(|_| arguments.kind.is_some());
    for file in output.chain(&arguments.plot) {
        check_is_no_input(file, &arguments.inputs)?;
    }
    if let Some(kind) = arguments.kind {
        note_other_folders(kind, &arguments.inputs, &mut Notes::default());
    }
    let report = during(progress::stage("rounding"), |_| match arguments.kind {
        None => meshes::round(arguments),
        Some(AnyKind::VertexFace) => queries::round::<VertexFace>(arguments),
        Some(_) => queries::round::<EdgeEdge>(arguments),
    })?;
    if let Some(file) = &arguments.plot {
        let drawing = plot::svg(&report.errors);
        write_file(file, |writer| writer.write_all(drawing.as_bytes()))?;
    }
    let text = if arguments.json {
        to_json("round", &report)
    } else {
        report.to_string()
    };
    print(&text)?;
    Ok(ExitCode::SUCCESS)
}

/// The displacement for all points in a box, which may be empty. None overflows, because rounding is
/// monotone and the corners do not.
fn shared_displacement(bounds: &Aabb) -> Result<Displacement, RoundingError> {
    if *bounds == Aabb::EMPTY {
        return Ok(Displacement::default());
    }
    let displacement = Displacement::of_box(bounds.lower, bounds.upper);
    displacement.apply_to_all(&[bounds.lower, bounds.upper])?;
    Ok(displacement)
}
