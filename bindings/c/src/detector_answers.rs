//! The answers of a detector about a step.

use crate::border::call;
use crate::contact::Contact;
use crate::detector::{Detector, with_ends};
use crate::error::Status;
use crate::lists::Contacts;
use crate::pointers::Out;

/// Decides if any two primitives touch in a step. `x0` and `x1` are the positions of the `vertex_count`
/// vertices at t = 0 and t = 1. `until`, from 0 to 1, is the last time that counts, 1 for the whole step:
/// primitives that first touch later do not collide. The exact time is compared, not the rounded one. Ends
/// soon after the first contact found.
///
/// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact: without
/// `exact_ccd_detector_set_start_check`, this is not found. docs/pairs.md has the pairs that are compared.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_collides(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    until: f64,
    collides: *mut bool,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, [x0, x1], collides) = unsafe {
            let (detector, ends) = with_ends(detector, x0, x1, vertex_count)?;
            (detector, ends, Out::new("collides", collides)?)
        };
        let options = detector.options().until(until);
        collides.write(detector.run(|detector| Ok(detector.collides(x0, x1, options)?))?);
        Ok(())
    })
}

/// The earliest contact of a step; `contact` is written only if `collides` is true. Other arguments as in
/// `exact_ccd_detector_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_collision(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    until: f64,
    collides: *mut bool,
    contact: *mut Contact,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, [x0, x1], collides, contact) = unsafe {
            let (detector, ends) = with_ends(detector, x0, x1, vertex_count)?;
            let collides = Out::new("collides", collides)?;
            (detector, ends, collides, Out::new("contact", contact)?)
        };
        let options = detector.options().until(until);
        let earliest = detector.run(|detector| Ok(detector.collision(x0, x1, options)?))?;
        collides.write(earliest.is_some());
        if let Some(earliest) = &earliest {
            contact.write(Contact::of(detector.inner.mesh(), [x0, x1], earliest));
        }
        Ok(())
    })
}

/// All contacts of a step, the earliest first. The list is freed with `exact_ccd_contacts_free`. Other
/// arguments as in `exact_ccd_detector_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_collisions(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    until: f64,
    contacts: *mut *mut Contacts,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, [x0, x1], contacts) = unsafe {
            let (detector, ends) = with_ends(detector, x0, x1, vertex_count)?;
            (detector, ends, Out::new("contacts", contacts)?)
        };
        let options = detector.options().until(until);
        let found = detector.run(|detector| Ok(detector.collisions(x0, x1, options)?))?;
        contacts.give(Contacts::of(detector.inner.mesh(), [x0, x1], &found));
        Ok(())
    })
}
