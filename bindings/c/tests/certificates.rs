//! The independent checker accepts certificates through C, which have the same bytes as through Rust.

use core::{ptr, slice};

use exact_ccd::{Point, Separation};
use exact_ccd_c::{
    AuditResult, Certificate, Contact, Status, exact_ccd_audit_certificate, exact_ccd_audit_certify,
    exact_ccd_audit_examine, exact_ccd_audit_free, exact_ccd_audit_new, exact_ccd_certificate_data,
    exact_ccd_certificate_free, exact_ccd_detector_certificate, exact_ccd_detector_free,
    exact_ccd_detector_new, exact_ccd_detector_set_groups, exact_ccd_detector_set_min_distance,
    exact_ccd_mesh_free, exact_ccd_mesh_new,
};
use exact_ccd_certify::Maker;
use exact_ccd_check::check::Proved;
use exact_ccd_check::ply::Frame;
use exact_ccd_mesh::{Detector, TriangleMesh};

const FACES: [[u32; 3]; 2] = [[0, 1, 2], [3, 4, 5]];

/// A triangle above another one, which it reaches at the height 0.
fn at(height: f64) -> Vec<Point> {
    let floor = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
    let falling = [
        [1.0, 1.0, height],
        [1.0, 2.0, height + 4.0],
        [2.0, 1.0, height + 4.0],
    ];
    [floor, falling].concat()
}

fn verify(certificate: &[u8], frames: &[Vec<Point>]) -> Proved {
    let mesh = exact_ccd_check::Mesh::new(6, FACES.to_vec(), &[]).expect("a mesh");
    let frame = |positions: &Vec<Point>| {
        Ok(Frame {
            mesh: mesh.clone(),
            positions: positions.clone(),
        })
    };
    exact_ccd_check::check(certificate, frames.iter().map(frame)).expect("a proof")
}

/// The bytes of a certificate, which is freed.
fn bytes(status: Status, certificate: *mut Certificate) -> Result<Vec<u8>, Status> {
    if status != Status::Ok {
        assert!(certificate.is_null());
        return Err(status);
    }
    let (mut data, mut count) = (ptr::null(), 0);
    // SAFETY: the certificate has been made, and is freed once.
    unsafe {
        assert_eq!(
            exact_ccd_certificate_data(certificate, &raw mut data, &raw mut count),
            Status::Ok
        );
        let bytes = slice::from_raw_parts(data, count).to_vec();
        exact_ccd_certificate_free(certificate);
        Ok(bytes)
    }
}

/// The certificate of a step through C.
fn step(heights: [f64; 2], d: f64, at_rest: bool, groups: Option<&[u32]>) -> Result<Vec<u8>, Status> {
    let [x0, x1] = heights.map(at);
    let (mut mesh, mut detector, mut certificate) = (ptr::null_mut(), ptr::null_mut(), ptr::null_mut());
    // SAFETY: the arrays have the lengths that are passed on, and handles are freed once.
    unsafe {
        let faces = FACES.as_ptr().cast();
        assert_eq!(
            exact_ccd_mesh_new(6, faces, 2, ptr::null(), 0, &raw mut mesh),
            Status::Ok
        );
        assert_eq!(exact_ccd_detector_new(mesh, &raw mut detector), Status::Ok);
        assert_eq!(exact_ccd_detector_set_min_distance(detector, d), Status::Ok);
        if let Some(groups) = groups {
            assert_eq!(
                exact_ccd_detector_set_groups(detector, groups.as_ptr(), 6),
                Status::Ok
            );
        }
        let (x0, x1) = (x0.as_ptr().cast(), x1.as_ptr().cast());
        let status = exact_ccd_detector_certificate(detector, x0, x1, 6, at_rest, &raw mut certificate);
        exact_ccd_detector_free(detector);
        exact_ccd_mesh_free(mesh);
        bytes(status, certificate)
    }
}

/// The certificate of an audit through C.
fn audit(heights: &[f64]) -> Result<Vec<u8>, Status> {
    let (mut mesh, mut audit, mut certificate) = (ptr::null_mut(), ptr::null_mut(), ptr::null_mut());
    let (mut result, mut contact) = (AuditResult::Free, Contact::default());
    // SAFETY: the arrays have the lengths that are passed on, and handles are freed once.
    unsafe {
        let faces = FACES.as_ptr().cast();
        assert_eq!(
            exact_ccd_mesh_new(6, faces, 2, ptr::null(), 0, &raw mut mesh),
            Status::Ok
        );
        assert_eq!(exact_ccd_audit_new(mesh, 0.0, &raw mut audit), Status::Ok);
        assert_eq!(
            exact_ccd_audit_certificate(audit, &raw mut certificate),
            Status::InvalidArgument
        );
        assert_eq!(exact_ccd_audit_certify(audit), Status::Ok);
        for &height in heights {
            let x = at(height);
            let status =
                exact_ccd_audit_examine(audit, x.as_ptr().cast(), 6, &raw mut result, &raw mut contact);
            assert_eq!(status, Status::Ok);
        }
        let too_late = if heights.is_empty() {
            Status::Ok
        } else {
            Status::InvalidArgument
        };
        assert_eq!(exact_ccd_audit_certify(audit), too_late);
        let status = exact_ccd_audit_certificate(audit, &raw mut certificate);
        exact_ccd_audit_free(audit);
        exact_ccd_mesh_free(mesh);
        bytes(status, certificate)
    }
}

#[test]
fn the_certificate_of_a_step_is_accepted_and_that_of_rust() {
    for (heights, d) in [([2.0, 1.0], 0.0), ([2.0, -1.0], 0.0), ([2.0, -1.0], 0.5)] {
        for at_rest in [false, true] {
            let certificate = step(heights, d, at_rest, None).expect("all pairs have a proof");
            let [x0, x1] = heights.map(at);
            let [proved] = verify(&certificate, &[x0.clone(), x1.clone()]).steps[..] else {
                panic!("one step")
            };
            assert_eq!(
                (proved.head.rest, proved.contact.is_some()),
                (at_rest, heights[1] < 0.0)
            );
            let mut maker = Maker::new(Separation::new(d).expect("a distance"));
            let mut detector = Detector::new(TriangleMesh::new(6, FACES.to_vec()).expect("a mesh"));
            maker
                .add_step_of(&mut detector, &x0, &x1, at_rest)
                .expect("a step");
            assert_eq!(maker.finish().as_deref(), Ok(&certificate[..]));
        }
    }
}

#[test]
fn a_step_without_a_certificate_has_a_status() {
    assert_eq!(step([-1.0, -2.0], 0.0, true, None), Err(Status::Crossing));
    assert!(step([-1.0, -1.0], 0.0, false, None).is_ok());
    assert_eq!(
        step([2.0, 1.0], 0.0, true, Some(&[0; 6])),
        Err(Status::InvalidArgument)
    );
    assert_eq!(
        step([f64::NAN, 1.0], 0.0, false, None),
        Err(Status::InvalidPositions)
    );
}

#[test]
fn the_certificate_of_an_audit_ends_with_the_first_violation() {
    let heights = [3.0, 2.0, 1.0, -2.0, 5.0, 6.0];
    let certificate = audit(&heights).expect("all pairs have a proof");
    let steps = verify(
        &certificate,
        &heights[..4].iter().copied().map(at).collect::<Vec<_>>(),
    )
    .steps;
    assert_eq!(
        steps.iter().map(|step| step.head.rest).collect::<Vec<_>>(),
        [true, false, false]
    );
    assert_eq!(steps[2].head.free, Some(1.0 / 3.0));
    for nothing in [&[][..], &[1.0], &[-1.0, 1.0, 2.0], &[0.0, 1.0]] {
        assert_eq!(audit(nothing), Err(Status::Uncertified), "{nothing:?}");
    }
}
