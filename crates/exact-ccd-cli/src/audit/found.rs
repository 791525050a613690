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
        records: Vec<ContactRecord>,
        folder: Option<&Path>,
    ) -> Result<(), Failure> {
        if self.first.is_none()
            && let Some(first) = records.first()
        {
            let frame = first.frame().unwrap_or(moved.index);
            self.first = Some(ReportedViolation::new(scene, moved.index, frame, first.clone()));
            if let Some(folder) = folder {
                // Of this step, without those at rest in the frame after it.
                let is_of_step = |record: &&ContactRecord| record.frame() == first.frame();
                let list = ContactList(records.iter().filter(is_of_step).cloned().collect());
                let start = if frame == moved.index {
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

/// The record of a violation found in the examination of a frame.
pub(super) fn record(moved: &Moved<'_>, violation: &Violation) -> ContactRecord {
    let mesh = &moved.last.mesh;
    match violation {
        Violation::Intersection { frame, intersection } => {
            ContactRecord::of_intersection(mesh, &moved.last.positions, *intersection).in_frame(*frame)
        }
        Violation::Contact { frame, contact } => {
            let positions = [moved.start, &moved.last.positions];
            ContactRecord::of_contact(mesh, positions, contact).in_frame(*frame)
        }
    }
}
