//! Contact in the steps of one mesh.

use core::ffi::c_void;

use std::mem;

use exact_ccd::Point;
use exact_ccd::separation::{Separation, Thickness};
use exact_ccd_mesh::{FreeStepOptions, MinDistance, intersections};

use crate::border::call;
use crate::contact::Contact;
use crate::contacts::Contacts;
use crate::error::{Error, Status};
use crate::mesh::Mesh;
use crate::pointers::{array, array_mut, reference, reference_mut};

/// Finds contact in successive steps of one mesh. It keeps memory from step to step, and no answer
/// depends on earlier steps.
pub struct Detector(exact_ccd_mesh::Detector);

impl Detector {
    /// Replaces the detector by one with another setting.
    fn set(&mut self, setting: impl FnOnce(exact_ccd_mesh::Detector) -> exact_ccd_mesh::Detector) {
        let placeholder = exact_ccd_mesh::Detector::new(self.0.mesh().clone());
        self.0 = setting(mem::replace(&mut self.0, placeholder));
    }

    /// Keeps the old distance in case of an error.
    fn set_min_distance(&mut self, min_distance: MinDistance) -> Result<(), Error> {
        exact_ccd_mesh::Detector::new(self.0.mesh().clone()).with_min_distance(min_distance.clone())?;
        // Cannot panic: the mesh of the detector takes the distance.
        self.set(|detector| {
            detector
                .with_min_distance(min_distance)
                .expect("the distance fits the mesh")
        });
        Ok(())
    }
}

/// Decides if two vertices can collide; called from several threads at the same time. Two primitives
/// can collide if any vertex of one can collide with any vertex of the other, the rule of the IPC
/// Toolkit.
pub type CanCollide = Option<unsafe extern "C" fn(u32, u32, *mut c_void) -> bool>;

/// The detector for steps of a mesh, to be freed with `exact_ccd_detector_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_new(mesh: *const Mesh, detector: *mut *mut Detector) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (Mesh(mesh), detector) =
            unsafe { (reference("mesh", mesh)?, reference_mut("detector", detector)?) };
        let new = exact_ccd_mesh::Detector::new(mesh.clone());
        *detector = Box::into_raw(Box::new(Detector(new)));
        Ok(())
    })
}

/// Frees a detector. Null is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_free(detector: *mut Detector) {
    if !detector.is_null() {
        // SAFETY: made by `exact_ccd_detector_new`, and freed once: the caller's promise.
        drop(unsafe { Box::from_raw(detector) });
    }
}

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
        unsafe { reference_mut("detector", detector)? }.set_min_distance(min_distance)
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
        let (detector, thickness) = unsafe {
            let detector = reference_mut("detector", detector)?;
            (detector, array("thickness", thickness, vertex_count)?)
        };
        detector.set_min_distance(MinDistance::thickness(Thickness::new(thickness)?))
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
        unsafe { reference_mut("detector", detector)? }.set_min_distance(min_distance)
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
        let (detector, groups) = unsafe {
            let detector = reference_mut("detector", detector)?;
            (detector, array("groups", groups, vertex_count)?)
        };
        let can_collide = exact_ccd_mesh::CanCollide::different_groups(groups.to_vec());
        detector.set(|detector| detector.with_can_collide(can_collide));
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
    /// The data of the caller, who has promised that the callback can be called on any thread.
    struct Data(*mut c_void);
    // SAFETY: the pointer is only passed on, to a callback that can be called on any thread.
    unsafe impl Send for Data {}
    // SAFETY: as above.
    unsafe impl Sync for Data {}

    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let detector = unsafe { reference_mut("detector", detector)? };
        let data = Data(data);
        let can_collide = match can_collide {
            None => exact_ccd_mesh::CanCollide::all(),
            Some(callback) => exact_ccd_mesh::CanCollide::any_vertices(move |a, b| {
                let data = &data;
                // SAFETY: the caller's promise.
                unsafe { callback(a, b, data.0) }
            }),
        };
        detector.set(|detector| detector.with_can_collide(can_collide));
        Ok(())
    })
}

/// Decides if a step is free of contact. `x0` and `x1` are the positions of the `vertex_count`
/// vertices at t = 0 and t = 1. Ends soon after the first contact found.
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
        let (Detector(detector), x0, x1, is_free) = unsafe {
            let detector = reference_mut("detector", detector)?;
            let is_free = reference_mut("is_free", is_free)?;
            (
                detector,
                positions("x0", x0, vertex_count)?,
                positions("x1", x1, vertex_count)?,
                is_free,
            )
        };
        *is_free = detector.is_free(x0, x1)?;
        Ok(())
    })
}

/// The earliest contact of a step; `contact` is written only if there is one. Positions as in
/// `exact_ccd_detector_is_free`.
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
        let (Detector(detector), x0, x1, is_found, contact) = unsafe {
            let detector = reference_mut("detector", detector)?;
            let (x0, x1) = (
                positions("x0", x0, vertex_count)?,
                positions("x1", x1, vertex_count)?,
            );
            let is_found = reference_mut("is_found", is_found)?;
            (detector, x0, x1, is_found, reference_mut("contact", contact)?)
        };
        let earliest = detector.earliest_contact(x0, x1)?;
        *is_found = earliest.is_some();
        if let Some(earliest) = &earliest {
            *contact = Contact::of(detector.mesh(), earliest);
        }
        Ok(())
    })
}

/// The contacts of a step whose first time is not after `until`, the earliest first; all for 1. The
/// list is freed with `exact_ccd_contacts_free`. Positions as in `exact_ccd_detector_is_free`.
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
        let (Detector(detector), x0, x1, contacts) = unsafe {
            let detector = reference_mut("detector", detector)?;
            let contacts = reference_mut("contacts", contacts)?;
            (
                detector,
                positions("x0", x0, vertex_count)?,
                positions("x1", x1, vertex_count)?,
                contacts,
            )
        };
        let found = detector.contacts(x0, x1, until)?;
        let mesh = detector.mesh();
        let list = found.iter().map(|contact| Contact::of(mesh, contact)).collect();
        *contacts = Box::into_raw(Box::new(Contacts(list)));
        Ok(())
    })
}

/// A step that is certified to be free of contact: its size, from 0 to 1, and the positions at its
/// end, which are written to `positions`.
///
/// The size is at most `keep` times the time of impact of the full step, for 0 < `keep` <= 1, and 1
/// if the full step is free. If it is 0, the mesh is in contact at the start, and no motion is
/// certified. `positions` has room for `vertex_count` points, and may be `x0` or `x1`.
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
            let Detector(detector) = reference_mut("detector", detector)?;
            let size = reference_mut("size", size)?;
            let step = {
                let x0 = self::positions("x0", x0, vertex_count)?;
                let x1 = self::positions("x1", x1, vertex_count)?;
                detector.free_step(x0, x1, &FreeStepOptions::default().with_keep(keep))?
            };
            array_mut("positions", positions.cast::<Point>(), vertex_count)?.copy_from_slice(&step.positions);
            *size = step.size;
        }
        Ok(())
    })
}

/// Decides if a mesh at rest passes through itself: if an edge and a face without a common vertex
/// have a common point. `edge` and `face` are the first such pair; both may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_has_intersections(
    mesh: *const Mesh,
    x: *const f64,
    vertex_count: usize,
    has_intersections: *mut bool,
    edge: *mut u32,
    face: *mut u32,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        unsafe {
            let Mesh(mesh) = reference("mesh", mesh)?;
            let x = positions("x", x, vertex_count)?;
            let has_intersections = reference_mut("has_intersections", has_intersections)?;
            let found = intersections(mesh, x)?;
            *has_intersections = !found.is_empty();
            if let Some(first) = found.first() {
                if let Ok(edge) = reference_mut("edge", edge) {
                    *edge = first.edge;
                }
                if let Ok(face) = reference_mut("face", face) {
                    *face = first.face;
                }
            }
        }
        Ok(())
    })
}

/// The positions of vertices.
///
/// # Safety
/// `pointer` is null, or points to `count` points that nobody changes during the call.
pub(crate) unsafe fn positions<'a>(
    name: &str,
    pointer: *const f64,
    count: usize,
) -> Result<&'a [Point], Error> {
    // SAFETY: a point is an array of three `double`.
    unsafe { array(name, pointer.cast::<Point>(), count) }
}
