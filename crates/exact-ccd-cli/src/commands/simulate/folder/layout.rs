//! The files and subfolders of the output folder of a simulation.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use exact_ccd_files::read_pvd;

use super::removal::{draft_of, remove_files};
use super::statistics::Row;
use super::steps;
use crate::files::outputs::remove_file;
use crate::messages::failure::Failure;

pub(crate) const CHECKPOINT: &str = "checkpoint.json";
pub(crate) const STATISTICS: &str = "statistics.csv";
pub(crate) const BODIES: &str = "bodies.csv";
pub(crate) const COLLECTION: &str = "motion.pvd";
pub(crate) const CONTACT_COLLECTION: &str = "contacts.pvd";
pub(crate) const ANIMATION: &str = "motion.png";
pub(crate) const GIF: &str = "motion.gif";
pub(crate) const ENERGIES: &str = "energies.svg";
pub(crate) const DISTANCE: &str = "minimal-distance.svg";
const FILES: [&str; 9] = [
    CHECKPOINT,
    STATISTICS,
    BODIES,
    COLLECTION,
    CONTACT_COLLECTION,
    ANIMATION,
    GIF,
    ENERGIES,
    DISTANCE,
];

/// The subfolders, which have one or more files for each time step.
pub(crate) const FRAMES: &str = "frames";
pub(crate) const GRIDS: &str = "vtu";
pub(crate) const CONTACTS: &str = "contacts";
pub(crate) const PATH: &str = "path";
pub(crate) const PICTURES: &str = "pictures";

/// Removes the files of an earlier run. They refer to files in the subfolders, which are removed later.
pub(crate) fn remove_index_files(folder: &Path) -> Result<(), Failure> {
    FILES.iter().try_for_each(|name| remove_file(&folder.join(name)))
}

/// The time steps with files that the collection in a folder lists, up to the last one. If there is no
/// readable collection, these are all files.
pub(crate) fn frames_until(folder: &Path, last: u64) -> Vec<u64> {
    let steps: BTreeSet<u64> = match read_pvd(folder.join(COLLECTION)) {
        Ok(collection) => collection.iter().filter_map(|(_, file)| step(file)).collect(),
        Err(_) => steps_in(&folder.join(GRIDS)),
    };
    steps.range(..=last).copied().collect()
}

/// The time step of a file.
fn step(file: &Path) -> Option<u64> {
    file.file_name()
        .and_then(|name| name.to_str())
        .and_then(steps::step_of)
}

/// The time steps with files in a folder, none if there is no such folder.
fn steps_in(folder: &Path) -> BTreeSet<u64> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.filter_map(|entry| step(&entry.path())).collect()
}

/// The first time step, up to the last one, that is missing in the path after the first one that it has.
pub(crate) fn missing_in_path(folder: &Path, last: u64) -> Option<u64> {
    let steps = steps_in(&folder.join(PATH));
    (*steps.first()?..=last).find(|step| !steps.contains(step))
}

/// The first result up to a time step that is missing.
pub(crate) fn missing(folder: &Path, frames: &[u64], rows: &[Row], last: u64) -> Option<String> {
    let files = frames.iter().flat_map(|&step| files(folder, step));
    let file = files.into_iter().find(|file| !file.is_file());
    let row = (1..=last).zip(rows.iter().map(|row| row.step).chain(std::iter::repeat(0)));
    let row = row.into_iter().find(|(expected, found)| expected != found);
    let row = row.map(|(step, _)| {
        format!(
            "the row of time step {step} in {}",
            folder.join(STATISTICS).display()
        )
    });
    file.map(|file| format!("the file {}", file.display())).or(row)
}

/// The files of the surface, of all vertices and of the contacts at the end of a time step.
pub(crate) fn files(folder: &Path, step: u64) -> [PathBuf; 3] {
    [(FRAMES, "ply"), (GRIDS, "vtu"), (CONTACTS, "vtp")]
        .map(|(inner, extension)| folder.join(inner).join(steps::name(step, extension)))
}

/// Removes the files of all time steps after `last`, or of all time steps for `None`, and unfinished files.
pub(crate) fn remove_after(folder: &Path, last: Option<u64>) -> Result<(), Failure> {
    for inner in [FRAMES, GRIDS, CONTACTS, PATH, PICTURES] {
        steps::remove_after(&folder.join(inner), last)?;
    }
    let is_draft = |name: &str| draft_of(name).is_some_and(|file| FILES.contains(&file));
    remove_files(folder, is_draft).map_err(|source| Failure::write(folder, source))
}
