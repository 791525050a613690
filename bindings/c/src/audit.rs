//! The certificate of a sequence of frames.

use exact_ccd::separation::Separation;
use exact_ccd_mesh::{Frame, MinDistance, Violation};

use crate::border::call;
use crate::contact::Contact;
use crate::error::Status;
use crate::mesh::Mesh;
use crate::pointers::{positions, reference, reference_mut};

/// Examines the frames of a mesh one after the other, between which vertices move in straight lines.
pub struct Audit {
    mesh: exact_ccd_mesh::TriangleMesh,
    audit: exact_ccd_mesh::Audit,
}

/// The result of a frame of an audit.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AuditResult {
    /// The mesh does not touch itself between the last frame and this one.
    Free = 0,
    /// An edge meets a face in the first frame.
    Intersection = 1,
    /// Two primitives touch, or come within the distance of the audit.
    Contact = 2,
}

/// An audit of a mesh, to be freed with `exact_ccd_audit_free`. `min_distance` is that of
/// `exact_ccd_detector_set_min_distance`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_audit_new(
    mesh: *const Mesh,
    min_distance: f64,
    audit: *mut *mut Audit,
) -> Status {
    call(|| {
        let min_distance = MinDistance::uniform(Separation::new(min_distance)?);
        // SAFETY: the documentation of the function states the promise.
        let (Mesh(mesh), audit) = unsafe { (reference("mesh", mesh)?, reference_mut("audit", audit)?) };
        *audit = Box::into_raw(Box::new(Audit {
            mesh: mesh.as_ref().clone(),
            audit: exact_ccd_mesh::Audit::with_min_distance(min_distance),
        }));
        Ok(())
    })
}

/// Examines the next frame, and the step that leads to it. The first frame is examined at rest.
///
/// For an intersection, `contact->first` is the edge and `contact->second` the face, and nothing else
/// of it is meaningful. A contact is in the step from the frame before: its time is 0 there and 1 at
/// this frame; in the first frame it is 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_audit_examine(
    audit: *mut Audit,
    x: *const f64,
    vertex_count: usize,
    result: *mut AuditResult,
    contact: *mut Contact,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (audit, x, result, contact) = unsafe {
            let audit = reference_mut("audit", audit)?;
            let (result, contact) = (
                reference_mut("result", result)?,
                reference_mut("contact", contact)?,
            );
            (audit, positions("x", x, vertex_count)?, result, contact)
        };
        let frame = Frame {
            mesh: audit.mesh.clone(),
            positions: x.to_vec(),
        };
        *result = match audit.audit.examine(frame)? {
            None => AuditResult::Free,
            Some(Violation::Contact { contact: found, .. }) => {
                *contact = Contact::of(&audit.mesh, &found);
                AuditResult::Contact
            }
            Some(Violation::Intersection { intersection, .. }) => {
                *contact = Contact::of_intersection(intersection.edge, intersection.face);
                AuditResult::Intersection
            }
        };
        Ok(())
    })
}

/// Frees an audit. Null is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_audit_free(audit: *mut Audit) {
    if !audit.is_null() {
        // SAFETY: made by `exact_ccd_audit_new`, and freed once: the caller's promise.
        drop(unsafe { Box::from_raw(audit) });
    }
}
