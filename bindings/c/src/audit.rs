//! The certificate of a sequence of frames.

use std::sync::Arc;

use exact_ccd::Separation;
use exact_ccd_mesh::{Frame, MinDistance, TriangleMesh, Violation};

use crate::border::call;
use crate::contact::Contact;
use crate::error::Status;
use crate::mesh::Mesh;
use crate::pointers::{Out, free, positions, reference, reference_mut};
use crate::threads::Threads;

/// Examines the frames of a mesh one after the other, between which vertices move in straight lines.
pub struct Audit {
    mesh: Arc<TriangleMesh>,
    audit: exact_ccd_mesh::Audit,
    threads: Threads,
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
        let (Mesh(mesh), audit) = unsafe { (reference("mesh", mesh)?, Out::new("audit", audit)?) };
        audit.give(Audit {
            mesh: mesh.clone(),
            audit: exact_ccd_mesh::Audit::with_min_distance(min_distance),
            threads: Threads::default(),
        });
        Ok(())
    })
}

/// The number of threads of an audit, as in `exact_ccd_detector_set_threads`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_audit_set_threads(audit: *mut Audit, count: u32) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let audit = unsafe { reference_mut("audit", audit)? };
        audit.threads = Threads::new(count)?;
        Ok(())
    })
}

/// Examines the next frame, and the step that leads to it. The first frame is examined at rest.
/// `contact` is written unless the result is `EXACT_CCD_AUDIT_RESULT_FREE`.
///
/// For an intersection, `contact->kind` is `EXACT_CCD_KIND_EDGE_FACE`, `contact->first` the edge and
/// `contact->second` the face; the vertices are 4294967295, and all other numbers 0. A contact is in the
/// step from the frame before: its time is 0 there and 1 at this frame; in the first frame it is 0.
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
            let (result, contact) = (Out::new("result", result)?, Out::new("contact", contact)?);
            (audit, positions("x", x, vertex_count)?, result, contact)
        };
        let Audit { mesh, audit, threads } = audit;
        let last = audit.last().map(|last| last.positions.clone());
        let violation = threads.run(|| {
            let positions = x.to_vec();
            Ok(match &last {
                None => audit.examine(Frame {
                    mesh: mesh.as_ref().clone(),
                    positions,
                })?,
                Some(_) => audit.examine_positions(positions)?,
            })
        })?;
        result.write(match violation {
            None => AuditResult::Free,
            Some(Violation::Contact { contact: found, .. }) => {
                let start = last.as_deref().unwrap_or(x);
                contact.write(Contact::of(mesh, [start, x], &found));
                AuditResult::Contact
            }
            Some(Violation::Intersection { intersection, .. }) => {
                contact.write(Contact::of_intersection(intersection.edge, intersection.face));
                AuditResult::Intersection
            }
        });
        Ok(())
    })
}

/// Frees an audit. Null is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_audit_free(audit: *mut Audit) {
    // SAFETY: the caller's promise.
    unsafe { free(audit) }
}
