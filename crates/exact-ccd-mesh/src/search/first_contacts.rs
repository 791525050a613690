//! The first contact of each vertex.

use exact_ccd::{Options, Point};

use super::contact::Contact;
use super::detector::Detector;
use crate::pairs::MinDistance;
use crate::steps::StepError;

/// All contacts of a step, and the first one of each vertex: for methods that limit the displacement of each
/// vertex by a rule of their own.
#[derive(Clone, Debug, PartialEq)]
pub struct FirstContacts {
    /// The first contact of each pair that touches, the earliest first.
    pub contacts: Vec<Contact>,
    /// For each vertex, the index in `contacts` of the first one of a pair to which it belongs.
    pub of_vertices: Vec<Option<usize>>,
}

impl FirstContacts {
    /// The largest f64 not above the time of the first contact of each vertex; infinity for vertices without
    /// contact.
    ///
    /// ```
    /// use exact_ccd_mesh::{CONTACT, Detector, TriangleMesh};
    ///
    /// let mesh = TriangleMesh::new(5, vec![[0, 1, 2]])?;
    /// let floor = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let x0 = [&floor[..], &[[0.25, 0.25, 1.0], [5.0, 0.0, 1.0]]].concat();
    /// let x1 = [&floor[..], &[[0.25, 0.25, -1.0], [5.0, 0.0, -1.0]]].concat();
    ///
    /// let first = Detector::new(mesh).first_contacts(&x0, &x1, CONTACT)?;
    /// assert_eq!(first.times(), [0.5, 0.5, 0.5, 0.5, f64::INFINITY]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn times(&self) -> Vec<f64> {
        let contact = |first: &Option<usize>| self.contacts.get((*first)?);
        let time = |contact: &Contact| contact.impact.time.lower();
        let times = self.of_vertices.iter().map(contact);
        times.map(|first| first.map_or(f64::INFINITY, time)).collect()
    }
}

impl Detector {
    /// The contacts of the step from positions `x0` to positions `x1`, and the first one of each vertex.
    ///
    /// # Errors
    /// As [`collisions`](Self::collisions).
    pub fn first_contacts(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        options: Options<impl Into<MinDistance>>,
    ) -> Result<FirstContacts, StepError> {
        let contacts = self.collisions(x0, x1, options)?;
        let mut of_vertices = vec![None; x0.len()];
        for (index, contact) in contacts.iter().enumerate() {
            for vertex in contact.pair.vertices(self.mesh()).into_iter().flatten() {
                of_vertices[vertex as usize].get_or_insert(index);
            }
        }
        Ok(FirstContacts {
            contacts,
            of_vertices,
        })
    }
}
