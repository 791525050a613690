//! The violations that an audit has found.

use std::path::Path;

use exact_ccd::Point;
use exact_ccd_mesh::{Frame, Step, Violation};

use super::report::ReportedViolation;
use crate::contacts::{ContactList, ContactRecord};
use crate::failure::Failure;
use crate::impact_files;
use crate::scene::Scene;

/// A frame with its number, and the positions in the frame before it, or in itself if it is the first.
pub(super) struct Moved<'a> {
    pub(super) index: usize,
    pub(super) start: &'a [Point],
    pub(super) last: &'a Frame,
}

/// The violations found so far.
#[derive(Default)]
pub(super) struct Found {
    pub(super) first: Option<ReportedViolation>,
    pub(super) list: ContactList,
}

impl Found {
    /// Adds the violations found in the examination of a frame. The first ones go to the folder, too.
    pub(super) fn add(
        &mut self,
        scene: &Scene,
        moved: &Moved<'_>,
        violations: &[Violation],
        folder: Option<&Path>,
    ) -> Result<(), Failure> {
        let records: Vec<_> = violations
            .iter()
            .map(|violation| record(moved, violation).in_file(scene.ids()))
            .collect();
        if self.first.is_none()
            && let (Some(violation), Some(first)) = (violations.first(), records.first())
        {
            self.first = Some(ReportedViolation::new(
                scene,
                moved.index,
                violation,
                first.clone(),
            ));
            if let Some(folder) = folder {
                // Of this step, without the intersections of the frame after it.
                let is_of_step = |record: &&ContactRecord| record.frame() == first.frame();
                let list = ContactList(records.iter().filter(is_of_step).cloned().collect());
                let start = if first.is_intersection() {
                    &moved.last.positions
                } else {
                    moved.start
                };
                impact_files::write(
                    folder,
                    Step::new(&moved.last.mesh, start, &moved.last.positions)?,
                    scene.ids(),
                    &list,
                )?;
            }
        }
        self.list.0.extend(records);
        Ok(())
    }
}

fn record(moved: &Moved<'_>, violation: &Violation) -> ContactRecord {
    let mesh = &moved.last.mesh;
    match violation {
        Violation::Intersection { frame, intersection } => {
            ContactRecord::of_intersection(mesh, *intersection).in_frame(*frame)
        }
        Violation::Contact { frame, contact } => {
            let positions = [moved.start, &moved.last.positions];
            ContactRecord::of_contact(mesh, positions, contact).in_frame(*frame)
        }
    }
}
