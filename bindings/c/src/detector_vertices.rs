//! Answers for each vertex: first contacts and clearances.

use exact_ccd::Separation;

use crate::border::call;
use crate::detector::{Detector, with_ends};
use crate::error::{Error, Status};
use crate::lists::Contacts;
use crate::pointers::{Out, fill, places, positions, reference_mut};

/// All contacts of a step, the earliest first, and the first one of each vertex: for methods that limit the
/// displacement of each vertex by a rule of their own.
///
/// `first` has room for `vertex_count` numbers. For each vertex, it has the index, in `contacts`, of the
/// first contact of a pair to which the vertex belongs, or the number of contacts if there is none. `times`
/// has room for as many numbers: the time of this contact, rounded down, or infinity. The list `contacts` is
/// freed with `exact_ccd_contacts_free`. Other arguments as in `exact_ccd_detector_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_first_contacts(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    until: f64,
    first: *mut usize,
    times: *mut f64,
    contacts: *mut *mut Contacts,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, [x0, x1], first, times, contacts) = unsafe {
            let (detector, ends) = with_ends(detector, x0, x1, vertex_count)?;
            let contacts = Out::new("contacts", contacts)?;
            let first = places("first", first, vertex_count)?;
            let times = places("times", times, vertex_count)?;
            (detector, ends, first, times, contacts)
        };
        let options = detector.options().until(until);
        let found = detector.run(|detector| Ok(detector.first_contacts(x0, x1, options)?))?;
        let count = found.contacts.len();
        fill(times, found.times());
        let of_vertices = found.of_vertices.iter();
        fill(first, of_vertices.map(|of_vertex| of_vertex.unwrap_or(count)));
        contacts.give(Contacts::of(detector.inner.mesh(), [x0, x1], &found.contacts));
        Ok(())
    })
}

/// The clearance of each vertex at rest: the least distance between a primitive that has the vertex and
/// a primitive that can collide with it, or `cut_off` if all are farther apart. It is rounded down to a
/// `double`.
///
/// If each vertex of a mesh moves by less than half of its clearance, on whatever path, the motion is free
/// of contact (docs/steps.md). The minimum distance of the detector has no part in it. `clearances` has room
/// for `vertex_count` numbers, and `cut_off` is finite and at least 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_clearances(
    detector: *mut Detector,
    x: *const f64,
    vertex_count: usize,
    cut_off: f64,
    clearances: *mut f64,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, x, clearances) = unsafe {
            let detector = reference_mut("detector", detector)?;
            let x = positions("x", x, vertex_count)?;
            (detector, x, places("clearances", clearances, vertex_count)?)
        };
        let cut_off =
            Separation::new(cut_off).map_err(|error| Error::argument(format_args!("cut_off: {error}")))?;
        let found = detector.run(|detector| Ok(detector.clearances(x, cut_off)?))?;
        fill(clearances, found);
        Ok(())
    })
}
