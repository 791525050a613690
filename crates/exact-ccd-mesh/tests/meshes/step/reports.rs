//! Reports of particular steps.

use std::sync::atomic::{AtomicUsize, Ordering};

use exact_ccd::{AnyKind, CONTACT, VertexFace};
use exact_ccd_mesh::{Bvh, Pair, PairCounts, Point, StepReport, TriangleMesh, step};

use super::motions::falling_sheet;
use super::properties::assert_searches_agree;
use super::{motion, report};
use crate::contacts::scene::on_threads;

#[test]
fn the_report_is_the_same_on_any_number_of_threads() {
    let motion = falling_sheet();
    let reports = [1, 2, 5].map(|threads| {
        on_threads(threads, || {
            let report = report(&motion, &Bvh);
            assert_searches_agree(&motion, &report);
            report
        })
    });
    // Enough for several batches on every thread.
    assert!(
        reports[0].candidates[AnyKind::VertexFace] > 10_000
            && reports[0].candidates[AnyKind::EdgeEdge] > 10_000
    );
    assert_eq!(reports[0], reports[1]);
    assert_eq!(reports[0], reports[2]);
}

#[test]
fn among_contacts_at_the_same_time_the_least_pair_is_named() {
    let report = report(&falling_sheet(), &Bvh);
    assert!(report.colliding[AnyKind::VertexFace] > 1000);
    let earliest = report.earliest.unwrap();
    // Vertex 0 falls from or onto the corner of the first face of the other sheet, the first of its
    // 24 × 24 × 2.
    let face = 24 * 24 * 2;
    assert_eq!(earliest.pair, Pair::VertexFace { vertex: 0, face });
    assert_eq!(earliest.impact.time.lower(), 1.0_f64 / 3.0);
    assert_eq!(report.touching, PairCounts::default());
}

#[test]
fn neighbours_are_left_out() {
    // A tetrahedron whose corners coincide.
    let corners = vec![[0.0; 3]; 4];
    let faces = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let motion = motion(corners.clone(), corners, faces);
    let report = report(&motion, &Bvh);
    // Each vertex and the face opposite, each edge and the edge opposite.
    let mut opposite = PairCounts::default();
    (opposite[AnyKind::VertexFace], opposite[AnyKind::EdgeEdge]) = (4, 3);
    assert_eq!(report.candidates, opposite);
    assert_eq!(report.touching, opposite);
}

#[test]
fn one_face_alone_is_free() {
    let flips = motion(
        vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        vec![[1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
        vec![[0, 1, 2]],
    );
    let report = report(&flips, &Bvh);
    assert!(report.is_free());
    assert_eq!(report.time_of_impact(), None);
    assert_eq!(report.candidates.total(), 0);
}

#[test]
fn no_mesh_is_free() {
    let nothing = motion(vec![], vec![], vec![]);
    assert!(report(&nothing, &Bvh).is_free());
    let point = motion(vec![[0.0; 3]], vec![[0.0; 3]], vec![]);
    assert!(report(&point, &Bvh).is_free());
}

#[test]
fn points_that_coincide_touch() {
    let (a, b) = ([0.0; 3], [1.0, 0.0, 0.0]);
    let points = motion(vec![a, b, a], vec![a, a, b], vec![]);
    let report = report(&points, &Bvh);
    assert_eq!(
        (
            report.colliding[AnyKind::VertexVertex],
            report.touching[AnyKind::VertexVertex]
        ),
        (3, 1)
    );
    let earliest = report.earliest.unwrap();
    assert_eq!(earliest.pair, Pair::VertexVertex { a: 0, b: 2 });
    assert!(earliest.impact.touching_at_start());
}

#[test]
fn progress_adds_up_to_the_candidates() {
    let motion = falling_sheet();
    let done = AtomicUsize::new(0);
    let report = StepReport::new(motion.step().unwrap(), &Bvh, &|count| {
        done.fetch_add(count, Ordering::Relaxed);
    });
    assert_eq!(done.into_inner(), report.candidates.total());
}

#[test]
fn positions_that_do_not_fit_are_errors() {
    let mesh = TriangleMesh::new(3, vec![[0, 1, 2]]).unwrap();
    let good = [[0.0; 3]; 3];
    let message = |x0: &[Point], x1: &[Point]| step(&mesh, x0, x1).unwrap_err().to_string();
    assert_eq!(
        message(&good[..2], &good),
        "at the start, 2 positions, expected one for each of 3 vertices"
    );
    assert_eq!(
        message(&good, &[[0.0; 3]; 4]),
        "at the end, 4 positions, expected one for each of 3 vertices"
    );
    let mut bad = good;
    bad[2][1] = f64::NEG_INFINITY;
    assert_eq!(
        message(&bad, &good),
        "at the start, vertex 2 has y = -inf, expected a finite number"
    );
    bad[1][0] = f64::NAN;
    assert_eq!(
        message(&good, &bad),
        "at the end, vertex 1 has x = NaN, expected a finite number"
    );
}

/// Vertex 3 reaches the face just after t = 1/2, vertex 4 just then: both times round down to 1/2.
#[test]
fn exactly_a_time_is_before_just_above_it() {
    let face = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let vertices = |late: f64, punctual: f64| vec![[1.0, 1.0, late], [1.0, 2.0, punctual]];
    let motion = motion(
        [face.to_vec(), vertices(1.0, 1.0)].concat(),
        [face.to_vec(), vertices((-1f64).next_up(), -1.0)].concat(),
        vec![[0, 1, 2]],
    );
    for vertex in [3, 4] {
        let time = motion
            .step()
            .unwrap()
            .query::<VertexFace>([vertex, 0])
            .unwrap()
            .time_of_impact(CONTACT);
        assert_eq!(time, Some(0.5));
    }
    let earliest = report(&motion, &Bvh).earliest.unwrap();
    assert_eq!(earliest.pair, Pair::VertexFace { vertex: 4, face: 0 });
    assert!(earliest.impact.time.is_exact());
}
