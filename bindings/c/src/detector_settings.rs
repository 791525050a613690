//! The settings of a detector: its distance, the groups that can collide, its threads, the
//! check of the start.

use exact_ccd::{Separation, Thickness};
use exact_ccd_mesh::MinDistance;

use crate::border::call;
use crate::detector::Detector;
use crate::error::{Error, Status};
use crate::pointers::{array, reference_mut};
use crate::threads::Threads;

/// Pairs count as in contact from this distance on: a finite number of at least 0, which is the
/// default.
///
/// A vertex and an edge of rods that another edge connects are in contact at distance 0 only; `docs/pairs.md`
/// has the reason.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_min_distance(
    detector: *mut Detector,
    min_distance: f64,
) -> Status {
    call(|| {
        let min_distance = MinDistance::uniform(Separation::new(min_distance)?);
        // SAFETY: the documentation of the function states the promise.
        let detector = unsafe { reference_mut("detector", detector)? };
        detector.set_min_distance(min_distance)
    })
}

/// A thickness for each of the `vertex_count` vertices. A primitive has the largest thickness of its
/// vertices. Pairs count as in contact from the sum of both thicknesses on, rounded up.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_thickness(
    detector: *mut Detector,
    thickness: *const f64,
    vertex_count: usize,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, thickness) = unsafe {
            let detector = reference_mut("detector", detector)?;
            (detector, array("thickness", thickness, vertex_count)?)
        };
        let min_distance = MinDistance::thickness(Thickness::new(thickness)?);
        detector.set_min_distance(min_distance)
    })
}

/// A uniform distance as in `exact_ccd_detector_set_min_distance`, and a smaller one for pairs that start
/// within it: these are in contact only if they come within `inner_distance`. So a line search can move on
/// from such a start. An inner distance that is not smaller changes nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_inner_distance(
    detector: *mut Detector,
    min_distance: f64,
    inner_distance: f64,
) -> Status {
    call(|| {
        let min_distance = MinDistance::uniform(Separation::new(min_distance)?);
        let min_distance = min_distance.with_inner(Separation::new(inner_distance)?);
        // SAFETY: the documentation of the function states the promise.
        let detector = unsafe { reference_mut("detector", detector)? };
        detector.set_min_distance(min_distance)
    })
}

/// Primitives all of whose vertices have the same number do not collide; `groups` has a number for each of
/// the `vertex_count` vertices. It replaces an earlier rule.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_groups(
    detector: *mut Detector,
    groups: *const u32,
    vertex_count: usize,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (detector, groups) = unsafe {
            let detector = reference_mut("detector", detector)?;
            (detector, array("groups", groups, vertex_count)?)
        };
        if groups.len() != detector.inner.mesh().vertex_count() {
            return Err(Error::argument(format_args!(
                "{} groups, expected one for each of the {} vertices",
                groups.len(),
                detector.inner.mesh().vertex_count()
            )));
        }
        detector
            .inner
            .set_can_collide(exact_ccd_mesh::CanCollide::different_groups(groups.to_vec()));
        Ok(())
    })
}

/// The number of threads of a detector: from 1 to 1024, or 0 for the number that `exact_ccd_set_threads`
/// has set, which is the default. The number does not change any answer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_threads(detector: *mut Detector, count: u32) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let detector = unsafe { reference_mut("detector", detector)? };
        detector.threads = Threads::new(count)?;
        Ok(())
    })
}

/// Turns the check of the start on or off; it is off in a new detector. With it, an answer about a step
/// has the status `EXACT_CCD_STATUS_CROSSING` if an edge passes through a face at `x0`, among the pairs
/// that can collide; `exact_ccd_last_error_fields` has both. Primitives that merely touch are contacts at
/// t = 0, as always.
///
/// The check is a pass over the mesh at rest. No pass is made if `x0` is, bit for bit, the start of the
/// step before, or, without groups and without a callback, the end of the last step that was found free.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_start_check(detector: *mut Detector, is_on: bool) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let detector = unsafe { reference_mut("detector", detector)? };
        detector.inner.set_start_check(is_on);
        Ok(())
    })
}
