//! Certificates: proofs of the answers of a detector or an audit, which another program verifies.

use exact_ccd_certify::{Maker, MakerError, Uncertified};

use crate::audit::Audit;
use crate::border::call;
use crate::detector::{Detector, with_ends};
use crate::error::{Error, Status};
use crate::lists::elements;
use crate::pointers::{Out, free, reference, reference_mut};

/// The bytes of a certificate, which the program `exact-ccd-check` verifies with the mesh files.
/// `docs/certificates.md` has the format.
pub struct Certificate(Vec<u8>);

/// The number of bytes, and a pointer to the first, which is valid until the certificate is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_certificate_data(
    certificate: *const Certificate,
    data: *mut *const u8,
    count: *mut usize,
) -> Status {
    // SAFETY: the documentation of the function states the promise.
    unsafe {
        elements(
            ("certificate", certificate),
            |Certificate(bytes)| bytes,
            data,
            count,
        )
    }
}

/// Frees a certificate. Null is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_certificate_free(certificate: *mut Certificate) {
    // SAFETY: the caller's promise.
    unsafe { free(certificate) }
}

/// The proof of the answer to a step: the step is free of contact until the earliest contact, and has this
/// contact. With `at_rest`, it also proves that no edge passes through a face at `x0`. It has the bytes of
/// `exact-ccd step --certificate`, and is freed with `exact_ccd_certificate_free`. Other arguments as in
/// `exact_ccd_detector_collides`.
///
/// The status is `EXACT_CCD_STATUS_UNCERTIFIED` if some pairs have no proof, `EXACT_CCD_STATUS_CROSSING` if
/// an edge passes through a face where that is to be excluded, and `EXACT_CCD_STATUS_INVALID_ARGUMENT` for a
/// detector with groups, a callback, thicknesses or an inner distance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_detector_certificate(
    detector: *mut Detector,
    x0: *const f64,
    x1: *const f64,
    vertex_count: usize,
    at_rest: bool,
    certificate: *mut *mut Certificate,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let ((detector, [x0, x1]), certificate) = unsafe {
            (
                with_ends(detector, x0, x1, vertex_count)?,
                Out::new("certificate", certificate)?,
            )
        };
        let mut maker = Maker::new(Maker::distance(&detector.min_distance)?);
        let bytes = detector.run(|detector| {
            maker.add_step_of(detector, x0, x1, at_rest)?;
            Ok(maker.finish()?)
        })?;
        certificate.give(Certificate(bytes));
        Ok(())
    })
}

/// Makes a certificate of all frames that follow. No frame may have been examined.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_audit_certify(audit: *mut Audit) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        unsafe { reference_mut("audit", audit)? }.certify()
    })
}

/// The proof of the results of an audit so far, after `exact_ccd_audit_certify`: the bytes of
/// `exact-ccd audit --certificate`, about the frames up to the last one that was examined, or up to the first
/// violation. It is freed with `exact_ccd_certificate_free`.
///
/// The status is `EXACT_CCD_STATUS_UNCERTIFIED` if some pairs have no proof, and if there is nothing to
/// prove: for a single frame, or if the first frame has a violation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_audit_certificate(
    audit: *const Audit,
    certificate: *mut *mut Certificate,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (audit, certificate) =
            unsafe { (reference("audit", audit)?, Out::new("certificate", certificate)?) };
        let bytes = audit.certificate()?;
        certificate.give(Certificate(bytes));
        Ok(())
    })
}

impl From<MakerError> for Error {
    fn from(error: MakerError) -> Self {
        match error {
            MakerError::Step(error) => error.into(),
            MakerError::Rules => Self::argument(error),
            _ => Self::new(Status::InvalidPositions, error),
        }
    }
}

impl From<Uncertified> for Error {
    fn from(error: Uncertified) -> Self {
        Self::new(Status::Uncertified, error)
    }
}
