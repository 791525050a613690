//! Certified steps: one size for the mesh, or one for each vertex.

use exact_ccd::Point;

use crate::border::call;
use crate::contact::Contact;
use crate::detector::{Detector, with_ends};
use crate::error::Status;
use crate::lists::Pairs;
use crate::pair::Pair;
use crate::pointers::{Out, array, fill, places};

/// A step that is certified to be free of contact: its size, from 0 to 1, and the positions at its
/// end, which are written to `positions`.
///
/// The size is at most `keep` times the time of impact of the full step, for 0 < `keep` <= 1, and 1
/// if the full step is free. It is 0 if none of the sizes that are tried is certified: the mesh touches
/// itself at the start, or is nearer to itself there than rounded positions are to the path. `positions` has
/// room for `vertex_count` points, and may be `x0` or `x1`.
///
/// `collides` is true if the full step has a contact. Then the earliest one is written to `contact`; else
/// `contact` is not written. Both may be null.
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
    collides: *mut bool,
    contact: *mut Contact,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise. The result is written after
        // the last use of the positions, which may be the same memory.
        unsafe {
            let (detector, [x0, x1]) = with_ends(detector, x0, x1, vertex_count)?;
            let size = Out::new("size", size)?;
            let collides = Out::optional("collides", collides)?;
            let contact = Out::optional("contact", contact)?;
            let options = detector.free_step_options(keep);
            let step = detector.run(|detector| Ok(detector.free_step(x0, x1, &options)?))?;
            let mesh = detector.inner.mesh();
            let earliest = step
                .contact
                .map(|earliest| Contact::of(mesh, [x0, x1], &earliest));
            let places = places("positions", positions.cast::<Point>(), vertex_count)?;
            fill(places, step.positions);
            size.write(step.size);
            if let Some(collides) = collides {
                collides.write(earliest.is_some());
            }
            if let (Some(contact), Some(earliest)) = (contact, earliest) {
                contact.write(earliest);
            }
        }
        Ok(())
    })
}

/// A size for each vertex, such that the motion of all vertices is certified to be free of contact: the
/// sizes, from 0 to 1, are written to `sizes`, and the positions at the end to `positions`.
///
/// The motion from `x0` to `positions`, as they are, has been decided exactly: the pairs in `blocked` touch,
/// and no others. They touch at t = 0, or their vertices that are not pinned stay at the start. `pinned` has
/// the `pinned_count` vertices that go all the way, such as the vertices of obstacles; it may be null for 0.
/// Without pinned vertices, no size is below the size of `exact_ccd_detector_free_step`.
///
/// A contact at time t holds back the vertices that approach, in the first round by the factor `keep` t,
/// for 0 < `keep` <= 1; docs/steps.md has the rule. `rounds` is the number of searches for contact.
///
/// `sizes` has room for `vertex_count` numbers, and `positions` for as many points; `positions` may be
/// `x0` or `x1`. The list `blocked` is freed with `exact_ccd_pairs_free`. A mesh that is pierced at `x0`
/// may be free of contact, as in `exact_ccd_detector_collides`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_free_steps(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    pinned: *const u32,
    pinned_count: usize,
    keep: f64,
    sizes: *mut f64,
    positions: *mut f64,
    rounds: *mut usize,
    blocked: *mut *mut Pairs,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise. The results are written after
        // the last use of the positions, which may be the same memory.
        unsafe {
            let (detector, [x0, x1]) = with_ends(detector, x0, x1, vertex_count)?;
            let (rounds, blocked) = (Out::new("rounds", rounds)?, Out::new("blocked", blocked)?);
            let pinned = array("pinned", pinned, pinned_count)?;
            let options = detector.free_step_options(keep);
            let steps = detector.run(|detector| Ok(detector.free_steps(x0, x1, pinned, &options)?))?;
            let points = places("positions", positions.cast::<Point>(), vertex_count)?;
            fill(places("sizes", sizes, vertex_count)?, steps.sizes);
            fill(points, steps.positions);
            rounds.write(steps.rounds);
            let mesh = detector.inner.mesh();
            let list = steps.blocked.iter().map(|&pair| Pair::of(mesh, pair)).collect();
            blocked.give(Pairs(list));
        }
        Ok(())
    })
}
