//! `exact-ccd import`: scenes of other programs as TOML files.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use exact_ccd_scene::{Imported, SceneError, import};

use crate::failure::Failure;
use crate::inputs::check_file;
use crate::output::{print, write_file};
use crate::simulate::note;

/// Convert a scene of another program to a scene of `exact-ccd simulate`
///
/// SCENE is a text scene of IPC, whose name ends in .txt or .ipc, or a scene of PolyFEM, in .json.
/// The TOML file has the same bodies, motions and settings, with the defaults of that program.
/// An entry that exact-ccd cannot simulate is an error; one without a meaning for it is a note on standard
/// error.
///
/// `exact-ccd simulate` converts such scenes by itself.
///
/// Exit status: 0 success, 2 error.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The scene of another program.
    scene: PathBuf,
    /// The TOML file to write [default: standard output]
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    /// The folder of the mesh files, by default that of the scene, and the folders above it.
    #[arg(long, value_name = "DIR")]
    meshes: Option<PathBuf>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    check_file(&arguments.scene, "a scene of IPC or of PolyFEM")?;
    let imported = import(&arguments.scene, arguments.meshes.as_deref()).map_err(SceneError::from)?;
    let Some(imported) = imported else {
        return Err(Failure::of(
            &arguments.scene,
            "expected a scene of IPC, whose name ends in .txt or .ipc, or of PolyFEM, in .json",
        ));
    };
    let Imported { toml, meshes, notes } = imported;
    notes.iter().for_each(|text| note(text));
    let Some(output) = &arguments.output else {
        print(toml.trim_end())?;
        return Ok(ExitCode::SUCCESS);
    };
    write_file(output, |file| file.write_all(toml.as_bytes()))?;
    if output.parent() != Some(&meshes) {
        let folder = if meshes.as_os_str().is_empty() {
            Path::new(".")
        } else {
            &meshes
        };
        note(&format!(
            "the meshes are in the folder {0}: simulate with `--meshes {0}`",
            folder.display()
        ));
    }
    Ok(ExitCode::SUCCESS)
}
