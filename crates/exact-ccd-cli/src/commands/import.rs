//! `exact-ccd import`: scenes of other programs as TOML files.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use exact_ccd_import::{Imported, import};

use crate::files::inputs::check_file;
use crate::files::outputs::Output;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;

/// Convert a scene of another program to a scene of `exact-ccd simulate`
///
/// SCENE is a text scene of IPC, whose name ends in .txt or .ipc, or a scene of
/// PolyFEM, in .json. The TOML file has the same bodies, motions and settings,
/// with the defaults of that program. An entry that exact-ccd cannot simulate is
/// an error; one without a meaning for it is a note on standard error.
///
/// `exact-ccd simulate` converts such scenes by itself.
///
/// Exit status: 0 success, 2 error.
#[derive(clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The scene of another program.
    scene: PathBuf,
    #[command(flatten)]
    output: Output,
    /// Replace the file of --output, which may have changes made by hand. Without it, an existing file is an
    /// error.
    #[arg(long, requires = "output")]
    overwrite: bool,
    /// The folder of the mesh files, by default that of the scene, and the folders above it.
    #[arg(long, value_name = "DIR")]
    meshes: Option<PathBuf>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<ExitCode, Failure> {
    check_file(&arguments.scene, "a scene of IPC or of PolyFEM")?;
    let imported = import(&arguments.scene, arguments.meshes.as_deref())?;
    let Some(imported) = imported else {
        return Err(Failure::of(
            &arguments.scene,
            "expected a scene of IPC, whose name ends in .txt or .ipc, or of PolyFEM, in .json",
        ));
    };
    let Imported {
        toml,
        meshes,
        notes: facts,
    } = imported;
    let mut notes = Notes::default();
    facts.iter().for_each(|text| notes.note(text.to_string()));
    arguments.output.check(std::slice::from_ref(&arguments.scene))?;
    if let Some(file) = arguments
        .output
        .file()
        .filter(|file| file.is_file() && !arguments.overwrite)
    {
        let reason = "the file exists: replace it with --overwrite, or name another file";
        return Err(Failure::of(file, reason));
    }
    arguments.output.write(&toml)?;
    if let Some(output) = arguments.output.file()
        && output.parent() != Some(&meshes)
    {
        let folder = if meshes.as_os_str().is_empty() {
            Path::new(".")
        } else {
            &meshes
        };
        notes.note(format!(
            "the meshes are in the folder {0}: simulate with `--meshes {0}`",
            folder.display()
        ));
    }
    Ok(ExitCode::SUCCESS)
}
