#![doc = include_str!("../README.md")]

mod fault;
mod ipc;
mod meshes;
mod notes;
mod polyfem;
mod read;

use std::io;
use std::path::{Path, PathBuf};

pub use fault::{ImportError, Place, Problem};
pub use notes::Note;
pub use read::{ReadError, read};

use meshes::Meshes;
use notes::Notes;

/// A scene of another program as a TOML file.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// The TOML file.
    pub toml: String,
    /// The folder of its mesh files.
    pub meshes: PathBuf,
    /// The entries of the file without a meaning in scenes of this program that do not change the motion, or
    /// only by as much as the methods of both programs differ.
    pub notes: Vec<Note>,
}

/// The TOML file of a scene of another program, with the meaning and the default values that the file has
/// in its own program; `None` for a file that is not named as one: `.txt` and `.ipc`
/// are scenes of IPC, `.json` are scenes of PolyFEM.
///
/// `meshes` is the folder of the mesh files. Without it, they are in the folder of the scene or, as of IPC,
/// in a folder above it.
///
/// # Errors
/// [`ImportError`] names the file, and all places of entries that are unknown or have no counterpart, up to
/// the first one without which the rest cannot be read.
pub fn import(file: impl AsRef<Path>, meshes: Option<&Path>) -> Result<Option<Imported>, ImportError> {
    let file = file.as_ref();
    let extension = file.extension().unwrap_or_default().to_ascii_lowercase();
    let program = match extension.to_str() {
        Some("txt" | "ipc") => "IPC",
        Some("json") => "PolyFEM",
        _ => return Ok(None),
    };
    let at_file = |problem: Problem| ImportError::new(file, vec![problem.at(&Place::Pointer(String::new()))]);
    let text = std::fs::read_to_string(file).map_err(|error| {
        let problem = match error.kind() {
            io::ErrorKind::InvalidData => {
                Problem::invalid("bytes that are no text in UTF-8", "the text of a scene")
            }
            _ => Problem::File(error.to_string()),
        };
        at_file(problem)
    })?;
    let (mut meshes, notes) = (Meshes::new(file, meshes), Notes::default());
    let description = if program == "IPC" {
        ipc::import(&text, &mut meshes, &notes)
    } else {
        let folder = file.parent().unwrap_or(Path::new(""));
        polyfem::import(&text, folder, &mut meshes, &notes)
    };
    let mut faults = notes.take_faults();
    let description = match description {
        Ok(description) if faults.is_empty() => description,
        Ok(_) => return Err(ImportError::new(file, faults)),
        Err(last) => {
            faults.push(last);
            return Err(ImportError::new(file, faults));
        }
    };
    let toml = toml::to_string(&description).map_err(|error| at_file(Problem::File(error.to_string())))?;
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let name: String = name.chars().filter(|character| !character.is_control()).collect();
    Ok(Some(Imported {
        toml: format!("# Imported from {name}, a scene of {program}.\n{toml}"),
        meshes: meshes.folder().to_owned(),
        notes: notes.in_file(file),
    }))
}
