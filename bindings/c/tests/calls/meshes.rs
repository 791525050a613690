//! Meshes: the answers of a detector agree, and the step that it certifies is free; the audit of two
//! frames agrees with both.

use core::ptr;

use arbitrary::{Result, Unstructured};
use exact_ccd_c::{
    AuditResult, Contact, Contacts, Detector, Mesh, Pairs, exact_ccd_audit_examine, exact_ccd_audit_free,
    exact_ccd_audit_new, exact_ccd_contacts_data, exact_ccd_contacts_free, exact_ccd_detector_collides,
    exact_ccd_detector_collision, exact_ccd_detector_collisions, exact_ccd_detector_free,
    exact_ccd_detector_free_step, exact_ccd_detector_free_steps, exact_ccd_detector_has_intersections,
    exact_ccd_detector_new, exact_ccd_detector_set_groups, exact_ccd_detector_set_inner_distance,
    exact_ccd_detector_set_min_distance, exact_ccd_detector_set_thickness, exact_ccd_mesh_free,
    exact_ccd_mesh_new, exact_ccd_pairs_data, exact_ccd_pairs_free,
};

use super::{input, succeeds};

/// Returns true if a step has contact.
pub(super) fn check(bytes: &mut Unstructured<'_>) -> Result<bool> {
    let vertices = bytes.int_in_range(0..=9)?;
    let face_count = bytes.int_in_range(0..=4)?;
    let edge_count = bytes.int_in_range(0..=2)?;
    let faces = input::indices(bytes, 3 * face_count, vertices)?;
    let edges = input::indices(bytes, 2 * edge_count, vertices)?;
    let (mut mesh, mut detector) = (ptr::null_mut(), ptr::null_mut());
    // SAFETY: the arrays have the lengths that are passed on, and handles are freed once.
    unsafe {
        let (faces, edges) = (faces.as_ptr(), edges.as_ptr());
        let status = exact_ccd_mesh_new(vertices, faces, face_count, edges, edge_count, &raw mut mesh);
        assert_eq!(succeeds(status), !mesh.is_null());
        let status = exact_ccd_detector_new(mesh, &raw mut detector);
        assert_eq!(succeeds(status), !mesh.is_null());
        let result = if mesh.is_null() {
            Ok(false)
        } else {
            steps(bytes, vertices, mesh, detector)
        };
        exact_ccd_detector_free(detector);
        exact_ccd_mesh_free(mesh);
        result
    }
}

/// # Safety
/// The handles are valid.
unsafe fn steps(
    bytes: &mut Unstructured<'_>,
    vertices: usize,
    mesh: *const Mesh,
    detector: *mut Detector,
) -> Result<bool> {
    let (x0, x1) = (input::points(bytes, vertices)?, input::points(bytes, vertices)?);
    let d = input::distance(bytes)?;
    // SAFETY: the arrays have the lengths that are passed on.
    unsafe {
        let is_plain = set(bytes, vertices, detector, d)?;
        let earliest = answers(detector, &x0, &x1);
        if is_plain && let Some(earliest) = earliest {
            audit(mesh, detector, d, &x0, &x1, earliest);
        }
        Ok(earliest.is_some_and(|time| time <= 1.0))
    }
}

/// Sets the distance `d`, and one other option. Returns true if the distance alone is set.
///
/// # Safety
/// The handle is valid.
unsafe fn set(
    bytes: &mut Unstructured<'_>,
    vertices: usize,
    detector: *mut Detector,
    d: f64,
) -> Result<bool> {
    let thickness = (0..vertices)
        .map(|_| input::distance(bytes))
        .collect::<Result<Vec<f64>>>()?;
    let groups = input::indices(bytes, vertices, 3)?;
    let option = bytes.int_in_range(0..=5)?;
    let inner = input::distance(bytes)?;
    // SAFETY: the arrays have the lengths that are passed on.
    let [first, second] = unsafe {
        [
            exact_ccd_detector_set_min_distance(detector, d),
            match option {
                0 => exact_ccd_detector_set_thickness(detector, thickness.as_ptr(), vertices),
                1 => exact_ccd_detector_set_inner_distance(detector, d, inner),
                2 => exact_ccd_detector_set_groups(detector, groups.as_ptr(), vertices),
                _ => exact_ccd_detector_set_min_distance(detector, d),
            },
        ]
    };
    let is_set = succeeds(first);
    succeeds(second);
    Ok(is_set && option > 2)
}

/// The time of the earliest contact, 2 if the step is free; none if the positions are no step.
///
/// # Safety
/// The handle is valid, and of a mesh with as many vertices.
unsafe fn answers(detector: *mut Detector, x0: &[f64], x1: &[f64]) -> Option<f64> {
    let vertices = x0.len() / 3;
    let (from, to) = (x0.as_ptr(), x1.as_ptr());
    let (mut collides, mut is_found, mut stops, mut size, mut rounds) = (false, false, false, -1.0, 99);
    let (mut contact, mut stop) = (Contact::default(), Contact::default());
    let mut list: *mut Contacts = ptr::null_mut();
    let mut blocked: *mut Pairs = ptr::null_mut();
    let (mut positions, mut sizes, mut ends) =
        (vec![0.0; x0.len()], vec![-1.0; vertices], vec![0.0; x0.len()]);
    // SAFETY: the arrays have the lengths that are passed on, and the lists are freed once.
    unsafe {
        let statuses = [
            exact_ccd_detector_collides(detector, from, to, vertices, 1.0, &raw mut collides),
            exact_ccd_detector_collision(
                detector,
                from,
                to,
                vertices,
                1.0,
                &raw mut is_found,
                &raw mut contact,
            ),
            exact_ccd_detector_collisions(detector, from, to, vertices, 1.0, &raw mut list),
            exact_ccd_detector_free_step(
                detector,
                from,
                to,
                vertices,
                0.5,
                &raw mut size,
                positions.as_mut_ptr(),
                &raw mut stops,
                &raw mut stop,
            ),
            exact_ccd_detector_free_steps(
                detector,
                from,
                to,
                vertices,
                ptr::null(),
                0,
                0.5,
                sizes.as_mut_ptr(),
                ends.as_mut_ptr(),
                &raw mut rounds,
                &raw mut blocked,
            ),
        ];
        assert_eq!(statuses, [statuses[0]; 5]);
        if !succeeds(statuses[0]) {
            assert!(!collides && !is_found && !stops && size == -1.0 && list.is_null());
            assert!(sizes.iter().all(|&size| size == -1.0) && rounds == 99 && blocked.is_null());
            return None;
        }
        let (mut data, mut count) = (ptr::null(), 0);
        assert!(succeeds(exact_ccd_contacts_data(
            list,
            &raw mut data,
            &raw mut count
        )));
        assert_eq!([is_found, stops, count > 0], [collides; 3]);
        assert_eq!(stop, contact);
        if is_found {
            assert_eq!((*data).impact.time, contact.impact.time);
        }
        exact_ccd_contacts_free(list);
        if size > 0.0 {
            assert!(if collides {
                size <= 0.5 * contact.impact.time
            } else {
                size == 1.0
            });
            assert!(is_free(detector, x0, &positions));
        }
        let (mut data, mut count) = (ptr::null(), 0);
        assert!(succeeds(exact_ccd_pairs_data(
            blocked,
            &raw mut data,
            &raw mut count
        )));
        exact_ccd_pairs_free(blocked);
        assert!(sizes.iter().all(|&of_vertex| (size..=1.0).contains(&of_vertex)));
        assert_eq!(is_free(detector, x0, &ends), count == 0);
        Some(if is_found { contact.impact.time } else { 2.0 })
    }
}

/// # Safety
/// The handle is valid, and of a mesh with as many vertices.
unsafe fn is_free(detector: *mut Detector, x0: &[f64], x1: &[f64]) -> bool {
    let mut collides = false;
    let (from, to) = (x0.as_ptr(), x1.as_ptr());
    // SAFETY: the arrays have the lengths that are passed on.
    let status =
        unsafe { exact_ccd_detector_collides(detector, from, to, x0.len() / 3, 1.0, &raw mut collides) };
    assert!(succeeds(status));
    !collides
}

/// # Safety
/// The handles are valid, and of a mesh with as many vertices.
unsafe fn audit(mesh: *const Mesh, detector: *const Detector, d: f64, x0: &[f64], x1: &[f64], earliest: f64) {
    let vertices = x0.len() / 3;
    let mut audit = ptr::null_mut();
    let mut contact = Contact::default();
    let (mut result, mut intersects) = (AuditResult::Free, false);
    // SAFETY: the arrays have the lengths that are passed on, and the audit is freed once.
    unsafe {
        let x = x0.as_ptr();
        let null = ptr::null_mut();
        assert!(succeeds(exact_ccd_detector_has_intersections(
            detector,
            x,
            vertices,
            &raw mut intersects,
            null,
            null
        )));
        assert!(succeeds(exact_ccd_audit_new(mesh, d, &raw mut audit)));
        let status = exact_ccd_audit_examine(audit, x, vertices, &raw mut result, &raw mut contact);
        assert!(succeeds(status));
        // An edge that only touches a face is a contact.
        assert!(result != AuditResult::Intersection || intersects);
        assert!(result != AuditResult::Free || !intersects);
        if result == AuditResult::Free {
            let status =
                exact_ccd_audit_examine(audit, x1.as_ptr(), vertices, &raw mut result, &raw mut contact);
            assert!(succeeds(status));
            assert_eq!(result == AuditResult::Contact, earliest <= 1.0);
            assert!(result != AuditResult::Contact || contact.impact.time == earliest);
        } else if result == AuditResult::Contact {
            assert_eq!(earliest, 0.0);
        }
        exact_ccd_audit_free(audit);
    }
}
