//! Steps: contact, and the certified step.

use exact_ccd::Point;
use exact_ccd_mesh::FreeStepOptions;

use crate::border::call;
use crate::contact::Contact;
use crate::contacts::Contacts;
use crate::detector::Detector;
use crate::error::Status;
use crate::pointers::{Out, fill, places, positions, reference_mut};

/// Decides if a step is free of contact. `x0` and `x1` are the positions of the `vertex_count`
/// vertices at t = 0 and t = 1. Ends soon after the first contact found.
///
/// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact: without
/// `exact_ccd_detector_set_start_check`, this is not found. docs/pairs.md has the pairs that are compared.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_is_free(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    is_free: *mut bool,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, x0, x1, is_free) = unsafe {
            let detector = reference_mut("detector", detector)?;
            let is_free = Out::new("is_free", is_free)?;
            (
                detector,
                positions("x0", x0, vertex_count)?,
                positions("x1", x1, vertex_count)?,
                is_free,
            )
        };
        let options = detector.options();
        is_free.write(!detector.run(|detector| Ok(detector.collides(x0, x1, options)?))?);
        Ok(())
    })
}

/// The earliest contact of a step; `contact` is written only if there is one. Positions as in
/// `exact_ccd_detector_is_free`.
///
/// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact: without
/// `exact_ccd_detector_set_start_check`, this is not found. docs/pairs.md has the pairs that are compared.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_earliest_contact(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    is_found: *mut bool,
    contact: *mut Contact,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, x0, x1, is_found, contact) = unsafe {
            let detector = reference_mut("detector", detector)?;
            let (x0, x1) = (
                positions("x0", x0, vertex_count)?,
                positions("x1", x1, vertex_count)?,
            );
            let is_found = Out::new("is_found", is_found)?;
            (detector, x0, x1, is_found, Out::new("contact", contact)?)
        };
        let options = detector.options();
        let earliest = detector.run(|detector| Ok(detector.collision(x0, x1, options)?))?;
        is_found.write(earliest.is_some());
        if let Some(earliest) = &earliest {
            contact.write(Contact::of(detector.inner.mesh(), [x0, x1], earliest));
        }
        Ok(())
    })
}

/// The contacts of a step whose first time is not after `until`, from 0 to 1, the earliest first; all
/// for 1. The list is freed with `exact_ccd_contacts_free`. Positions as in `exact_ccd_detector_is_free`.
///
/// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact: without
/// `exact_ccd_detector_set_start_check`, this is not found. docs/pairs.md has the pairs that are compared.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_contacts(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    until: f64,
    contacts: *mut *mut Contacts,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, x0, x1, contacts) = unsafe {
            let detector = reference_mut("detector", detector)?;
            let contacts = Out::new("contacts", contacts)?;
            (
                detector,
                positions("x0", x0, vertex_count)?,
                positions("x1", x1, vertex_count)?,
                contacts,
            )
        };
        let options = detector.options().until(until);
        let found = detector.run(|detector| Ok(detector.collisions(x0, x1, options)?))?;
        let of = |contact| Contact::of(detector.inner.mesh(), [x0, x1], contact);
        let list = found.iter().map(of).collect();
        contacts.write(Box::into_raw(Box::new(Contacts(list))));
        Ok(())
    })
}

/// A step that is certified to be free of contact: its size, from 0 to 1, and the positions at its
/// end, which are written to `positions`.
///
/// The size is at most `keep` times the time of impact of the full step, for 0 < `keep` <= 1, and 1
/// if the full step is free. It is 0 if no positive size is certified: the mesh is in contact at the
/// start, or within the smallest `double` of it. `positions` has room for `vertex_count` points, and
/// may be `x0` or `x1`.
///
/// A mesh that is pierced at `x0`, by an edge that passes through a face, may be free of contact, and the
/// size is 1: without `exact_ccd_detector_set_start_check`, this is not found. docs/pairs.md has the pairs
/// that are compared.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_free_step(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    keep: f64,
    size: *mut f64,
    positions: *mut f64,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise. The result is written after
        // the last use of the positions, which may be the same memory.
        unsafe {
            let detector = reference_mut("detector", detector)?;
            let size = Out::new("size", size)?;
            let step = {
                let x0 = crate::pointers::positions("x0", x0, vertex_count)?;
                let x1 = crate::pointers::positions("x1", x1, vertex_count)?;
                let options = FreeStepOptions::default().with_keep(keep);
                let options = options.with_min_distance(detector.min_distance.clone());
                detector.run(|detector| Ok(detector.free_step(x0, x1, &options)?))?
            };
            let places = places("positions", positions.cast::<Point>(), vertex_count)?;
            fill(places, step.positions);
            size.write(step.size);
        }
        Ok(())
    })
}
