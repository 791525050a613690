//! The files with all contacts of a step.

use exact_ccd_mesh::{Contact, Intersection, Motion};

use super::Arguments;
use super::problem::Problem;
use crate::contacts::ContactList;
use crate::messages::failure::Failure;
use crate::motion::paraview;
use crate::motion::report::Report;

impl Arguments {
    /// Writes the files that have all contacts.
    pub(super) fn write(
        &self,
        problem: &Problem<'_>,
        start: &[Intersection],
        contacts: &[Contact],
        list: &ContactList,
        report: &Report,
    ) -> Result<(), Failure> {
        let Problem { scene, motion, .. } = problem;
        if let Some(file) = &self.mesh.all {
            list.write(file)?;
        }
        if let Some(folder) = &self.mesh.paraview {
            paraview::write(folder, motion.step()?, scene.ids(), list)?;
        }
        let half_spaces = problem.half_spaces.all();
        let mut page = self.mesh.view.recording(&self.files, scene, half_spaces);
        let Motion { mesh, x0, x1 } = motion;
        page.begin(mesh, || x0.iter().chain(x1).copied().collect());
        page.add("t = 0", x0)?;
        for &intersection in start {
            page.intersection(intersection)?;
        }
        page.add("t = 1", x1)?;
        let mut contacts = contacts.iter();
        for record in list.0.iter().filter(|record| !record.is_intersection()) {
            match record.in_half_space() {
                Some((vertex, number)) => page.half_space_contact(vertex, number, Some(record.toi()))?,
                None => contacts.next().map_or(Ok(()), |contact| page.contact(contact))?,
            }
        }
        page.finish(&report.verdict(), &report.to_string())
    }
}
