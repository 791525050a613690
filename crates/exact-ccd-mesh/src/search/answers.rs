//! The answers of a detector about a step.

use exact_ccd::{Options, Point};

use super::collect::{AllContacts, AnyContact, Earliest};
use super::contact::Contact;
use super::detector::{Begun, Detector};
use crate::pairs::{MinDistance, Pair};
use crate::steps::StepError;

impl Detector {
    /// Returns true if any two primitives touch in the step from positions `x0` to positions `x1`: a
    /// [`Pair`], which says what is never a contact. Ends soon after the first contact found.
    ///
    /// # Errors
    /// [`StepError`] names the positions that are too many, too few or not finite, the thicknesses that are
    /// not as many as the vertices, a last time that is not in [0, 1], or, with the check of the start, the
    /// edge that passes through a face.
    pub fn collides(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        options: Options<impl Into<MinDistance>>,
    ) -> Result<bool, StepError> {
        Ok(self.begin(x0, x1, options)?.collides())
    }

    /// [`collides`](Self::collides), restricted to pairs for which `counts` returns true.
    ///
    /// `counts` is called for pairs in contact only, on many threads, at most once for each. So it may be
    /// slow. The predicate of [`with_can_collide`](Self::with_can_collide) is called for every candidate, and
    /// holds for all answers, and for the check of the start.
    ///
    /// # Errors
    /// As [`collides`](Self::collides).
    pub fn collides_if(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        options: Options<impl Into<MinDistance>>,
        counts: impl Fn(Pair) -> bool + Sync,
    ) -> Result<bool, StepError> {
        Ok(self.begin(x0, x1, options)?.collides_if(&counts))
    }

    /// The earliest contact in the step from positions `x0` to positions `x1`, or `None` if there is none.
    ///
    /// A sample of the primitives is examined first. Each contact that is found bounds the time
    /// until which the others matter; so most candidates are never examined, nor counted as
    /// [`StepReport`](crate::StepReport) does. The answer is the same on any number of threads.
    ///
    /// # Errors
    /// As [`collides`](Self::collides).
    pub fn collision(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        options: Options<impl Into<MinDistance>>,
    ) -> Result<Option<Contact>, StepError> {
        Ok(self.begin(x0, x1, options)?.collision())
    }

    /// All contacts in the step from positions `x0` to positions `x1`, the earliest first.
    ///
    /// # Errors
    /// As [`collides`](Self::collides).
    pub fn collisions(
        &mut self,
        x0: &[Point],
        x1: &[Point],
        options: Options<impl Into<MinDistance>>,
    ) -> Result<Vec<Contact>, StepError> {
        Ok(self.begin(x0, x1, options)?.collisions())
    }
}

// Apart from the functions above, which each crate compiles again for its own types.
impl Begun<'_> {
    fn collides(mut self) -> bool {
        let is_found = self.run(AnyContact::new(self.until, &|_| true)).is_found();
        if !is_found {
            let [_, x1] = self.step.positions();
            self.found_free(x1);
        }
        is_found
    }

    fn collides_if(mut self, counts: &(dyn Fn(Pair) -> bool + Sync)) -> bool {
        self.run(AnyContact::new(self.until, counts)).is_found()
    }

    fn collision(mut self) -> Option<Contact> {
        let contact = self.run(Earliest::new(self.until)).contact();
        if contact.is_none() {
            let [_, x1] = self.step.positions();
            self.found_free(x1);
        }
        contact
    }

    fn collisions(mut self) -> Vec<Contact> {
        self.run(AllContacts::new(self.until)).sorted()
    }
}
