//! The violations of a frame: as records, on the page, and for ParaView.

use exact_ccd::Point;
use exact_ccd_mesh::{Frame, Step, Violation};

use super::arguments::Arguments;
use crate::assembly::Assembly;
use crate::contacts::{ContactList, ContactRecord};
use crate::messages::failure::Failure;
use crate::motion::paraview;
use crate::view::Recording;

/// Adds the violations in a frame, and in the step to it, to the page.
pub(super) fn show(
    page: &mut Recording,
    violations: &[Violation],
    records: &[ContactRecord],
) -> Result<(), Failure> {
    for violation in violations {
        match violation {
            Violation::Intersection { intersection, .. } => page.intersection(*intersection),
            Violation::Contact { contact, .. } => page.contact(contact),
        }?;
    }
    for (vertex, number) in records.iter().filter_map(ContactRecord::in_half_space) {
        page.half_space_contact(vertex, number, None)?;
    }
    Ok(())
}

/// The record of a violation, found in the frame `last` or in the step to it from these positions.
pub(super) fn record(start: &[Point], last: &Frame, violation: &Violation) -> ContactRecord {
    let (mesh, positions) = (&last.mesh, &last.positions[..]);
    match violation {
        Violation::Intersection { frame, intersection } => {
            ContactRecord::of_intersection(*frame, mesh, positions, *intersection)
        }
        Violation::Contact { frame, contact } => {
            ContactRecord::of_contact(*frame, mesh, [start, positions], contact)
        }
    }
}

impl Arguments {
    /// Writes the files for ParaView: the first violation of the step that leads to a frame, and all others
    /// of this step, without violations at rest in the frame after it.
    pub(super) fn write_impact(
        &self,
        scene: &Assembly,
        index: usize,
        [start, end]: [&[Point]; 2],
        records: &[ContactRecord],
    ) -> Result<(), Failure> {
        let Some(folder) = &self.mesh.paraview else {
            return Ok(());
        };
        let frame = records.first().map_or(index, |first| first.frame);
        let start = if frame == index { end } else { start };
        let of_step = records.iter().filter(|record| record.frame == frame);
        let list = ContactList(of_step.cloned().collect());
        paraview::write(folder, Step::new(scene.mesh(), start, end)?, scene.ids(), &list)
    }
}
