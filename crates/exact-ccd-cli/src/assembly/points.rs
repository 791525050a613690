//! Verdicts about points alone, which say nothing about surfaces.

use super::options::AssemblyOptions;
use super::part::Part;
use crate::messages::failure::{Failure, listed};
use crate::messages::notes::Notes;

/// Refuses a scene without a face and an edge, unless `--points` is given; warns of a part without a face and
/// an edge. A misspelt name of `--faces-only` is an error, too.
pub(super) fn check(parts: &[Part], options: &AssemblyOptions, notes: &mut Notes) -> Result<(), Failure> {
    let is_part = |name: &str| name.is_empty() || parts.iter().any(|part| part.name == name);
    if let Some(name) = options.faces_only.iter().find(|name| !is_part(name)) {
        let known = listed(parts.iter().map(|part| part.name.clone()), 20);
        return Err(Failure::new(format_args!(
            "--faces-only={name}: there is no part {name}; there are {known}"
        )));
    }
    if options.points {
        return Ok(());
    }
    let of_points = || parts.iter().filter(|part| part.is_of_points());
    if parts.iter().all(Part::is_of_points) {
        let count: usize = parts.iter().map(|part| part.mesh().vertex_count()).sum();
        let files = listed(of_points().map(|part| part.frame_name(0)), 5);
        return Err(Failure::new(format_args!(
            "{files}: {count} points, and neither a face nor an edge: a verdict about points alone says nothing about \
             surfaces; name a file that has the faces, or add --points if points are meant"
        )));
    }
    for part in of_points() {
        notes.warn(format!(
            "the part {} has neither a face nor an edge: its points are examined; --points omits this warning",
            part.name
        ));
    }
    Ok(())
}
