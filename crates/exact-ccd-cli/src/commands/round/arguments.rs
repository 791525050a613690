//! The arguments of `exact-ccd round`.

use std::path::PathBuf;

use exact_ccd::AnyKind;

use crate::options::kind;

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
    pub(super) kind: Option<AnyKind>,
    /// Move each query by a displacement of its own.
    #[arg(long, requires = "kind")]
    pub(super) per_query: bool,
    /// Write the rounded input: all queries to one query file, a mesh to a PLY file, several meshes
    /// to PLY files of the same names in this folder. The ground truth of the queries is left out,
    /// because rounding can change it. A query file whose name ends in .parquet has the columns of
    /// `exact-ccd convert`.
    #[arg(long, short, value_name = "PATH")]
    pub(super) output: Option<PathBuf>,
    /// Write the number of contact times of each rounded query, -1 for an interval, as the seventh
    /// column of the query file, in place of the ground truth.
    #[arg(long, requires = "kind", requires = "output")]
    pub(super) roots: bool,
    /// Draw the histogram as an SVG file.
    #[arg(long, value_name = "FILE")]
    pub(super) plot: Option<PathBuf>,
    /// Print the report as a JSON object. docs/reports.md has its schema.
    #[arg(long)]
    pub(super) json: bool,
    /// Query files, with - for standard input, or mesh files. docs/files.md lists their formats.
    #[arg(required = true, value_name = "INPUT")]
    pub(super) inputs: Vec<PathBuf>,
}

/// The kinds of the queries that are rounded.
const KINDS: &[AnyKind] = &[AnyKind::VertexFace, AnyKind::EdgeEdge];
