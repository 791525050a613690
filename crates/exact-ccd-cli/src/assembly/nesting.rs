//! Bodies inside of closed bodies. No contact reports them.

use std::collections::BTreeMap;

use exact_ccd_mesh::{Point, StepError, enclosed};

use super::Assembly;
use crate::messages::failure::Failure;
use crate::messages::notes::Notes;

impl Assembly {
    /// Adds a note if a component lies inside of a closed body in a frame.
    ///
    /// A point is inside a body of several closed surfaces, such as a hollow body, if an odd number of these
    /// encloses it.
    pub(crate) fn note_nesting(&self, positions: &[Point], notes: &mut Notes) -> Result<(), Failure> {
        let found = enclosed(&self.mesh, positions, &self.can_collide).map_err(StepError::from)?;
        let mut inside: BTreeMap<(u32, usize), (bool, u32)> = BTreeMap::new();
        for pair in found {
            let body = self.names.body(pair.outer);
            let (is_odd, _) = inside.entry((pair.inner, body)).or_insert((false, pair.outer));
            *is_odd = !*is_odd;
        }
        let mut inside = inside.into_iter().filter(|(_, (is_odd, _))| *is_odd);
        let Some(((inner, _), (_, outer))) = inside.next() else {
            return Ok(());
        };
        let more = match inside.count() {
            0 => String::new(),
            count => format!(", and {count} more such pairs"),
        };
        let [first, second] = [inner, outer].map(|vertex| self.component_name(vertex));
        notes.note(format!(
            "at the start, {first} lies inside of the closed surface of {second}{more}: surfaces that do not touch are \
             free of contact, inside of each other, too; move it out, unless a cavity is meant"
        ));
        Ok(())
    }

    /// The name of a component for messages: its body, if there are several, and its least vertex in the
    /// file.
    pub(super) fn component_name(&self, vertex: u32) -> String {
        let id = self.file_vertex(vertex);
        match self.names.name(&[vertex]) {
            Some(name) => format!("{name} (with vertex {id})"),
            None => format!("the component of vertex {id}"),
        }
    }
}
