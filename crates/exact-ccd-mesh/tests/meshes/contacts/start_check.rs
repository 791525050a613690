//! The check of the start against a loop over all edges and faces, and the passes that it makes.

use std::sync::Arc;

use exact_ccd::{CONTACT, EdgeEdge, Query, VertexFace};
use exact_ccd_mesh::{
    Bvh, CanCollide, Detector, FreeStepOptions, Intersection, IntersectionOptions, LineSearchError, Point,
    StepError, TriangleMesh, intersections,
};
use fastrand::Rng;

use super::scene::{Scene, moved};

const FLOOR: [Point; 3] = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];

/// A floor and a face whose lowest vertex is at a height.
fn above(z: f64) -> Vec<Point> {
    [FLOOR, [[1.0, 1.0, z], [1.0, 2.0, z + 4.0], [2.0, 1.0, z + 4.0]]].concat()
}

fn two_faces() -> TriangleMesh {
    TriangleMesh::new(6, vec![[0, 1, 2], [3, 4, 5]]).unwrap()
}

/// The edges and faces that touch.
fn touching(mesh: &TriangleMesh, x: &[Point]) -> Vec<Intersection> {
    intersections(mesh, x, &Bvh, &IntersectionOptions::default()).unwrap()
}

/// The first edge and face that meet without a vertex of one or a side of the other in contact.
fn crossing(mesh: &TriangleMesh, x: &[Point]) -> Option<Intersection> {
    let touches = |&Intersection { edge, face }: &Intersection| {
        let ([a, b], [v1, v2, v3]) = (mesh.edges()[edge as usize], mesh.faces()[face as usize]);
        let at = |vertices: [u32; 4]| vertices.map(|vertex| x[vertex as usize]);
        let in_face = [a, b].into_iter().any(|end| {
            let points = at([end, v1, v2, v3]);
            Query::<VertexFace>::new(points, points)
                .unwrap()
                .collides(CONTACT)
        });
        let on_side = [[v1, v2], [v2, v3], [v3, v1]].into_iter().any(|[v, w]| {
            let points = at([a, b, v, w]);
            Query::<EdgeEdge>::new(points, points).unwrap().collides(CONTACT)
        });
        in_face || on_side
    };
    touching(mesh, x).into_iter().find(|pair| !touches(pair))
}

#[test]
fn every_answer_names_the_edge_and_the_face_at_a_pierced_start() {
    let (pierced, end) = (above(-1.0), above(-1.5));
    let mut off = Detector::new(two_faces());
    assert_eq!(off.collides(&pierced, &end, CONTACT), Ok(false));
    let options = FreeStepOptions::default();
    assert_eq!(off.free_step(&pierced, &end, &options).unwrap().size, 1.0);

    let mut on = off.with_start_check(true);
    let expected = StepError::Crossing {
        edge: 3,
        ends: [3, 4],
        face: 0,
        corners: [0, 1, 2],
    };
    assert_eq!(
        expected.to_string(),
        "at the start, edge 3 (3, 4) passes through face 0 (0, 1, 2): begin at positions where no edge does, \
         or leave this pair out of those that can collide"
    );
    assert_eq!(on.collides(&pierced, &end, CONTACT), Err(expected));
    assert_eq!(on.collides_if(&pierced, &end, CONTACT, |_| true), Err(expected));
    assert_eq!(on.collision(&pierced, &end, CONTACT), Err(expected));
    assert_eq!(on.collisions(&pierced, &end, CONTACT), Err(expected));
    let expected = LineSearchError::Step(expected);
    assert_eq!(on.free_step(&pierced, &end, &options), Err(expected));
    let direction = vec![[0.0, 0.0, -0.5]; 6];
    assert_eq!(on.free_step_along(&pierced, &direction, &options), Err(expected));

    // Without the pair, nothing crosses.
    let mut apart = on.with_can_collide(CanCollide::different_groups(vec![0; 6]));
    assert_eq!(apart.collides(&pierced, &end, CONTACT), Ok(false));
}

/// A vertex in a face and an edge through a side are contacts at t = 0.
#[test]
fn what_touches_at_the_start_is_contact() {
    let mut detector = Detector::new(two_faces()).with_start_check(true);
    let through_a_side = [FLOOR, [[1.0, 0.0, -1.0], [1.0, 0.0, 1.0], [1.0, -1.0, 1.0]]].concat();
    for x in [above(0.0), through_a_side] {
        let contact = detector.collision(&x, &x, CONTACT).unwrap().unwrap();
        assert!(contact.impact.touching_at_start());
        assert_eq!(detector.collides(&x, &x, CONTACT), Ok(true));
    }
}

/// The check alone asks for the pairs that cross; steps from a start that it accepts need no further pass.
#[test]
fn a_crossing_that_does_not_count_is_no_error() {
    let pierced = above(-0.5);
    let mut detector = Detector::new(two_faces());
    assert_eq!(detector.check_start(&pierced, |_| true), Ok(()));
    detector.set_start_check(true);
    let refused = detector.check_start(&pierced, |crossing| crossing.edge == 4);
    assert!(matches!(
        refused,
        Err(StepError::Crossing { edge: 4, face: 0, .. })
    ));
    assert_eq!(detector.check_start(&pierced, |_| false), Ok(()));
    let passes = detector.start_passes();
    assert_eq!(detector.collides(&pierced, &pierced, CONTACT), Ok(false));
    assert_eq!((passes, detector.start_passes()), (2, 2));
}

#[test]
fn known_positions_need_no_pass() {
    let options = FreeStepOptions::default().with_keep(0.5);
    let mut detector = Detector::new(two_faces()).with_start_check(true);
    let mut x = above(8.0);
    for _ in 0..8 {
        // Blocked, then free: both from the same start.
        assert_eq!(detector.collides(&x, &above(-1.0), CONTACT), Ok(true));
        x = detector.free_step(&x, &above(-1.0), &options).unwrap().positions;
        assert_eq!(detector.collision(&x, &x, CONTACT), Ok(None));
    }
    assert_eq!(detector.start_passes(), 1);
    // Other bits, even of equal numbers.
    let negative = x
        .iter()
        .map(|point| point.map(|x| if x == 0.0 { -0.0 } else { x }))
        .collect::<Vec<_>>();
    assert_eq!(detector.collides(&negative, &x, CONTACT), Ok(false));
    assert_eq!(detector.start_passes(), 2);
    // The end is not known after a step that is not free, nor where some pairs or late contacts do not count.
    assert_eq!(detector.collides(&x, &above(-1.0), CONTACT), Ok(true));
    assert_eq!(
        detector.collides_if(&x, &above(-1.0), CONTACT, |_| false),
        Ok(false)
    );
    assert_eq!(detector.collides(&x, &above(-1.0), CONTACT.until(0.0)), Ok(false));
    assert!(matches!(
        detector.collides(&above(-1.0), &x, CONTACT),
        Err(StepError::Crossing { edge: 3, face: 0, .. })
    ));
    assert_eq!(detector.start_passes(), 3);
    // With other pairs, the proofs so far are forgotten.
    detector.set_can_collide(CanCollide::new(|_, _| true));
    assert_eq!(detector.collides(&x, &above(0.5), CONTACT), Ok(false));
    assert_eq!(detector.start_passes(), 4);
    // A predicate might leave out the vertex and the face that came into contact, but not edge and face.
    assert_eq!(detector.collides(&above(0.5), &x, CONTACT), Ok(false));
    assert_eq!(detector.start_passes(), 5);
}

/// Below the floor, by a step in which the only pair that touches is left out.
#[test]
fn a_crossing_that_a_predicate_has_let_through_is_found() {
    let not_the_tip = |a: &[u32], b: &[u32]| a != [3] && b != [3];
    let can_collide = CanCollide::new(not_the_tip);
    let mut detector = Detector::new(two_faces())
        .with_can_collide(can_collide)
        .with_start_check(true);
    assert_eq!(detector.collides(&above(1.0), &above(-1.0), CONTACT), Ok(false));
    assert!(matches!(
        detector.collides(&above(-1.0), &above(-1.0), CONTACT),
        Err(StepError::Crossing { edge: 3, face: 0, .. })
    ));
}

#[test]
fn random_starts_agree_with_a_loop_over_all_edges_and_faces() {
    let mut random = Rng::with_seed(61);
    let (mut pierced, mut touching, mut free) = (0, 0, 0);
    for _ in 0..400 {
        let scene = Scene::pieces(&mut random).0;
        let mut detector = Detector::new(scene.mesh.clone()).with_start_check(true);
        let found = detector.collision(&scene.x0, &scene.x1, CONTACT);
        match crossing(&scene.mesh, &scene.x0) {
            Some(Intersection { edge: e, face: f }) => {
                assert!(
                    matches!(found, Err(StepError::Crossing { edge, face, .. }) if (edge, face) == (e, f))
                );
                pierced += 1;
            }
            None => {
                let expected = Detector::new(scene.mesh.clone()).collision(&scene.x0, &scene.x1, CONTACT);
                assert_eq!(found, expected);
                touching += usize::from(!self::touching(&scene.mesh, &scene.x0).is_empty());
                free += usize::from(found == Ok(None));
            }
        }
    }
    assert!(
        pierced > 50 && touching > 5 && free > 10,
        "{pierced} {touching} {free}"
    );
}

/// From a start without crossings, nothing crosses after any number of free steps.
#[test]
fn free_steps_keep_crossings_away() {
    let mut random = Rng::with_seed(62);
    let options = FreeStepOptions::default();
    let mut blocked = 0;
    for _ in 0..10 {
        let scene = Scene::sheets(&mut random, 3, 0.0, 0.0);
        let mesh = Arc::new(scene.mesh);
        let mut detector = Detector::new(mesh.clone()).with_start_check(true);
        let mut x = scene.x0;
        for _ in 0..10 {
            let end = moved(&mut random, &x, 1.0);
            let taken = detector.free_step(&x, &end, &options).unwrap();
            blocked += usize::from(taken.contact.is_some());
            x = taken.positions;
            assert_eq!(touching(&mesh, &x), []);
        }
        assert_eq!(detector.start_passes(), 1);
    }
    assert!(blocked > 30, "{blocked}");
}

/// The end of free steps is known; the end of steps with a blocked pair is not.
#[test]
fn the_end_of_blocked_steps_is_checked() {
    let options = FreeStepOptions::default();
    let mut detector = Detector::new(two_faces()).with_start_check(true);
    let mut x = above(8.0);
    for _ in 0..3 {
        let taken = detector.free_steps(&x, &above(-1.0), &[], &options).unwrap();
        assert!(taken.blocked.is_empty() && taken.positions != x);
        x = taken.positions;
    }
    assert_eq!(detector.start_passes(), 1);
    let all = [0, 1, 2, 3, 4, 5];
    let taken = detector.free_steps(&x, &above(-1.0), &all, &options).unwrap();
    assert!(!taken.blocked.is_empty() && taken.positions == above(-1.0));
    assert!(matches!(
        detector.collides(&above(-1.0), &x, CONTACT),
        Err(StepError::Crossing { edge: 3, face: 0, .. })
    ));
}

/// After a contact, or a search of a part of the step, an edge may cross a face at the end.
#[test]
fn the_end_of_a_step_that_is_not_free_is_checked() {
    let (x, pierced) = (above(4.0), above(-1.0));
    let mut detector = Detector::new(two_faces()).with_start_check(true);
    let assert_crosses = |detector: &mut Detector| {
        let found = detector.collides(&pierced, &pierced, CONTACT);
        assert!(matches!(found, Err(StepError::Crossing { .. })), "{found:?}");
    };
    // Contact at t = 4/5.
    assert!(detector.collision(&x, &pierced, CONTACT).unwrap().is_some());
    assert_crosses(&mut detector);
    assert_eq!(detector.collides(&x, &pierced, CONTACT.until(0.75)), Ok(false));
    assert_crosses(&mut detector);
    assert_eq!(detector.collision(&x, &pierced, CONTACT.until(0.75)), Ok(None));
    assert_crosses(&mut detector);
}

#[test]
fn the_ends_of_free_steps_need_no_pass() {
    let [a, b, c, d, e] = [8.0, 7.0, 6.0, 5.0, 4.0].map(above);
    let mut detector = Detector::new(two_faces()).with_start_check(true);
    assert_eq!(detector.start_passes(), 0);
    assert_eq!(detector.collides(&a, &b, CONTACT), Ok(false));
    assert_eq!(detector.collision(&b, &c, CONTACT), Ok(None));
    let direction = [[[0.0; 3]; 3], [[0.0, 0.0, -1.0]; 3]].concat();
    let taken = detector
        .free_step_along(&c, &direction, &FreeStepOptions::default())
        .unwrap();
    assert_eq!(taken.positions, d);
    assert_eq!(detector.collides(&d, &e, CONTACT), Ok(false));
    assert_eq!(detector.start_passes(), 1);

    let mut without = detector.with_start_check(false);
    assert_eq!(without.start_passes(), 0);
    let pierced = above(-1.0);
    assert_eq!(without.collides(&pierced, &pierced, CONTACT), Ok(false));
}
