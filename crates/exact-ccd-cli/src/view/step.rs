//! The page of a step.

use exact_ccd_mesh::{Aabb, Contact, HalfSpace, Intersection, Motion};
use exact_ccd_view::Page;

use super::setup::Setup;
use crate::contacts::ContactRecord;
use crate::failure::Failure;

/// The contents of the page of a step.
pub(crate) struct ShownStep<'a> {
    pub(crate) motion: &'a Motion,
    /// The intersections at the start.
    pub(crate) start: &'a [Intersection],
    /// The contacts of the mesh, the earliest first.
    pub(crate) contacts: &'a [Contact],
    pub(crate) half_spaces: &'a [HalfSpace],
    /// The contacts with them, the earliest first.
    pub(crate) in_half_spaces: &'a [&'a ContactRecord],
}

impl ShownStep<'_> {
    /// The page with all contacts, the earliest first.
    pub(super) fn page(&self, title: String, setup: Setup) -> Result<Page, Failure> {
        let Motion { mesh, x0, x1 } = self.motion;
        let bounds: Aabb = x0.iter().chain(x1).copied().collect();
        let mut page = setup.add_to(Page::new(title, mesh.clone(), &bounds));
        page.add_frame("t = 0", x0)?;
        for &intersection in self.start {
            page.add_intersection(intersection)?;
        }
        page.add_frame("t = 1", x1)?;
        let mut contacts = self.contacts.iter().peekable();
        for record in self.in_half_spaces {
            while let Some(contact) = contacts.next_if(|contact| contact.impact.time.lower() <= record.toi())
            {
                page.add_contact(contact)?;
            }
            if let Some((vertex, number)) = record.in_half_space() {
                page.add_half_space_contact(vertex, number, Some(record.toi()))?;
            }
        }
        contacts.try_for_each(|contact| page.add_contact(contact))?;
        Ok(page)
    }
}
