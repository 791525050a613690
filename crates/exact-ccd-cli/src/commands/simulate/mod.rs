//! `exact-ccd simulate`: the intersection-free simulation of a scene.

mod arguments;
mod drawings;
mod filters;
mod folder;
mod interrupt;
mod iterations;
mod lines;
mod outputs;
mod queries;
mod run;

use std::ffi::OsString;
use std::process::ExitCode;

use exact_ccd_scene::Scene;
use exact_ccd_sim::{Settings, System};

use crate::files::inputs::check_file;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;
pub(crate) use arguments::Arguments;
use queries::QueryFolder;
use run::Run;

/// Runs the command. `command` is the program with its arguments.
pub(crate) fn run(arguments: &Arguments, command: &[OsString]) -> Result<ExitCode, Failure> {
    let (scene, notes) = read(arguments)?;
    let mut run = Run::begin(arguments, command, scene, notes)?;
    let ended = run.advance()?;
    run.finish(ended)
}

/// The scene with notes about it, with the method and the line search of the command line. Checks first what
/// can be checked without it.
fn read(arguments: &Arguments) -> Result<(Scene, Notes), Failure> {
    check_file(&arguments.scene, "a scene in TOML, or one of IPC or of PolyFEM")?;
    if let Some(name) = &arguments.method {
        filters::check(name)?;
    }
    let by_name = |settings: &mut Settings, system: &System| {
        if let Some(line_search) = arguments.line_search {
            settings.line_search = line_search;
        }
        let name = arguments.method.as_deref().unwrap_or(&settings.ccd);
        filters::by_name(name, system).map_err(|error| error.to_string())
    };
    let (scene, ignored) = exact_ccd_import::read(&arguments.scene, arguments.meshes.as_deref(), &by_name)?;
    if let Some(folder) = &arguments.dump_queries
        && !arguments.resume
        && !arguments.overwrite
    {
        QueryFolder::check_is_new(folder)?;
    }
    let mut notes = Notes::default();
    ignored.iter().for_each(|text| notes.note(text.to_string()));
    scene.notes.iter().for_each(|text| notes.note(text.clone()));
    Ok((scene, notes))
}
