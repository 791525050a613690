//! The arguments of `exact-ccd simulate`.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::value_parser;
use exact_ccd_sim::LineSearch;

use super::filters;
use super::lines::Lines;
use crate::view::View;

/// Simulate a scene: elastic bodies with contact and friction, without intersections
///
/// SCENE is a TOML file with bodies, materials, scripted motions and settings, or
/// a scene of another program as of `exact-ccd import`. The key `settings.ccd`
/// selects the method of continuous collision detection (CCD). The command prints
/// one line for the scene and one for each time step.
///
/// With --output, the command writes for each time step N
///   DIR/frames/N.ply     the surface
///   DIR/vtu/N.vtu        tetrahedra, triangles, rods, particles, velocities,
///                        bodies;
///                        DIR/motion.pvd opens all time steps in ParaView
///   DIR/contacts/N.vtp   the contacts as points, with distance, force and bodies;
///                        DIR/contacts.pvd opens all of them
///   DIR/bodies.csv       number, name, kind and vertices of each body
///   DIR/statistics.csv   a row with iterations, step sizes, contacts, minimal
///                        distance, energies and run times; column names end
///                        with units
///   DIR/checkpoint.json  the state for --resume, which replaces the previous one
/// An interrupted run continues with --resume from the last checkpoint: one is
/// written with the files of a time step, at most about once a second. On the same
/// machine, its results are identical to an uninterrupted run's. The results of an
/// earlier run in DIR are an error without --resume or --overwrite. Without
/// --output, only the files of --view and --dump-queries are written.
///
/// Ctrl-C ends the run after the last complete time step, which is saved, and
/// prints the command that continues it; a second Ctrl-C ends the process at once.
///
/// Exit status: 0 success, 2 error, 130 after Ctrl-C. With --strict, a time step
/// that does not converge is an error.
#[derive(clap::Args)]
#[command(verbatim_doc_comment, mut_arg("view_up", |up| up.help(UP)))]
pub(crate) struct Arguments {
    /// The scene, a .toml file or one of another program.
    pub(super) scene: PathBuf,
    /// Write the results to this folder.
    #[arg(long, short, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// The folder of the mesh files, by default the folder of the scene file.
    #[arg(long, value_name = "DIR")]
    pub(super) meshes: Option<PathBuf>,
    #[arg(long, value_name = "NAME", help = method_help())]
    pub(super) method: Option<String>,
    /// The line search, in place of the scene's: one step size for all vertices, or one for each vertex.
    #[arg(long, value_name = "NAME", value_parser = line_search())]
    pub(super) line_search: Option<LineSearch>,
    /// The number of the last time step, in place of the scene's duration. It counts from the start, also
    /// with --resume.
    #[arg(long, value_name = "N")]
    pub(super) steps: Option<u64>,
    /// Write the surface after each Newton step, as `path/STEP-INCREMENT.ply`. These increments are free of
    /// contact, and `exact-ccd audit DIR/path` certifies it. The straight motion from one time step to the
    /// next may have contacts. With --resume, a path in DIR is continued in any case.
    #[arg(long, requires = "output")]
    pub(super) path: bool,
    /// Draw each time step as `pictures/N.png`, and at the end all as the animations `motion.png` and
    /// `motion.gif`; plot `energies.svg` and `minimal-distance.svg`. With --resume, earlier time steps are
    /// included. The table `[render]` of the scene has the settings.
    #[arg(long, requires = "output")]
    pub(super) render: bool,
    /// Write the CCD queries as a data set for `exact-ccd bench` and `exact-ccd queries`. For each time step
    /// N, the folder gets `vertex-face/N.csv` and `edge-edge/N.csv`, with the exact answer in the last
    /// column, and a row of `counts.csv`. The queries are all pairs of primitives whose boxes overlap in a
    /// step that the line search proposes or takes. Queries of an earlier run in the folder are an error
    /// without --resume or --overwrite.
    #[arg(long, value_name = "DIR")]
    pub(super) dump_queries: Option<PathBuf>,
    /// The maximal number of queries in contact, and of queries without contact, to write for each kind and
    /// time step. They are drawn at random.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1000,
        requires = "dump_queries",
        value_parser = value_parser!(u32).range(1..)
    )]
    pub(super) dump_most: u32,
    /// Continue from the checkpoint in the folder of --output, which must belong to this scene.
    #[arg(long, requires = "output", conflicts_with = "overwrite")]
    pub(super) resume: bool,
    /// Replace the results of an earlier run in the folder of --output.
    #[arg(long, requires = "output")]
    pub(super) overwrite: bool,
    /// Write files for every Nth time step only, and for the last one. `statistics.csv` has all time steps.
    #[arg(long, value_name = "N", requires = "output", default_value_t = 1, value_parser = value_parser!(u64).range(1..))]
    pub(super) every: u64,
    /// End with an error after a time step in which Newton's method did not converge.
    #[arg(long)]
    pub(super) strict: bool,
    #[command(flatten)]
    pub(super) lines: Lines,
    #[command(flatten)]
    pub(super) view: View,
}

/// The help of `--view-up`. The default is the scene's direction.
const UP: &str = "The direction upwards on that page: x, y, z, -x, -y, -z, or three numbers [default: `up` of the \
                  scene's table `[render]`, or else opposite to gravity, or y without gravity]";

/// The parser of the names of line searches.
fn line_search() -> impl TypedValueParser<Value = LineSearch> {
    PossibleValuesParser::new(["common", "vertex"]).map(|name| match name.as_str() {
        "vertex" => LineSearch::Vertex,
        _ => LineSearch::Common,
    })
}

fn method_help() -> String {
    let names = filters::names().join(", ");
    format!("The method, in upper or lower case, in place of that of the scene: {names}")
}

impl Arguments {
    /// Returns true if anything is written to files.
    pub(super) fn has_files(&self) -> bool {
        self.output.is_some() || self.dump_queries.is_some() || self.view.file().is_some()
    }
}
