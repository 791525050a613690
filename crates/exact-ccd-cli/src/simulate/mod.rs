//! `exact-ccd simulate`: a scene in motion, free of intersections.

mod folder;
mod line;
mod path;
mod pictures;

use std::path::PathBuf;
use std::process::ExitCode;

use ccd_sim::scene::Scene;

use crate::failure::Failure;
use crate::output::print;
use crate::progress::{self, during};
use folder::OutputFolder;

/// Simulate a scene: elastic bodies with contact and friction, none of which passes through another.
///
/// SCENE is a TOML file with bodies, materials, scripted motions and the numbers of the simulation; the name of its method
/// of continuous collision detection is `settings.ccd`. Prints one line for each time step.
///
/// With --out, DIR gets the surface at each time as `frames/N.ply`, one line of JSON for each time step in
/// `statistics.jsonl`, and, after each time step, all that --resume needs in `checkpoint.json`.
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The scene: a .toml file.
    scene: PathBuf,
    /// Where the results go.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Where the mesh files are; if not given, where the scene file is.
    #[arg(long, value_name = "DIR")]
    meshes: Option<PathBuf>,
    /// The method of continuous collision detection, in place of the scene's.
    #[arg(long, value_name = "NAME")]
    ccd: Option<String>,
    /// How many time steps to take, in place of those of the scene's duration.
    #[arg(long, value_name = "N")]
    steps: Option<u64>,
    /// Write the way too: the surface after each increment of a time step, as `path/STEP-INCREMENT.ply`. That is what is free
    /// of contact, as `exact-ccd audit DIR/path` certifies; straight from one time step to the next there may be some.
    #[arg(long, requires = "out")]
    path: bool,
    /// Draw each time as `pictures/N.png`, and all of them as an animation, `motion.png`, at the end: with --resume, of
    /// the time steps that are there already too.
    #[arg(long, requires = "out")]
    render: bool,
    /// Go on from the checkpoint in the folder of --out, to the same bits.
    #[arg(long, requires = "out")]
    resume: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    let mut scene = Scene::read(&arguments.scene, arguments.meshes.as_deref())?;
    if let Some(ccd) = &arguments.ccd {
        scene.settings.ccd.clone_from(ccd);
    }
    let folder = arguments.out.as_deref().map(OutputFolder::create).transpose()?;
    let resumed = folder.as_ref().filter(|_| arguments.resume);
    let mut simulation = match resumed {
        Some(folder) => scene.resume(folder.checkpoint()?)?,
        None => scene.simulation()?,
    };
    if let Some(folder) = folder.as_ref().filter(|_| !arguments.resume) {
        folder.begin(&simulation)?;
    }

    let steps = arguments.steps.unwrap_or(scene.steps);
    let remaining = steps.saturating_sub(simulation.state().step);
    let bar = progress::time_steps(usize::try_from(remaining).unwrap_or(usize::MAX));
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
            if let Some(folder) = &folder {
                folder.add(&simulation, &statistics)?;
            }
            print(&line::of(&statistics))?;
            progress(1);
        }
        Ok(())
    })?;
    if let Some(folder) = folder.as_ref().filter(|_| arguments.render) {
        pictures::draw(folder, &simulation)?;
    }
    Ok(ExitCode::SUCCESS)
}
