//! `exact-ccd simulate`: a scene in motion, free of intersections.

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
use exact_ccd_sim::Simulation;
use exact_ccd_sim::scene::Scene;

use crate::failure::Failure;
use crate::output::print;
use crate::progress::{self, during};
use folder::OutputFolder;
use queries::QueryFolder;

/// Simulate a scene: elastic bodies with contact and friction, none of which passes through another
///
/// SCENE is a TOML file with bodies, materials, scripted motions and the numbers of
/// the simulation; the name of its method of continuous collision detection is
/// `settings.ccd`. Prints one line for the scene and one for each time step.
///
/// With --out, DIR gets, of each time step N,
///   frames/N.ply     the surface
///   vtu/N.vtu        tetrahedra, and triangles of shells and obstacles, with
///                    velocities; motion.pvd opens all of them in ParaView
///   statistics.csv   a row: iterations, step sizes, contacts, minimal distance,
///                    energies, times; the names of the columns have the units
///   checkpoint.json  all that --resume needs, in place of that before
/// Whenever the program is ended, --resume goes on from the last checkpoint, on the
/// same machine to the same bits. Without it, the results of an earlier run in DIR are replaced.
///
/// Exit status: 0 success, 2 error.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The scene: a .toml file.
    scene: PathBuf,
    /// Where the results go.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Where the mesh files are; if not given, where the scene file is.
    #[arg(long, value_name = "DIR")]
    meshes: Option<PathBuf>,
    #[arg(long, value_name = "NAME", help = ccd_help())]
    ccd: Option<String>,
    /// The time step at which to end, counted from the start, in place of that of the scene's duration.
    #[arg(long, value_name = "N")]
    steps: Option<u64>,
    /// Write the way too: the surface after each increment of a time step, as `path/STEP-INCREMENT.ply`. That is what is free
    /// of contact, as `exact-ccd audit DIR/path` certifies; straight from one time step to the next there may be some.
    #[arg(long, requires = "out")]
    path: bool,
    /// Draw each time as `pictures/N.png`, and all of them as an animation, `motion.png`, at the end, and plot
    /// `energies.svg` and `minimal-distance.svg`: with --resume, of the time steps that are there already too.
    #[arg(long, requires = "out")]
    render: bool,
    /// Write the queries of continuous collision detection as a data set, which `exact-ccd bench` and `queries` read: of
    /// each time step N, `vertex-face/N.csv` and `edge-edge/N.csv`, with the exact answer in the last column, and a row of
    /// `counts.csv`. A query is any pair whose boxes overlap in a step that the line search proposes, or takes.
    #[arg(long, value_name = "DIR")]
    dump_queries: Option<PathBuf>,
    /// Keep at most so many queries in contact, and so many others, of each kind and time step, drawn at random.
    #[arg(long, value_name = "N", default_value_t = 1000, requires = "dump_queries", value_parser = value_parser!(u32).range(1..))]
    dump_most: u32,
    /// Go on from the checkpoint in the folder of --out, which must be of this scene.
    #[arg(long, requires = "out")]
    resume: bool,
}

fn ccd_help() -> String {
    let names = exact_ccd_sim::filter::names().join(", ");
    format!("The method of continuous collision detection, in place of the scene's: {names}")
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let mut scene = Scene::read(&arguments.scene, arguments.meshes.as_deref())?;
    if let Some(ccd) = &arguments.ccd {
        scene.settings.ccd.clone_from(ccd);
    }
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
    print(&line::of_scene(&simulation, steps))?;
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
            if let Some(folder) = &mut folder {
                folder.add(&simulation, &statistics)?;
            }
            // The bar makes room for the line.
            lines.suspend(|| print(&line::of(&statistics)))?;
            progress(1);
        }
        Ok(())
    })?;
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

/// A simulation from its start or from the checkpoint in a folder, and the folder.
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
