//! The callbacks of a detector: the pairs that can collide.

use core::ffi::c_void;

use crate::border::call;
use crate::detector::Detector;
use crate::error::Status;
use crate::pointers::reference_mut;

/// Decides if two vertices can collide; called from several threads at the same time. Two primitives
/// can collide if any vertex of one can collide with any vertex of the other, the rule of the IPC
/// Toolkit. Must return: no exception may leave it.
pub type CanCollide = Option<unsafe extern "C" fn(u32, u32, *mut c_void) -> bool>;

/// Decides if two primitives, given by their vertices, can collide; called from several threads at the
/// same time. The numbers of vertices are 1 and 3, 2 and 2, 1 and 2, or 1 and 1, as in the kinds of
/// query; at rest 2 and 3, an edge and a face. Must return: no exception may leave it.
pub type PairCanCollide =
    Option<unsafe extern "C" fn(*const u32, usize, *const u32, usize, *mut c_void) -> bool>;

/// Frees the data of a callback. Must return: no exception may leave it.
pub type Destroy = Option<unsafe extern "C" fn(*mut c_void)>;

/// Only primitives that the callback allows can collide; all, if it is null. It replaces an earlier
/// rule. `data` is passed on to the callback, which is called as long as it is the rule of the detector.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_can_collide(
    detector: *mut Detector,
    can_collide: CanCollide,
    data: *mut c_void,
) -> Status {
    // SAFETY: the caller's promise.
    unsafe { exact_ccd_detector_set_can_collide_owned(detector, can_collide, data, None) }
}

/// `exact_ccd_detector_set_can_collide` with data that belongs to the detector: `destroy` is called with
/// it once, when another rule replaces this one or the detector is freed; for a null callback, before
/// this call returns. If the call fails, the data belongs to the caller. `destroy` may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_can_collide_owned(
    detector: *mut Detector,
    can_collide: CanCollide,
    data: *mut c_void,
    destroy: Destroy,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let detector = unsafe { reference_mut("detector", detector)? };
        let data = Data { data, destroy };
        detector.inner.set_can_collide(match can_collide {
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
    // SAFETY: the caller's promise.
    unsafe { exact_ccd_detector_set_pair_can_collide_owned(detector, can_collide, data, None) }
}

/// `exact_ccd_detector_set_can_collide_owned` for a callback that decides about whole primitives.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_set_pair_can_collide_owned(
    detector: *mut Detector,
    can_collide: PairCanCollide,
    data: *mut c_void,
    destroy: Destroy,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let detector = unsafe { reference_mut("detector", detector)? };
        let data = Data { data, destroy };
        detector.inner.set_can_collide(match can_collide {
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
struct Data {
    data: *mut c_void,
    destroy: Destroy,
}

impl Data {
    fn get(&self) -> *mut c_void {
        self.data
    }
}

impl Drop for Data {
    fn drop(&mut self) {
        if let Some(destroy) = self.destroy {
            // SAFETY: the caller's promise; a value is dropped once.
            unsafe { destroy(self.data) }
        }
    }
}

// SAFETY: the pointer is only passed on, to callbacks that can be called on any thread.
unsafe impl Send for Data {}
// SAFETY: as above.
unsafe impl Sync for Data {}
