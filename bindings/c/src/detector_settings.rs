//! The settings of a detector: its distance, and the pairs that can collide.

use core::ffi::c_void;

use exact_ccd::separation::{Separation, Thickness};
use exact_ccd_mesh::MinDistance;

use crate::border::call;
use crate::detector::Detector;
use crate::error::{Error, Status};
use crate::pointers::{array, reference_mut};

/// Decides if two vertices can collide; called from several threads at the same time. Two primitives
/// can collide if any vertex of one can collide with any vertex of the other, the rule of the IPC
/// Toolkit. Must return: no exception may leave it.
pub type CanCollide = Option<unsafe extern "C" fn(u32, u32, *mut c_void) -> bool>;

/// Decides if two primitives, given by their vertices, can collide; called from several threads at the
/// same time. The numbers of vertices are 1 and 3, 2 and 2, 1 and 2, or 1 and 1, as in the kinds of
/// query; at rest 2 and 3, an edge and a face. Must return: no exception may leave it.
pub type PairCanCollide =
    Option<unsafe extern "C" fn(*const u32, usize, *const u32, usize, *mut c_void) -> bool>;

/// Pairs count as in contact from this distance on: a finite number of at least 0, which is the
/// default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_min_distance(
    detector: *mut Detector,
    min_distance: f64,
) -> Status {
    call(|| {
        let min_distance = MinDistance::uniform(Separation::new(min_distance)?);
        // SAFETY: the documentation of the function states the promise.
        let Detector(detector) = unsafe { reference_mut("detector", detector)? };
        Ok(detector.set_min_distance(min_distance)?)
    })
}

/// A thickness for each of the `vertex_count` vertices. That of a primitive is the largest of its
/// vertices; pairs count as in contact from the sum of both on, rounded up.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_thickness(
    detector: *mut Detector,
    thickness: *const f64,
    vertex_count: usize,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (Detector(detector), thickness) = unsafe {
            let detector = reference_mut("detector", detector)?;
            (detector, array("thickness", thickness, vertex_count)?)
        };
        let min_distance = MinDistance::thickness(Thickness::new(thickness)?);
        Ok(detector.set_min_distance(min_distance)?)
    })
}

/// A uniform distance as in `exact_ccd_detector_set_min_distance`, and a smaller one for pairs that
/// start within it: these are in contact only if they come within `inner_distance`. For a line search
/// that has to move on from there.
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
        let Detector(detector) = unsafe { reference_mut("detector", detector)? };
        Ok(detector.set_min_distance(min_distance)?)
    })
}

/// Only primitives of different groups can collide; `groups` has a number for each of the
/// `vertex_count` vertices. It replaces an earlier rule.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_groups(
    detector: *mut Detector,
    groups: *const u32,
    vertex_count: usize,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (Detector(detector), groups) = unsafe {
            let detector = reference_mut("detector", detector)?;
            (detector, array("groups", groups, vertex_count)?)
        };
        if groups.len() != detector.mesh().vertex_count() {
            return Err(Error::argument(format_args!(
                "{} groups, expected one for each of the {} vertices",
                groups.len(),
                detector.mesh().vertex_count()
            )));
        }
        detector.set_can_collide(exact_ccd_mesh::CanCollide::different_groups(groups.to_vec()));
        Ok(())
    })
}

/// Only primitives that the callback allows can collide; all, if it is null. It replaces an earlier
/// rule. `data` is passed on to the callback, which is called as long as the detector exists.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_can_collide(
    detector: *mut Detector,
    can_collide: CanCollide,
    data: *mut c_void,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let Detector(detector) = unsafe { reference_mut("detector", detector)? };
        let data = Data(data);
        detector.set_can_collide(match can_collide {
            None => exact_ccd_mesh::CanCollide::all(),
            Some(callback) => exact_ccd_mesh::CanCollide::any_vertices(move |a, b| {
                // SAFETY: the caller's promise.
                unsafe { callback(a, b, data.get()) }
            }),
        });
        Ok(())
    })
}

/// `exact_ccd_detector_set_can_collide` for a callback that decides about whole primitives.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_pair_can_collide(
    detector: *mut Detector,
    can_collide: PairCanCollide,
    data: *mut c_void,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let Detector(detector) = unsafe { reference_mut("detector", detector)? };
        let data = Data(data);
        detector.set_can_collide(match can_collide {
            None => exact_ccd_mesh::CanCollide::all(),
            Some(callback) => exact_ccd_mesh::CanCollide::new(move |a, b| {
                // SAFETY: the caller's promise.
                unsafe { callback(a.as_ptr(), a.len(), b.as_ptr(), b.len(), data.get()) }
            }),
        });
        Ok(())
    })
}

/// The data of the caller, who has promised that the callback can be called on any thread.
struct Data(*mut c_void);

impl Data {
    fn get(&self) -> *mut c_void {
        self.0
    }
}

// SAFETY: the pointer is only passed on, to a callback that can be called on any thread.
unsafe impl Send for Data {}
// SAFETY: as above.
unsafe impl Sync for Data {}
