//! Rigid bodies: contacts against all pairs in integers, and against meshes in straight motion.

mod distance;
mod hostile;
mod together;

use std::collections::BTreeSet;

use exact_ccd::motion::{BodyPair, Chain, CurvedQuery, Pose, RigidMotion};
use exact_ccd::{AnyKind, CONTACT, Impact, Kind, Options, Separation, TimeOutOfStep, with_kind};
use exact_ccd_mesh::{
    Bodies, BodiesAudit, BodiesError, BodiesViolation, BodyContact, CanCollide, Detector, Frame, Pair, Point,
    TriangleMesh,
};
use fastrand::Rng;

/// A number of a family: a small integer, or one between −2 and 2.
fn number(random: &mut Rng, is_lattice: bool) -> f64 {
    if is_lattice {
        f64::from(random.i32(-2..=2))
    } else {
        4.0 * random.f64() - 2.0
    }
}

fn point(random: &mut Rng, is_lattice: bool) -> Point {
    [(); 3].map(|()| number(random, is_lattice))
}

/// A tetrahedron, a face with a rod, or a rod and a point.
fn body(random: &mut Rng, is_lattice: bool) -> Frame {
    let (count, faces, edges): (usize, &[[u32; 3]], &[[u32; 2]]) = match random.u32(..3) {
        0 => (4, &[[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]], &[]),
        1 => (4, &[[0, 1, 2]], &[[2, 3]]),
        _ => (3, &[], &[[0, 1]]),
    };
    let positions = (0..count).map(|_| point(random, is_lattice)).collect();
    Frame::with_edges(positions, faces.to_vec(), edges).unwrap()
}

/// Rest, a rigid motion, or a chain of three, whose degree no filter decides.
fn motion(random: &mut Rng, is_lattice: bool) -> Chain {
    let count = [0, 0, 1, 1, 1, 1, 1, 3][random.usize(..8)];
    let motions = (0..count).map(|_| {
        loop {
            let quaternions = [(); 2].map(|()| [(); 4].map(|()| number(random, is_lattice)));
            let places = [(); 2].map(|()| point(random, is_lattice));
            if let Ok(motion) = RigidMotion::new(quaternions, &places) {
                break motion;
            }
        }
    });
    Chain::new(motions.collect::<Vec<_>>()).unwrap()
}

/// The primitives of a body that are compared: vertices, faces, edges, loose vertices, loose edges.
fn primitives(mesh: &TriangleMesh) -> [Vec<(u32, Vec<u32>)>; 5] {
    let edges: Vec<_> = mesh.edges().iter().map(|edge| edge.to_vec()).collect();
    let numbered = |lists: Vec<Vec<u32>>| (0..).zip(lists).collect::<Vec<(u32, Vec<u32>)>>();
    let edges = numbered(edges);
    let loose = edges
        .iter()
        .filter(|(_, edge)| mesh.loose_edges().iter().any(|e| e[..] == edge[..]));
    [
        (0..mesh.vertex_count() as u32)
            .map(|vertex| (vertex, vec![vertex]))
            .collect(),
        numbered(mesh.faces().iter().map(|face| face.to_vec()).collect()),
        edges.clone(),
        mesh.loose_vertices()
            .map(|vertex| (vertex, vec![vertex]))
            .collect(),
        loose.cloned().collect(),
    ]
}

fn exactly<K: Kind>(points: &[Point], motions: &BodyPair, options: Options) -> Option<Impact> {
    let mut given = K::Points::default();
    given.as_mut().copy_from_slice(points);
    let query: CurvedQuery<K> = motions.query(given).unwrap();
    query.exactly().impact(options)
}

/// All contacts, by all pairs in integers.
fn all_contacts(frames: &[Frame], motions: &[Chain], options: Options) -> Vec<BodyContact> {
    let mut all = Vec::new();
    for first in 0..frames.len() {
        for second in (0..frames.len()).filter(|&second| second != first) {
            let pair = BodyPair::new(motions[first].clone(), motions[second].clone());
            let [one, other] = [first, second].map(|body| primitives(&frames[body].mesh));
            for (kind, [i, j]) in [
                (AnyKind::VertexFace, [0, 1]),
                (AnyKind::EdgeEdge, [2, 2]),
                (AnyKind::VertexEdge, [3, 4]),
                (AnyKind::VertexVertex, [3, 3]),
            ] {
                if i == j && first > second {
                    continue;
                }
                for (a, of_a) in &one[i] {
                    for (b, of_b) in &other[j] {
                        let at = |body: usize, vertex: &u32| frames[body].positions[*vertex as usize];
                        let of_a = of_a.iter().map(|vertex| at(first, vertex));
                        let points: Vec<_> =
                            of_a.chain(of_b.iter().map(|vertex| at(second, vertex))).collect();
                        let impact = with_kind!(kind, K => exactly::<K>(&points, &pair, options));
                        all.extend(impact.map(|impact| BodyContact {
                            kind,
                            bodies: [first, second],
                            primitives: [*a, *b],
                            impact,
                        }));
                    }
                }
            }
        }
    }
    all.sort_by_key(|contact| {
        (
            contact.impact.time,
            contact.kind,
            contact.bodies,
            contact.primitives,
        )
    });
    all
}

#[test]
fn contacts_are_those_of_all_pairs() {
    let mut random = Rng::with_seed(1);
    let mut counts = [0; 2];
    for case in 0..24 {
        let is_lattice = case % 2 == 0;
        let count = random.usize(2..=3);
        let frames: Vec<_> = (0..count).map(|_| body(&mut random, is_lattice)).collect();
        let motions: Vec<_> = (0..count).map(|_| motion(&mut random, is_lattice)).collect();
        let bodies = Bodies::new(frames.clone()).unwrap();
        let d = if case % 6 == 5 { 0.25 } else { 0.0 };
        let options = Options::within(Separation::new(d).unwrap()).until([1.0, 0.5][case % 4 / 3]);
        let expected = all_contacts(&frames, &motions, options);
        assert_eq!(bodies.collisions(&motions, options).unwrap(), expected, "{case}");
        let earliest = bodies.collision(&motions, options).unwrap();
        assert_eq!(earliest, expected.first().copied(), "{case}");
        assert_eq!(bodies.collides(&motions, options).unwrap(), !expected.is_empty());
        counts[usize::from(expected.is_empty())] += 1;
    }
    assert!(counts.iter().all(|&count| count >= 2), "{counts:?}");
}

/// The bodies in the other order have the same times.
#[test]
fn the_order_of_bodies_does_not_matter() {
    let mut random = Rng::with_seed(2);
    let mut touching = 0;
    for case in 0..60 {
        let is_lattice = case % 2 == 0;
        let frames = [(); 2].map(|()| body(&mut random, is_lattice));
        let motions = [(); 2].map(|()| motion(&mut random, is_lattice));
        let [first, second] = frames.clone();
        let [one, other] = motions.clone();
        let contacts = Bodies::new(frames)
            .unwrap()
            .collisions(&motions, CONTACT)
            .unwrap();
        let swapped = Bodies::new([second, first]).unwrap();
        let mut swapped = swapped.collisions(&[other, one], CONTACT).unwrap();
        for contact in &mut swapped {
            contact.bodies = contact.bodies.map(|body| 1 - body);
            if matches!(contact.kind, AnyKind::EdgeEdge | AnyKind::VertexVertex) {
                contact.bodies.reverse();
                contact.primitives.reverse();
            }
        }
        let key = |c: &BodyContact| (c.impact.time, c.kind, c.bodies, c.primitives);
        swapped.sort_by_key(key);
        let [given, swapped] = [&contacts, &swapped].map(|list| list.iter().map(key).collect::<Vec<_>>());
        assert_eq!(given, swapped, "{case}");
        touching += usize::from(!given.is_empty());
    }
    assert!((10..60).contains(&touching), "{touching}");
}

/// The pair of a mesh of two bodies, the second one after the first.
fn merged(frames: &[Frame; 2], contact: &BodyContact) -> Pair {
    let [first, second] = [0, 1].map(|i: usize| {
        let before = &frames[0].mesh;
        let shift = match (contact.bodies[i], contact.kind, i) {
            (0, ..) => 0,
            (_, AnyKind::VertexFace, 1) => before.faces().len(),
            (_, AnyKind::EdgeEdge, _) | (_, AnyKind::VertexEdge, 1) => before.edges().len(),
            _ => before.vertex_count(),
        };
        contact.primitives[i] + shift as u32
    });
    match contact.kind {
        AnyKind::VertexFace => Pair::VertexFace {
            vertex: first,
            face: second,
        },
        _ => Pair::EdgeEdge { a: first, b: second },
    }
}

/// Closed bodies of faces that translate, or rest, and a mesh of both in straight motion: the same contacts,
/// bit for bit. All sums are exact.
#[test]
fn translation_is_straight_motion() {
    let mut random = Rng::with_seed(3);
    let faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
    let mut touching = [0; 2];
    for case in 0..120 {
        let rests = case % 3 == 0;
        let frames = [(); 2].map(|()| {
            let positions = (0..4).map(|_| point(&mut random, true)).collect();
            Frame::new(positions, faces.to_vec()).unwrap()
        });
        let places = [(); 2].map(|()| {
            let start = point(&mut random, true);
            [start, if rests { start } else { point(&mut random, true) }]
        });
        let motions = places.map(|places| {
            let quaternions = [[3.0, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0]];
            Chain::from(RigidMotion::new(quaternions, &places).unwrap())
        });
        let at = |time: usize| -> Vec<Point> {
            let moved = frames.iter().zip(&places).flat_map(|(frame, places)| {
                let move_by = move |x: &Point| [0, 1, 2].map(|axis: usize| x[axis] + places[time][axis]);
                frame.positions.iter().map(move_by)
            });
            moved.collect()
        };
        let all_faces = [faces, faces.map(|face| face.map(|vertex| vertex + 4))].concat();
        let mesh = TriangleMesh::new(8, all_faces).unwrap();
        let groups = CanCollide::different_groups((0..8).map(|vertex| vertex / 4).collect());
        let mut detector = Detector::new(mesh).with_can_collide(groups);
        for d in [0.0, 0.5] {
            let options = Options::within(Separation::new(d).unwrap());
            let straight = detector.collisions(&at(0), &at(1), options).unwrap();
            let contacts = Bodies::new(frames.clone()).unwrap();
            let contacts = contacts.collisions(&motions, options).unwrap();
            let pairs = contacts.iter().map(|c| (c.impact.time, merged(&frames, c)));
            let mut pairs: Vec<_> = pairs.collect();
            pairs.sort_unstable();
            let expected: Vec<_> = straight.iter().map(|c| (c.impact.time, c.pair)).collect();
            assert_eq!(pairs, expected, "{case} {d}");
            touching[usize::from(rests)] += usize::from(!pairs.is_empty());
        }
    }
    assert!(touching.iter().all(|&count| count > 10), "{touching:?}");
}

#[test]
fn motions_and_positions_are_checked() {
    let rod = || Frame::with_edges(vec![[0.0; 3], [1.0; 3]], vec![], &[[0, 1]]).unwrap();
    let bodies = Bodies::new([rod(), rod()]).unwrap();
    let error = bodies.collides(&[Chain::default()], CONTACT);
    assert_eq!(
        error.unwrap_err().to_string(),
        "1 motions, expected one for each of 2 bodies"
    );
    let motions = [Chain::default(), Chain::default()];
    let error = bodies.collision(&motions, CONTACT.until(2.0));
    assert_eq!(error, Err(BodiesError::Time(TimeOutOfStep { time: 2.0 })));
    let mut unsound = rod();
    unsound.positions.pop();
    let error = Bodies::new([rod(), unsound]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "body 1: 1 positions, expected one for each of 2 vertices"
    );
}

/// An icosphere-like ball: a grid of a sphere, whose faces are small against it.
fn ball(radius: f64) -> Frame {
    let [rows, columns] = [8_u32, 10];
    let angle = |i: u32, count: u32| std::f64::consts::TAU * f64::from(i) / f64::from(count);
    let mut positions = vec![[0.0, 0.0, -radius], [0.0, 0.0, radius]];
    for (i, j) in (1..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        let (a, b) = (angle(i, 2 * rows), angle(j, columns));
        positions.push([a.sin() * b.cos(), a.sin() * b.sin(), -a.cos()].map(|x| radius * x));
    }
    let at = |i: u32, j: u32| match i {
        0 => 0,
        i if i == rows => 1,
        i => 2 + (i - 1) * columns + j % columns,
    };
    let quads = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
    let faces = quads.flat_map(|(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
        [[a, b, c], [a, c, d]]
    });
    let faces = faces.filter(|[a, b, c]| a != b && b != c && c != a).collect();
    Frame::new(positions, faces).unwrap()
}

/// Trees of several levels, and turns for which the step is divided: all pairs by the filters give the same.
#[test]
fn trees_find_all_contacts_of_turning_balls() {
    let mut random = Rng::with_seed(4);
    let mut touching = 0;
    for case in 0..6 {
        let frames = [ball(1.0), ball(0.7)];
        let mut chain = |offset: f64, count: usize| -> Chain {
            let motions = (0..count).map(|i| {
                let quaternions = [(); 2].map(|()| [(); 4].map(|()| number(&mut random, false)));
                let mut places = [(); 2].map(|()| point(&mut random, false).map(|x| 0.3 * x));
                if i == 0 {
                    places.iter_mut().for_each(|place| place[0] += offset);
                }
                RigidMotion::new(quaternions, &places).unwrap()
            });
            Chain::new(motions.collect::<Vec<_>>()).unwrap()
        };
        let motions = [chain(0.0, 1 + case % 2), chain(1.9, 1)];
        let bodies = Bodies::new(frames.clone()).unwrap();
        let options = CONTACT.until(if case % 2 == 0 { 1.0 } else { 0.4 });
        let mut expected = Vec::new();
        for (first, second) in [(0, 1), (1, 0)] {
            let pair = BodyPair::new(motions[first].clone(), motions[second].clone());
            let [one, other] = [first, second].map(|body| primitives(&frames[body].mesh));
            for (kind, [i, j]) in [(AnyKind::VertexFace, [0, 1]), (AnyKind::EdgeEdge, [2, 2])] {
                if i == j && first > second {
                    continue;
                }
                for (a, of_a) in &one[i] {
                    for (b, of_b) in &other[j] {
                        let at = |body: usize, vertex: &u32| frames[body].positions[*vertex as usize];
                        let of_a = of_a.iter().map(|vertex| at(first, vertex));
                        let points: Vec<_> =
                            of_a.chain(of_b.iter().map(|vertex| at(second, vertex))).collect();
                        let points = [0, 1, 2, 3].map(|i: usize| points[i]);
                        let time = if i == j {
                            pair.query::<exact_ccd::EdgeEdge>(points)
                                .unwrap()
                                .first_time(options)
                        } else {
                            pair.query::<exact_ccd::VertexFace>(points)
                                .unwrap()
                                .first_time(options)
                        };
                        expected.extend(time.map(|time| (time, kind, [first, second], [*a, *b])));
                    }
                }
            }
        }
        expected.sort_unstable();
        let key = |c: &BodyContact| (c.impact.time, c.kind, c.bodies, c.primitives);
        let earliest = bodies.collision(&motions, options).unwrap();
        assert_eq!(earliest.as_ref().map(key), expected.first().copied(), "{case}");
        assert_eq!(bodies.collides(&motions, options).unwrap(), !expected.is_empty());
        let contacts = bodies.collisions(&motions, options).unwrap();
        assert_eq!(contacts.iter().map(key).collect::<Vec<_>>(), expected, "{case}");
        touching += usize::from(!expected.is_empty());
    }
    assert!(touching >= 2, "{touching}");
}

fn pose(random: &mut Rng, offset: f64) -> Pose {
    let rotation = [(); 4].map(|()| number(random, false));
    let mut place = point(random, false).map(|x| 0.2 * x);
    place[0] += offset;
    Pose::new(rotation, place).unwrap()
}

/// The count, the certified poses and their certificate, on one, two and four threads.
#[test]
fn free_steps_are_free_on_any_number_of_threads() {
    let mut random = Rng::with_seed(5);
    let mut shortened = 0;
    for case in 0..6 {
        let bodies = Bodies::new([ball(1.0), ball(0.7), ball(0.5)]).unwrap();
        let mut poses = |shift: f64| [0.0, 2.6, 5.2].map(|x| pose(&mut random, x * shift));
        let start = poses(1.0);
        let end = poses(if case % 2 == 0 { 0.3 } else { 0.6 });
        let end = [0, 1, 2].map(|i: usize| {
            if i == 1 {
                start[1]
            } else {
                end[i].nearer_turn(&start[i])
            }
        });
        let motions = bodies.motions(&start, &end).unwrap();
        let answer = || {
            (
                bodies.free_step(&start, &end, 0.9, CONTACT).unwrap(),
                bodies.step(&start, &end, CONTACT).unwrap(),
            )
        };
        let answers = [1, 2, 4].map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.unwrap().install(answer)
        });
        assert!(answers.iter().all(|other| *other == answers[0]), "{case}");
        let (free, report) = &answers[0];
        let contacts = bodies.collisions(&motions, CONTACT).unwrap();
        assert_eq!(report.colliding.total(), contacts.len());
        assert_eq!(report.earliest, contacts.first().copied());
        assert_eq!(free.contact, report.earliest);
        if let Some(time) = report.time_of_impact().filter(|&time| time > 0.0) {
            assert!(free.size > 0.0 && free.size <= time, "{case}");
            assert_eq!(free.poses[1], start[1]);
            let taken = bodies.motions(&start, &free.poses).unwrap();
            assert!(!bodies.collides(&taken, CONTACT).unwrap());
            shortened += 1;
        }
    }
    assert!(shortened >= 2, "{shortened}");
}

#[test]
fn pairs_of_bodies_that_cannot_collide_are_left_out() {
    let bodies = Bodies::new([ball(1.0), ball(1.0), ball(1.0)]).unwrap();
    let at = |x: f64| Pose::new([1.0, 0.0, 0.0, 0.0], [x, 0.0, 0.0]).unwrap();
    let poses = [at(0.0), at(0.5), at(1.0)];
    let pairs = |bodies: &Bodies| -> BTreeSet<[usize; 2]> {
        let motions = bodies.motions(&poses, &poses).unwrap();
        let contacts = bodies.collisions(&motions, CONTACT).unwrap().into_iter();
        let sorted = contacts.map(|contact| {
            let [a, b] = contact.bodies;
            [a.min(b), a.max(b)]
        });
        sorted.collect()
    };
    // Balls that intersect do not touch; a ball in the place of another one touches it everywhere.
    let same = [at(0.0), at(0.0), at(9.0)];
    let motions = bodies.motions(&same, &same).unwrap();
    assert!(bodies.collides(&motions, CONTACT).unwrap());
    let apart = bodies.clone().with_can_collide(|a, b| [a, b] != [0, 1]);
    assert!(!apart.collides(&motions, CONTACT).unwrap());
    assert!(pairs(&apart).is_subset(&pairs(&bodies)));
}

/// An audit reports an intersection at the start, and the first frame after which bodies touch.
#[test]
fn audits_of_poses() {
    let at = |x: f64, y: f64| Pose::new([1.0, 0.5, 0.25, 0.0], [x, y, 0.0]).unwrap();
    let opposite = |pose: Pose| Pose::new(pose.rotation().map(|x| -2.0 * x), pose.place()).unwrap();
    let bodies = Bodies::new([ball(1.0), ball(0.75)]).unwrap();
    let mut audit = BodiesAudit::new(bodies.clone());
    let frames = [
        [at(0.0, 0.0), at(3.0, 0.0)],
        [at(0.0, 1.0), opposite(at(3.0, 2.0))],
        [at(2.0, 0.0), at(0.0, 1.0)],
    ];
    assert_eq!(audit.examine(&frames[0]), Ok(None));
    assert_eq!(audit.examine(&frames[1]), Ok(None));
    let Ok(Some(BodiesViolation::Contact { frame: 1, contact })) = audit.examine(&frames[2]) else {
        panic!("the balls pass through each other");
    };
    let end = [frames[2][0], frames[2][1].nearer_turn(&frames[1][1])];
    let motions = bodies.motions(&frames[1], &end).unwrap();
    assert_eq!(bodies.collision(&motions, CONTACT), Ok(Some(contact)));
    assert_eq!(audit.frames(), 3);
    // Balls that intersect, and a ball inside of the other one.
    let start = |x: f64| BodiesAudit::new(bodies.clone()).examine(&[at(0.0, 0.0), at(x, 0.125)]);
    assert!(matches!(
        start(0.5),
        Ok(Some(BodiesViolation::Intersection { frame: 0, .. }))
    ));
    assert_eq!(start(0.0), Ok(None));
    assert!(matches!(
        audit.examine(&[at(0.0, 0.0)]),
        Err(BodiesError::PoseCount { poses: 1, bodies: 2 })
    ));
}
