//! The names of files that belong to a time step.

use std::path::Path;

use super::removal::{draft_of, is_number, remove_files};
use crate::messages::failure::Failure;

/// The name of the file of a time step. Below a million, names have six digits and sort as numbers.
pub(crate) fn name(step: u64, extension: &str) -> String {
    format!("{step:06}.{extension}")
}

/// Removes the files of a folder that belong to time steps after `last`, or to any time step for `None`, and
/// unfinished files. Files with other names stay.
pub(crate) fn remove_after(folder: &Path, last: Option<u64>) -> Result<(), Failure> {
    let is_later = |step: u64| last.is_none_or(|last| step > last);
    let is_superfluous = |name: &str| match draft_of(name) {
        Some(file) => step_of(file).is_some(),
        None => step_of(name).is_some_and(is_later),
    };
    remove_files(folder, is_superfluous).map_err(|source| Failure::write(folder, source))
}

/// The time step to which a file belongs, given by names such as `000012.ply` and `000012-003.ply`.
pub(crate) fn step_of(name: &str) -> Option<u64> {
    let (stem, _) = name.split_once('.')?;
    let (step, increment) = stem.split_once('-').unwrap_or((stem, "0"));
    let is_ours = step.len() >= 6 && is_number(step) && is_number(increment);
    is_ours.then(|| step.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_file_names_have_no_time_step() {
        for step in [0, 7, 123_456, 1_234_567] {
            assert_eq!(step_of(&name(step, "ply")), Some(step));
        }
        assert_eq!(step_of("000012-003.ply"), Some(12));
        for other in [
            "12.ply",
            "000012",
            "cube-000012.ply",
            "000012-a.ply",
            ".000012.ply.7",
            "00001x.ply",
        ] {
            assert_eq!(step_of(other), None, "{other}");
        }
    }
}
