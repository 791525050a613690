//! Audits of sequences of frames.

use std::sync::Arc;

use exact_ccd::{Point, Separation};
use exact_ccd_certify::Maker;
use exact_ccd_mesh::{Frame, MinDistance, TriangleMesh, Violation};

use crate::border::call;
use crate::contact::Contact;
use crate::error::{Error, Status};
use crate::mesh::Mesh;
use crate::pointers::{Out, free, positions, reference, reference_mut};
use crate::threads::Threads;

/// Examines the frames of a mesh one after the other, between which vertices move in straight lines.
pub struct Audit {
    mesh: Arc<TriangleMesh>,
    audit: exact_ccd_mesh::Audit,
    min_distance: MinDistance,
    threads: Threads,
    /// The certificate in the making, if it is wanted.
    maker: Option<Maker>,
    has_violation: bool,
}

impl Audit {
    /// Begins a certificate.
    pub(crate) fn certify(&mut self) -> Result<(), Error> {
        if self.audit.frames() > 0 {
            return Err(Error::argument(
                "a certificate begins with the first frame: certify before it",
            ));
        }
        self.maker = Some(Maker::new(Maker::distance(&self.min_distance)?));
        Ok(())
    }

    /// Adds the step from the last frame, if there is one, to the certificate.
    fn add(
        &mut self,
        last: Option<&[Point]>,
        x: &[Point],
        violation: Option<&Violation>,
    ) -> Result<(), Error> {
        let Self {
            mesh,
            audit,
            threads,
            maker,
            has_violation,
            ..
        } = self;
        if let (Some(maker), Some(last), false) = (maker, last, *has_violation) {
            let contact = match violation {
                Some(Violation::Contact { contact, .. }) => Some(contact),
                _ => None,
            };
            let is_first = audit.frames() == 2;
            threads.run(|| Ok(maker.add_step(mesh, [last, x], is_first, contact)?))?;
        }
        *has_violation |= violation.is_some();
        Ok(())
    }

    /// The certificate of the frames so far.
    pub(crate) fn certificate(&self) -> Result<Vec<u8>, Error> {
        let maker = self.maker.clone();
        let maker = maker
            .ok_or_else(|| Error::argument("there is no certificate: certify before the first frame"))?;
        if maker.steps() == 0 {
            let reason =
                "nothing can be proved of a single frame, nor if the mesh touches itself in the first frame";
            return Err(Error::new(Status::Uncertified, reason));
        }
        Ok(maker.finish()?)
    }
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

/// An audit of a mesh, to be freed with `exact_ccd_audit_free`. `min_distance` has the meaning that it has
/// in `exact_ccd_detector_set_min_distance`.
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
            audit: exact_ccd_mesh::Audit::default().with_min_distance(min_distance.clone()),
            min_distance,
            threads: Threads::default(),
            maker: None,
            has_violation: false,
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
/// `contact->second` the face; the vertices are `EXACT_CCD_NONE`, and all other numbers 0. A contact is in
/// the step from the frame before: its time is 0 there and 1 at this frame; in the first frame it is 0.
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
        let last = audit.audit.last().map(|last| last.positions.clone());
        let Audit {
            mesh,
            audit: inner,
            threads,
            ..
        } = audit;
        let violation = threads.run(|| {
            let positions = x.to_vec();
            Ok(match &last {
                None => inner.examine(Frame {
                    mesh: mesh.as_ref().clone(),
                    positions,
                })?,
                Some(_) => inner.examine_positions(positions)?,
            })
        })?;
        audit.add(last.as_deref(), x, violation.as_ref())?;
        let mesh = &audit.mesh;
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
