//! `exact-ccd simulate`: the intersection-free simulation of a scene.

mod drawings;
mod filters;
mod folder;
mod interrupt;
mod iterations;
mod lines;
mod queries;

use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::value_parser;
use exact_ccd_scene::Scene;
use exact_ccd_sim::{LineSearch, Settings, Simulation, SimulationError, System};

use crate::files::inputs::check_file;
use crate::files::outputs::print;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
use crate::messages::progress::{self, during};
use crate::text::json::to_json;
use crate::view::View;
use drawings::pictures::Pictures;
use folder::OutputFolder;
use lines::convergence::Convergence;
use queries::QueryFolder;

/// Simulate a scene: elastic bodies with contact and friction, without intersections
///
/// SCENE is a TOML file with bodies, materials, scripted motions and settings, or a scene of
/// another program as of `exact-ccd import`. The key
/// `settings.ccd` selects the method of continuous collision detection (CCD). The
/// command prints one line for the scene and one for each time step.
///
/// With --output, the command writes for each time step N
///   DIR/frames/N.ply     the surface
///   DIR/vtu/N.vtu        tetrahedra, triangles, rods, particles, velocities, bodies;
///                        DIR/motion.pvd opens all time steps in ParaView
///   DIR/contacts/N.vtp   the contacts as points, with distance, force and bodies;
///                        DIR/contacts.pvd opens all of them
///   DIR/bodies.csv       number, name, kind and vertices of each body
///   DIR/statistics.csv   a row with iterations, step sizes, contacts, minimal distance,
///                        energies and run times; column names end with units
///   DIR/checkpoint.json  the state for --resume, which replaces the previous one
/// An interrupted run continues with --resume from the last checkpoint: one is written with the files of a
/// time step, at most about once a second. On the same machine, its results are identical to an
/// uninterrupted run's. The results of an earlier run in DIR are an error without --resume
/// or --overwrite. Without --output, only the files of --view and --dump-queries are written.
///
/// Ctrl-C ends the run after the last complete time step, which is saved, and prints the
/// command that continues it; a second Ctrl-C ends the process at once.
///
/// Exit status: 0 success, 2 error, 130 after Ctrl-C. With --strict, a time step that does not converge is an
/// error.
#[derive(clap::Args)]
#[command(verbatim_doc_comment, mut_arg("view_up", |up| up.help(UP)))]
pub(crate) struct Arguments {
    /// The scene, a .toml file or one of another program.
    scene: PathBuf,
    /// Write the results to this folder.
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
    /// The folder of the mesh files, by default the folder of the scene file.
    #[arg(long, value_name = "DIR")]
    meshes: Option<PathBuf>,
    #[arg(long, value_name = "NAME", help = method_help())]
    method: Option<String>,
    /// The line search, in place of the scene's: one step size for all vertices, or one for each vertex.
    #[arg(long, value_name = "NAME", value_parser = ["common", "vertex"])]
    line_search: Option<String>,
    /// The number of the last time step, in place of the scene's duration. It counts from the start, also
    /// with --resume.
    #[arg(long, value_name = "N")]
    steps: Option<u64>,
    /// Write the surface after each Newton step, as `path/STEP-INCREMENT.ply`. These increments are free of
    /// contact, and `exact-ccd audit DIR/path` certifies it. The straight motion from one time step to the
    /// next may have contacts. With --resume, a path in DIR is continued in any case.
    #[arg(long, requires = "output")]
    path: bool,
    /// Draw each time step as `pictures/N.png`, and at the end all as the animations `motion.png` and
    /// `motion.gif`; plot `energies.svg` and `minimal-distance.svg`. With --resume, earlier time steps are
    /// included. The table `[render]` of the scene has the settings.
    #[arg(long, requires = "output")]
    render: bool,
    /// Write the CCD queries as a data set for `exact-ccd bench` and `exact-ccd queries`. For each time step
    /// N, the folder gets `vertex-face/N.csv` and `edge-edge/N.csv`, with the exact answer in the last
    /// column, and a row of `counts.csv`. The queries are all pairs of primitives whose boxes overlap in a
    /// step that the line search proposes or takes. Queries of an earlier run in the folder are an error
    /// without --resume or --overwrite.
    #[arg(long, value_name = "DIR")]
    dump_queries: Option<PathBuf>,
    /// The maximal number of queries in contact, and of queries without contact, to write for each kind and
    /// time step. They are drawn at random.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1000,
        requires = "dump_queries",
        value_parser = value_parser!(u32).range(1..)
    )]
    dump_most: u32,
    /// Continue from the checkpoint in the folder of --output, which must belong to this scene.
    #[arg(long, requires = "output", conflicts_with = "overwrite")]
    resume: bool,
    /// Replace the results of an earlier run in the folder of --output.
    #[arg(long, requires = "output")]
    overwrite: bool,
    /// Write files for every Nth time step only, and for the last one. `statistics.csv` has all time steps.
    #[arg(long, value_name = "N", requires = "output", default_value_t = 1, value_parser = value_parser!(u64).range(1..))]
    every: u64,
    /// End with an error after a time step in which Newton's method did not converge.
    #[arg(long)]
    strict: bool,
    /// Print a JSON object in place of each line of text. docs/reports.md has its schema.
    #[arg(long)]
    json: bool,
    /// Leave the durations out, so that the lines have the same bytes each time.
    #[arg(long)]
    no_seconds: bool,
    #[command(flatten)]
    view: View,
}

/// The help of `--view-up`. The default is the scene's direction.
const UP: &str = "The direction upwards on that page: x, y, z, -x, -y, -z, or three numbers [default: `up` of the \
                  scene's table `[render]`, or else opposite to gravity, or y without gravity]";

fn method_help() -> String {
    let names = filters::names().join(", ");
    format!("The method, in upper or lower case, in place of that of the scene: {names}")
}

impl Arguments {
    /// Returns true if anything is written to files.
    fn has_files(&self) -> bool {
        self.output.is_some() || self.dump_queries.is_some() || self.view.file().is_some()
    }
}

/// The end of the time steps.
enum Ended {
    Complete,
    /// By Ctrl-C.
    Interrupted,
    /// By a time step that failed, or did not converge although it must.
    Failed(Failure),
}

/// Runs the command. `command` is the program with its arguments if it is a process of its own, in which
/// Ctrl-C can be handled.
pub(crate) fn run(arguments: &Arguments, command: Option<&[OsString]>) -> Result<ExitCode, Failure> {
    check_file(&arguments.scene, "a scene in TOML, or one of IPC or of PolyFEM")?;
    if let Some(name) = &arguments.method {
        filters::check(name)?;
    }
    let by_name = |settings: &mut Settings, system: &System| {
        match arguments.line_search.as_deref() {
            Some("common") => settings.line_search = LineSearch::Common,
            Some("vertex") => settings.line_search = LineSearch::Vertex,
            _ => {}
        }
        let name = arguments.method.as_deref().unwrap_or(&settings.ccd);
        filters::by_name(name, system).map_err(|error| error.to_string())
    };
    let scene = Scene::read(&arguments.scene, arguments.meshes.as_deref(), &by_name)?;
    if let Some(folder) = &arguments.dump_queries
        && !arguments.resume
        && !arguments.overwrite
    {
        QueryFolder::check_is_new(folder)?;
    }
    let mut notes = Notes::default();
    scene.notes.iter().for_each(|text| notes.note(text.to_string()));
    scene.mesh_notes.iter().for_each(|text| notes.note(text.clone()));
    let (simulation, mut folder) = open(&scene, arguments)?;
    let most = arguments.dump_most as usize;
    let (mut simulation, mut queries) = match &arguments.dump_queries {
        None => (simulation, None),
        Some(folder) => {
            let (simulation, queries) = QueryFolder::open(folder, simulation, most)?;
            (simulation, Some(queries))
        }
    };

    let steps = arguments.steps.unwrap_or(scene.steps);
    let remaining = steps.saturating_sub(simulation.state().step);
    let scene_line = lines::text::of_scene(&simulation, steps, arguments.has_files());
    if arguments.json {
        print(&lines::json::of_scene(&simulation, steps))?;
    } else {
        print(&scene_line)?;
    }
    if simulation.state().step == 0 {
        let warnings = simulation.warnings();
        warnings
            .iter()
            .for_each(|warning| notes.warn(warning.to_string()));
    }
    let text_of_page = format!(
        "{}\n{}",
        lines::text::lengths(&simulation),
        lines::text::time_steps(&simulation, steps)
    );
    let mut recording = arguments
        .view
        .simulation(&arguments.scene, &simulation, &scene.rendering);
    recording.add_state(&simulation, None)?;
    let mut pictures = match folder.as_ref().filter(|_| arguments.render) {
        None => None,
        Some(folder) => Some(Pictures::begin(folder, &simulation, scene.rendering)?),
    };
    let mut convergence = Convergence::default();
    if command.is_some() {
        simulation = simulation.with_interrupt(interrupt::flag());
    }
    let bar = progress::bar(usize::try_from(remaining).unwrap_or(usize::MAX), "time steps");
    let lines = bar.clone();
    simulation = iterations::watched(simulation, &bar);
    let ended = during(bar, |progress| -> Result<Ended, Failure> {
        while simulation.state().step < steps {
            let mut path = folder
                .as_ref()
                .and_then(|folder| folder.path(&scene.system, simulation.state()));
            let stepped = simulation.step_along(&mut |positions| {
                if let Some(path) = &mut path {
                    path.add(positions);
                }
            });
            if matches!(stepped, Err(SimulationError::Interrupted { .. })) && command.is_some() {
                return Ok(Ended::Interrupted);
            }
            let statistics = match stepped {
                Ok(statistics) => statistics,
                Err(error) => return Ok(Ended::Failed(Failure::of(&arguments.scene, error))),
            };
            let path = path.map_or_else(|| Ok(Vec::new()), folder::path::NewtonPath::finish)?;
            if let Some(queries) = &mut queries {
                queries.add(statistics.step)?;
            }
            recording.add_state(&simulation, Some(&statistics))?;
            if let Some(folder) = &mut folder {
                let is_last = statistics.step == steps || arguments.strict && !statistics.converged;
                folder.add(&simulation, &statistics, path, is_last)?;
                if let Some(pictures) = &mut pictures {
                    pictures.add(folder)?;
                }
            }
            let line = if arguments.json {
                lines::json::of(&statistics, arguments.no_seconds)
            } else {
                lines::text::of(&statistics, arguments.no_seconds)
            };
            // The progress bar is hidden while the line is printed.
            lines.suspend(|| print(&line))?;
            progress(1);
            convergence.add(&statistics);
            if !statistics.converged && arguments.strict {
                return Ok(Ended::Failed(Failure::new(format_args!(
                    "time step {} did not converge, expected convergence with --strict: {}",
                    statistics.step,
                    convergence.remedy()
                ))));
            }
        }
        Ok(Ended::Complete)
    });
    let ended = ended?;
    let distance = simulation.settings().contact_distance;
    let distance = distance.meters(simulation.system().size());
    let verdict = match &ended {
        Ended::Failed(failure) => failure.on_one_line(),
        _ => {
            let left = steps.saturating_sub(simulation.state().step);
            convergence.text(remaining.saturating_sub(left))
        }
    };
    let finish = || -> Result<(), Failure> {
        if !matches!(ended, Ended::Complete)
            && let Some(folder) = &mut folder
        {
            folder.finish(&simulation)?;
        }
        recording.finish(&verdict, &text_of_page, distance)
    };
    let finished = finish();
    match (ended, command) {
        (Ended::Failed(failure), _) => return Err(failure),
        (Ended::Interrupted, Some(command)) => {
            finished?;
            let message = interrupt::message(simulation.state().step, arguments, command);
            let _ = writeln!(std::io::stderr(), "exact-ccd: {message}");
            return Ok(ExitCode::from(interrupt::STATUS));
        }
        _ => finished?,
    }
    if let Some(warning) = convergence.warning(remaining) {
        notes.warn(warning);
    }
    if let Some(queries) = &queries {
        let counts = queries.total();
        print(&if arguments.json {
            to_json("simulate", counts)
        } else {
            lines::text::of_queries(counts)
        })?;
    }
    if let (Some(folder), Some(pictures)) = (&folder, pictures) {
        let name = arguments.scene.file_stem().unwrap_or_default().to_string_lossy();
        drawings::plots::draw(folder, &name, distance)?;
        pictures.finish(folder)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// A simulation from its start or from the checkpoint in the folder of --output, with the opened folder.
fn open(scene: &Scene, arguments: &Arguments) -> Result<(Simulation, Option<OutputFolder>), Failure> {
    let folder = arguments.output.as_deref();
    if let Some(folder) = folder.filter(|_| arguments.resume) {
        let simulation = OutputFolder::simulation(folder, scene)?;
        let folder = OutputFolder::resume(folder, &simulation, arguments)?;
        return Ok((simulation, Some(folder)));
    }
    let simulation = scene.simulation();
    let simulation = simulation.map_err(|error| Failure::of(&arguments.scene, error))?;
    let folder = folder.map(|folder| OutputFolder::begin(folder, &simulation, arguments));
    Ok((simulation, folder.transpose()?))
}
