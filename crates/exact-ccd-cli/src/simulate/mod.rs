//! `exact-ccd simulate`: the intersection-free simulation of a scene.

mod filters;
mod folder;
mod grid;
mod line;
mod log;
mod path;
mod pictures;
mod plots;
mod queries;
mod recorder;
mod statistics;
mod steps;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::value_parser;
use exact_ccd_sim::scene::Scene;
use exact_ccd_sim::{Simulation, System};

use crate::failure::Failure;
use crate::output::print;
use crate::progress::{self, during};
use crate::view::View;
use folder::OutputFolder;
use queries::QueryFolder;

/// Simulate a scene: elastic bodies with contact and friction, without intersections
///
/// SCENE is a TOML file with bodies, materials, scripted motions and settings. The key
/// `settings.ccd` selects the method of continuous collision detection (CCD). The
/// command prints one line for the scene and one for each time step.
///
/// With --out, the command writes for each time step N
///   DIR/frames/N.ply     the surface
///   DIR/vtu/N.vtu        tetrahedra, triangles, rods, particles, velocities;
///                        DIR/motion.pvd opens all time steps in ParaView
///   DIR/statistics.csv   a row with iterations, step sizes, contacts, minimal distance,
///                        energies and run times; column names end with units
///   DIR/checkpoint.json  the state for --resume, which replaces the previous one
/// An interrupted run continues with --resume from the last checkpoint. On the same
/// machine, its results are identical to those of an uninterrupted run. Without
/// --resume, the results of an earlier run in DIR are replaced.
///
/// Exit status: 0 success, 2 error.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The scene, a .toml file.
    scene: PathBuf,
    /// The output folder.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// The folder of the mesh files, by default that of the scene file.
    #[arg(long, value_name = "DIR")]
    meshes: Option<PathBuf>,
    #[arg(long, value_name = "NAME", help = ccd_help())]
    ccd: Option<String>,
    /// The number of the last time step, in place of the scene's duration. It counts from the start, also
    /// with --resume.
    #[arg(long, value_name = "N")]
    steps: Option<u64>,
    /// Write the surface after each Newton step, as `path/STEP-INCREMENT.ply`. These increments are free of
    /// contact, and `exact-ccd audit DIR/path` certifies it. The straight motion from one time step to the
    /// next may have contacts.
    #[arg(long, requires = "out")]
    path: bool,
    /// At the end, draw all time steps as `pictures/N.png` and as the animation `motion.png`, and plot
    /// `energies.svg` and `minimal-distance.svg`. With --resume, earlier time steps are included.
    #[arg(long, requires = "out")]
    render: bool,
    /// Write the CCD queries as a data set for `exact-ccd bench` and `exact-ccd queries`. For each time step
    /// N, the folder gets `vertex-face/N.csv` and `edge-edge/N.csv`, with the exact answer in the last
    /// column, and a row of `counts.csv`. The queries are all pairs of primitives whose boxes overlap in a
    /// step that the line search proposes or takes.
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
    /// Continue from the checkpoint in the folder of --out, which must belong to this scene.
    #[arg(long, requires = "out")]
    resume: bool,
    #[command(flatten)]
    view: View,
}

fn ccd_help() -> String {
    let names = filters::names().join(", ");
    format!("The CCD method, in place of that of the scene, one of: {names}")
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    if let Some(name) = &arguments.ccd {
        filters::check(name)?;
    }
    let by_name = |name: &str, system: &System| {
        let name = arguments.ccd.as_deref().unwrap_or(name);
        filters::by_name(name, system).map_err(|error| error.to_string())
    };
    let scene = Scene::read(&arguments.scene, arguments.meshes.as_deref(), &by_name)?;
    let (simulation, mut folder) = match &arguments.out {
        None => (scene.simulation()?, None),
        Some(folder) => {
            let (simulation, folder) = open(folder, &scene, arguments.resume)?;
            (simulation, Some(folder))
        }
    };
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
    let scene_line = line::of_scene(&simulation, steps);
    print(&scene_line)?;
    let mut recording = arguments.view.recording(std::slice::from_ref(&arguments.scene));
    recording.add_state(&simulation)?;
    let bar = progress::time_steps(usize::try_from(remaining).unwrap_or(usize::MAX));
    let lines = bar.clone();
    during(bar, |progress| -> Result<(), Failure> {
        while simulation.state().step < steps {
            let mut path = folder
                .as_ref()
                .filter(|_| arguments.path)
                .map(|folder| folder.path(&simulation));
            let statistics = simulation.step_along(&mut |positions| {
                if let Some(path) = &mut path {
                    path.add(positions);
                }
            })?;
            if let Some(path) = path {
                path.finish()?;
            }
            if let Some(queries) = &mut queries {
                queries.add(statistics.step)?;
            }
            recording.add_state(&simulation)?;
            if let Some(folder) = &mut folder {
                folder.add(&simulation, &statistics)?;
            }
            // The progress bar is hidden while the line is printed.
            lines.suspend(|| print(&line::of(&statistics)))?;
            progress(1);
        }
        Ok(())
    })?;
    recording.finish(&scene_line)?;
    if let Some(queries) = &queries {
        print(&queries.summary())?;
    }
    if let Some(folder) = folder.as_ref().filter(|_| arguments.render) {
        let settings = simulation.settings();
        plots::draw(
            folder,
            settings.contact_distance.meters(simulation.system().size()),
        )?;
        pictures::draw(folder, &simulation)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// A simulation from its start or from the checkpoint in a folder, with the opened folder.
fn open(folder: &Path, scene: &Scene, resume: bool) -> Result<(Simulation, OutputFolder), Failure> {
    let simulation = if resume {
        OutputFolder::simulation(folder, scene)?
    } else {
        scene.simulation()?
    };
    let folder = if resume {
        OutputFolder::resume(folder, &simulation)?
    } else {
        OutputFolder::begin(folder, &simulation)?
    };
    Ok((simulation, folder))
}
