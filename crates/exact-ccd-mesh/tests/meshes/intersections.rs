//! Self-intersections at rest against rational numbers, and sequences of frames against all pairs.

use exact_ccd::{CONTACT, EdgeEdge, Query, Thickness, VertexFace};
use exact_ccd_mesh::{
    AllPairs, Audit, Bvh, CanCollide, Frame, Intersection, IntersectionOptions, IntersectionsError, Meeting,
    MinDistance, MotionError, Point, PositionsError, StepError, Sweep, TriangleMesh, Violation,
    has_intersections, intersections, step,
};
use exact_ccd_testing::intersection;
use proptest::prelude::*;

use crate::contacts::every_pair::EveryPair;
use crate::contacts::scene::on_threads;

/// All pairs, by the definition.
fn expected(mesh: &TriangleMesh, positions: &[Point]) -> Vec<Intersection> {
    let point = |vertex: u32| positions[vertex as usize];
    let mut found = Vec::new();
    for (edge, ends) in (0..).zip(mesh.edges()) {
        for (face, corners) in (0..).zip(mesh.faces()) {
            let apart = ends.iter().all(|vertex| !corners.contains(vertex));
            if apart && intersection::intersect(ends.map(point), corners.map(point)) {
                found.push(Intersection { edge, face });
            }
        }
    }
    found
}

/// True if any two primitives without a common vertex touch at rest: the kinds of pairs, one by one. A mesh
/// of faces has no loose edges.
fn touches(mesh: &TriangleMesh, positions: &[Point]) -> bool {
    let point = |vertex: u32| positions[vertex as usize];
    let vertex_face = (0..mesh.vertex_count() as u32).any(|vertex| {
        mesh.faces()
            .iter()
            .filter(|face| !face.contains(&vertex))
            .any(|face| {
                let at = [vertex, face[0], face[1], face[2]].map(point);
                Query::<VertexFace>::new(at, at).unwrap().collides(CONTACT)
            })
    });
    let edge_edge = mesh.edges().iter().enumerate().any(|(index, &[a, b])| {
        let others = mesh.edges()[..index]
            .iter()
            .filter(|other| !other.contains(&a) && !other.contains(&b));
        others.into_iter().any(|&[c, d]| {
            let at = [a, b, c, d].map(point);
            Query::<EdgeEdge>::new(at, at).unwrap().collides(CONTACT)
        })
    });
    let is_loose = |vertex: &u32| !mesh.edges().iter().any(|edge| edge.contains(vertex));
    let loose: Vec<u32> = (0..mesh.vertex_count() as u32).filter(is_loose).collect();
    let vertex_vertex = loose.iter().enumerate().any(|(index, &a)| {
        let mut others = loose[..index].iter();
        others.any(|&b| point(a) == point(b))
    });
    vertex_face || edge_edge || vertex_vertex || !expected(mesh, positions).is_empty()
}

fn small() -> impl Strategy<Value = f64> {
    (-2..=2i8).prop_map(f64::from)
}

fn coordinate() -> impl Strategy<Value = f64> {
    let extreme = prop::sample::select(vec![1e300, -1e-300, 5e-324, 0.1, -0.0, f64::MAX, f64::MIN]);
    prop_oneof![8 => small(), 4 => -1.0..1.0, 1 => extreme]
}

fn mesh(vertices: usize, faces: std::ops::Range<usize>) -> impl Strategy<Value = TriangleMesh> {
    let face = prop::array::uniform3(0..vertices as u32);
    prop::collection::vec(face, faces).prop_map(move |faces| TriangleMesh::new(vertices, faces).unwrap())
}

fn touching() -> IntersectionOptions {
    IntersectionOptions::default()
}

fn positions(vertices: usize, coordinate: impl Strategy<Value = f64>) -> impl Strategy<Value = Vec<Point>> {
    prop::collection::vec(prop::array::uniform3(coordinate), vertices)
}

proptest! {
    #[test]
    fn intersections_are_those_of_the_definition(mesh in mesh(9, 0..8), x in positions(9, coordinate())) {
        let found = expected(&mesh, &x);
        prop_assert_eq!(&intersections(&mesh, &x, &Sweep, &touching()).unwrap(), &found);
        prop_assert_eq!(&intersections(&mesh, &x, &AllPairs, &touching()).unwrap(), &found);
        prop_assert_eq!(intersections(&mesh, &x, &Bvh, &touching()).unwrap(), found);
    }

    #[test]
    fn any_intersection_is_one_of_all(mesh in mesh(30, 10..30), x in positions(30, -1.0..1.0), face in 0..30u32) {
        let all = intersections(&mesh, &x, &Bvh, &touching()).unwrap();
        let is_any = |counts: &(dyn Fn(Intersection) -> bool + Sync)| {
            has_intersections(&mesh, &x, &Bvh, &touching(), counts).unwrap()
        };
        prop_assert_eq!(is_any(&|_| true), !all.is_empty());
        let counts = |pair: Intersection| pair.face == face;
        prop_assert_eq!(is_any(&counts), all.iter().any(|&pair| counts(pair)));
        prop_assert!(!is_any(&|pair| !all.contains(&pair)));
        let outside = Intersection { edge: 0, face: mesh.faces().len() as u32 };
        prop_assert_eq!(outside.vertices(&mesh), None);
    }

    /// Crossings are intersections, and any other intersection touches at the start of a step.
    #[test]
    fn crossings_and_contacts_at_rest_are_all_intersections(mesh in mesh(9, 0..6), x in positions(9, small())) {
        let all = intersections(&mesh, &x, &Bvh, &touching()).unwrap();
        let found = intersections(&mesh, &x, &Bvh, &touching().with_meeting(Meeting::Crossing)).unwrap();
        prop_assert!(found.iter().all(|pair| all.contains(pair)));
        let touching = step(&mesh, &x, &x).unwrap().touching;
        prop_assert_eq!(touches(&mesh, &x), !found.is_empty() || touching.total() > 0);
        let is_crossing = |pair: &Intersection| {
            let [u, v, w] = mesh.faces()[pair.face as usize].map(|vertex| x[vertex as usize]);
            let [p, q] = mesh.edges()[pair.edge as usize].map(|vertex| x[vertex as usize]);
            let heights = [p, q].map(|end| intersection::orientation([u, v, w, end]));
            let volumes = [[u, v], [v, w], [w, u]].map(|[a, b]| intersection::orientation([p, q, a, b]));
            heights[0] == heights[1].reverse()
                && heights[0].is_ne()
                && volumes[0].is_ne()
                && volumes == [volumes[0]; 3]
        };
        let mut crossing = all;
        crossing.retain(is_crossing);
        prop_assert_eq!(found, crossing);
    }

    #[test]
    fn the_number_of_threads_does_not_matter(mesh in mesh(30, 20..60), x in positions(30, -1.0..1.0)) {
        let on = |threads| on_threads(threads, || intersections(&mesh, &x, &Bvh, &touching()).unwrap());
        let one = on(1);
        prop_assert!(one.is_sorted());
        prop_assert_eq!(on(3), one);
    }

    /// Frames are near each other, so that many sequences are free.
    #[test]
    fn an_audit_finds_the_first_violation(
        mesh in mesh(8, 1..4),
        start in positions(8, prop_oneof![1 => small(), 3 => -2.0..2.0]),
        moves in prop::collection::vec(positions(8, prop_oneof![-0.2..0.2, Just(0.0)]), 0..4),
    ) {
        let mut frames = vec![start];
        for offsets in moves {
            let last = frames.last().unwrap().iter().zip(offsets);
            frames.push(last.map(|(p, d)| [0, 1, 2].map(|k| p[k] + d[k])).collect());
        }
        let (mut audit, mut every) = (Audit::default(), Audit::default());
        for (index, x) in frames.iter().enumerate() {
            let frame = Frame::new(x.clone(), mesh.faces().to_vec()).unwrap();
            let all = every.examine_all(frame.clone()).unwrap();
            let violation = audit.examine(frame).unwrap();
            prop_assert_eq!(all.first(), violation.as_ref());
            prop_assert_eq!(audit.frames(), index + 1);
            match index.checked_sub(1) {
                None => prop_assert_eq!(violation.is_some(), touches(&mesh, x)),
                Some(last) => {
                    let earliest = step(&mesh, &frames[last], x).unwrap().earliest;
                    let expected = earliest.map(|contact| Violation::Contact { frame: last, contact });
                    prop_assert_eq!(violation, expected);
                }
            }
            if violation.is_some() {
                return Ok(());
            }
            // This frame was certified by the step alone, without an examination at rest.
            prop_assert!(!touches(&mesh, x));
        }
    }
}

/// A face at integer positions, which are exact in i64.
type Corners = [[i64; 3]; 3];

fn minus(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn cross(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    [0, 1, 2].map(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

fn dot(a: [i64; 3], b: [i64; 3]) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn has_area([a, b, c]: Corners) -> bool {
    cross(minus(b, a), minus(c, a)) != [0; 3]
}

/// Two faces v a b and v c d have a point other than v in common if the cones of their directions at v
/// have a direction in common.
fn meet_beyond_vertex([v, a, b]: Corners, [_, c, d]: Corners) -> bool {
    let [a, b, c, d] = [a, b, c, d].map(|corner| minus(corner, v));
    let (n, m) = (cross(a, b), cross(c, d));
    // For directions in the plane of the cone.
    let in_cone = |x, [a, b]: [[i64; 3]; 2], n| dot(cross(a, x), n) >= 0 && dot(cross(x, b), n) >= 0;
    let line = cross(n, m);
    if line != [0; 3] {
        let opposite = line.map(|x| -x);
        return [line, opposite]
            .iter()
            .any(|&x| in_cone(x, [a, b], n) && in_cone(x, [c, d], m));
    }
    let is_coplanar = dot(n, c) == 0;
    is_coplanar
        && ([c, d].iter().any(|&x| in_cone(x, [a, b], n)) || [a, b].iter().any(|&x| in_cone(x, [c, d], m)))
}

/// A closed fold: a and b in one plane with the edge p q, on the same side of it.
fn is_closed_fold(p: [i64; 3], q: [i64; 3], a: [i64; 3], b: [i64; 3]) -> bool {
    let [n, m] = [a, b].map(|x| cross(minus(q, p), minus(x, p)));
    cross(n, m) == [0; 3] && dot(n, m) > 0
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4096))]

    /// As the definition of `intersections` proves: with the contacts at rest, they find all that faces with
    /// common vertices have in common beyond these.
    #[test]
    fn faces_with_common_vertices_are_decided_at_rest(
        x in prop::collection::vec(prop::array::uniform3(-2..=2i64), 5),
        is_flat in any::<bool>(),
        shared in 1..=2usize,
        place in 0..3usize,
    ) {
        let mut x = x;
        if is_flat {
            x.iter_mut().for_each(|point| point[2] = point[0]);
        }
        let (faces, meet) = if shared == 1 {
            let [one, other] = [[x[0], x[1], x[2]], [x[0], x[3], x[4]]];
            prop_assume!(has_area(one) && has_area(other));
            ([[0, 1, 2], [0, 3, 4]], meet_beyond_vertex(one, other))
        } else {
            x.truncate(4);
            prop_assume!(has_area([x[0], x[1], x[2]]) && has_area([x[0], x[1], x[3]]));
            ([[0, 1, 2], [1, 0, 3]], is_closed_fold(x[0], x[1], x[2], x[3]))
        };
        let mut faces = faces.to_vec();
        faces[1].rotate_left(place);
        let mesh = TriangleMesh::new(x.len(), faces).unwrap();
        let x: Vec<Point> = x.iter().map(|point| point.map(|k| k as f64)).collect();
        prop_assert_eq!(touches(&mesh, &x), meet);
        let frame = Frame { mesh: mesh.clone(), positions: x.clone() };
        prop_assert_eq!(Audit::default().examine(frame).unwrap().is_some(), meet);
        // One vertex: the intersections alone are enough. Two: the contacts at rest.
        let found = intersections(&mesh, &x, &Bvh, &touching()).unwrap();
        let report = step(&mesh, &x, &x).unwrap();
        if shared == 1 {
            prop_assert_eq!(!found.is_empty(), meet);
        } else {
            prop_assert_eq!(report.touching.total() > 0, meet);
        }
    }

    #[test]
    fn pairs_that_cannot_collide_are_left_out(
        mesh in mesh(9, 2..8),
        x in positions(9, small()),
        groups in prop::collection::vec(0..3u32, 9),
    ) {
        let can_collide = CanCollide::different_groups(groups.clone());
        let found = intersections(&mesh, &x, &Bvh, &touching().with_can_collide(can_collide.clone())).unwrap();
        let differ = |intersection: &Intersection| {
            let ends = mesh.edges()[intersection.edge as usize];
            let corners = mesh.faces()[intersection.face as usize];
            ends.iter().any(|&v| corners.iter().any(|&w| groups[v as usize] != groups[w as usize]))
        };
        let mut all = intersections(&mesh, &x, &Bvh, &touching()).unwrap();
        all.retain(differ);
        let frame = Frame { mesh: mesh.clone(), positions: x.clone() };
        let violation = Audit::default().with_can_collide(can_collide.clone()).examine(frame).unwrap();
        prop_assert_eq!(found, all);
        let crossing = IntersectionOptions::default().with_meeting(Meeting::Crossing);
        let crossings = intersections(&mesh, &x, &Bvh, &crossing.with_can_collide(can_collide)).unwrap();
        if let Some(&intersection) = crossings.first() {
            prop_assert_eq!(violation, Some(Violation::Intersection { frame: 0, intersection }));
        }
    }
}

/// A triangle above another, by z.
fn triangles(z: f64) -> Frame {
    let fixed = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];
    let other = [[1.0, 1.0, z], [1.0, 2.0, z + 1.0], [2.0, 1.0, z + 1.0]];
    Frame::new([fixed, other].concat(), vec![[0, 1, 2], [3, 4, 5]]).unwrap()
}

#[test]
fn an_audit_reports_an_intersection_before_a_contact() {
    let at_rest = |z: f64| Audit::default().examine(triangles(z)).unwrap();
    assert_eq!(at_rest(1.0), None);
    // The least pair: a side of the first face passes through the second one only if that is deep
    // enough.
    let intersection = Intersection { edge: 3, face: 0 };
    assert_eq!(
        at_rest(-0.5),
        Some(Violation::Intersection {
            frame: 0,
            intersection
        })
    );
    // A tip that touches the face does not pass through it.
    assert!(matches!(at_rest(0.0), Some(Violation::Contact { frame: 0, .. })));
    assert_eq!(at_rest(-2.0), None);
}

/// A predicate can leave out the vertex that reaches a face, but not the edges that follow it.
#[test]
fn an_audit_with_a_predicate_examines_each_frame_at_rest() {
    let groups = CanCollide::different_groups(vec![0, 0, 0, 0, 1, 1]);
    let mut audit = Audit::default().with_can_collide(groups);
    assert_eq!(audit.examine(triangles(1.0)), Ok(None));
    assert_eq!(audit.examine(triangles(0.5)), Ok(None));
    let intersection = Intersection { edge: 3, face: 0 };
    let expected = Violation::Intersection {
        frame: 2,
        intersection,
    };
    assert_eq!(audit.examine(triangles(-0.5)), Ok(Some(expected)));
}

#[test]
fn a_loose_vertex_on_a_face_is_a_contact() {
    let positions = vec![[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [1.0, 1.0, 0.0]];
    let frame = Frame::new(positions.clone(), vec![[0, 1, 2]]).unwrap();
    assert_eq!(
        intersections(&frame.mesh, &positions, &Bvh, &touching()),
        Ok(vec![])
    );
    let violation = Audit::default().examine(frame).unwrap();
    assert!(
        matches!(violation, Some(Violation::Contact { frame: 0, .. })),
        "{violation:?}"
    );
}

#[test]
fn errors_do_not_count_as_frames() {
    let frame = |count: u8| Frame::new((0..count).map(|x| [x.into(), 0.0, 0.0]).collect(), vec![]).unwrap();
    let mut audit = Audit::default();
    audit.examine(frame(2)).unwrap();
    let error = MotionError::VertexCount { start: 2, end: 3 };
    assert_eq!(audit.examine(frame(3)), Err(error));
    let mut broken = frame(2);
    broken.positions.pop();
    let count = PositionsError::Count {
        positions: 1,
        vertex_count: 2,
    };
    assert_eq!(
        audit.examine(broken.clone()),
        Err(MotionError::Positions(StepError::End(count)))
    );
    assert_eq!(
        Audit::default().examine(broken.clone()),
        Err(MotionError::Positions(StepError::Start(count)))
    );
    assert_eq!(
        intersections(&broken.mesh, &broken.positions, &Bvh, &touching()),
        Err(IntersectionsError::Positions(count))
    );
    assert_eq!(
        audit.examine_positions(broken.positions),
        Err(MotionError::Positions(StepError::End(count)))
    );
    assert_eq!(audit.frames(), 1);
    assert_eq!(audit.examine(frame(2)), Ok(None));
}

#[test]
fn frames_after_the_first_are_positions_of_its_mesh() {
    let frames = [3.0, 1.0, -3.0, -4.0].map(triangles);
    let (mut whole, mut positions) = (Audit::default(), Audit::default());
    assert_eq!(positions.examine_positions(vec![]), Ok(None));
    positions = Audit::default();
    positions.examine(frames[0].clone()).unwrap();
    whole.examine(frames[0].clone()).unwrap();
    for frame in &frames[1..] {
        let expected = whole.examine(frame.clone());
        assert_eq!(positions.examine_positions(frame.positions.clone()), expected);
        assert_eq!(
            (positions.frames(), positions.last()),
            (whole.frames(), Some(frame))
        );
    }
}

#[test]
fn an_audit_refuses_thicknesses_that_do_not_fit_a_mesh_that_intersects() {
    let thickness = MinDistance::thickness(Thickness::new(&[0.0; 5]).unwrap());
    let mut audit = Audit::default().with_min_distance(thickness);
    assert!(audit.examine(triangles(-0.5)).is_err());
    assert_eq!(audit.frames(), 0);
}

/// An intersection that is there from the beginning is no violation of a later step.
#[test]
fn an_audit_without_a_predicate_examines_the_first_frame_at_rest() {
    let mut audit = Audit::default();
    assert_eq!(audit.frames(), 0);
    assert!(matches!(
        audit.examine(triangles(-0.5)),
        Ok(Some(Violation::Intersection { frame: 0, .. }))
    ));
    assert_eq!(audit.examine(triangles(-0.5)), Ok(None));
    assert_eq!(audit.frames(), 2);
}

/// The tip stays on the face. Its edges meet the face in each frame, but do not pass through it.
#[test]
fn contacts_that_last_are_in_every_step_and_once_in_the_first_frame() {
    let mut audit = Audit::default();
    let mut contacts = Vec::new();
    for count in [1, 0, 1] {
        let found = audit.examine_all(triangles(0.0)).unwrap();
        assert_eq!(found.len(), count, "{found:?}");
        contacts.extend(found.iter().filter_map(|violation| match violation {
            Violation::Contact { frame, contact } => Some((*frame, contact.impact.time.lower())),
            Violation::Intersection { .. } => None,
        }));
    }
    assert_eq!(contacts, [(0, 0.0), (1, 0.0)]);
    assert_eq!(audit.frames(), 3);
}

/// Two faces with one common vertex, and two with a common edge.
#[test]
fn an_edge_and_a_face_with_a_common_vertex_are_no_intersection_for_any_broad_phase() {
    let mesh = TriangleMesh::new(6, vec![[0, 1, 2], [2, 1, 3], [3, 4, 5]]).unwrap();
    let x = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
        [2.0, 1.0, 1.0],
        [1.0, 2.0, 1.0],
    ];
    for meeting in [Meeting::Touching, Meeting::Crossing] {
        let options = IntersectionOptions::default().with_meeting(meeting);
        assert_eq!(intersections(&mesh, &x, &EveryPair, &options), Ok(Vec::new()));
    }
}
