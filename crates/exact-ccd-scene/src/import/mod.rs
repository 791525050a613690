//! Scenes of other programs: the text scenes of IPC, and PolyFEM's JSON.
//!
//! An import maps a file to the description of a scene, with the meaning and the default values that the file
//! has in its own program. The description is written as TOML, and read as any other scene.

mod fault;
mod ipc;
mod meshes;
mod polyfem;
mod pose;
mod selection;
mod text;

use std::io;
use std::path::{Path, PathBuf};

pub use fault::{ImportError, Place, Problem};

use super::description::Description;
use meshes::Meshes;

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

/// An entry of a file that is ignored.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}, {place}: {message}", file.display())]
pub struct Note {
    /// The file.
    pub file: PathBuf,
    /// The place of the entry.
    pub place: Place,
    /// The reason.
    pub message: String,
}

/// A description with its notes, of which the file is not known yet.
#[derive(Debug)]
struct Draft {
    description: Description,
    notes: Vec<(Place, String)>,
}

/// A program of which the scenes are imported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Program {
    Ipc,
    PolyFem,
}

impl Program {
    /// The program of a scene file, by the extension of its name.
    fn of(file: &Path) -> Option<Self> {
        let extension = file.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "txt" | "ipc" => Some(Self::Ipc),
            "json" => Some(Self::PolyFem),
            _ => None,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Ipc => "IPC",
            Self::PolyFem => "PolyFEM",
        }
    }
}

/// The TOML file of a scene of another program; `None` for a file that is not named as one: `.txt` and `.ipc`
/// are scenes of IPC, `.json` those of PolyFEM.
///
/// `meshes` is the folder of the mesh files. Without it, they are in the folder of the scene or, as of IPC,
/// in a folder above it.
///
/// # Errors
/// [`ImportError`] names the file, the place, and the entry that is invalid or has no counterpart.
pub fn import(file: impl AsRef<Path>, meshes: Option<&Path>) -> Result<Option<Imported>, ImportError> {
    let file = file.as_ref();
    let Some(program) = Program::of(file) else {
        return Ok(None);
    };
    let text = std::fs::read_to_string(file).map_err(|error| {
        let problem = match error.kind() {
            io::ErrorKind::InvalidData => {
                Problem::invalid("bytes that are no text in UTF-8", "the text of a scene")
            }
            _ => Problem::File(error.to_string()),
        };
        problem.at(&Place::Pointer(String::new())).in_file(file)
    })?;
    let mut meshes = Meshes::new(file, meshes);
    let draft = match program {
        Program::Ipc => ipc::import(&text, &mut meshes),
        Program::PolyFem => polyfem::import(&text, file.parent().unwrap_or(Path::new("")), &mut meshes),
    };
    let Draft { description, notes } = draft.map_err(|fault| fault.in_file(file))?;
    let toml = text::toml(&description, program.name(), file).map_err(|fault| fault.in_file(file))?;
    let note = |(place, message)| Note {
        file: file.to_owned(),
        place,
        message,
    };
    Ok(Some(Imported {
        toml,
        meshes: meshes.folder().to_owned(),
        notes: notes.into_iter().map(note).collect(),
    }))
}
