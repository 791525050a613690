//! Rigid bodies: contacts against all pairs in integers, and against meshes in straight motion.

use exact_ccd::motion::{BodyPair, Chain, CurvedQuery, RigidMotion};
use exact_ccd::{AnyKind, CONTACT, Impact, Kind, Options, Separation, TimeOutOfStep, with_kind};
use exact_ccd_mesh::{
    Bodies, BodiesError, BodyContact, CanCollide, Detector, Frame, Pair, Point, TriangleMesh,
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

fn motion(random: &mut Rng, is_lattice: bool) -> Chain {
    if random.u32(..4) == 0 {
        return Chain::default();
    }
    loop {
        let quaternions = [(); 2].map(|()| [(); 4].map(|()| number(random, is_lattice)));
        let places = [(); 2].map(|()| point(random, is_lattice));
        if let Ok(motion) = RigidMotion::new(quaternions, &places) {
            return motion.into();
        }
    }
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
