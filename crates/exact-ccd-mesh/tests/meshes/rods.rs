//! Rods that fold through themselves, and rods, points and faces against a loop over everything they
//! consist of.

use exact_ccd::{
    AnyKind, CONTACT, ContactTime, EdgeEdge, Options, Query, Separation, Thickness, VertexEdge, VertexFace,
    VertexVertex,
};
use exact_ccd_mesh::{
    Audit, Bvh, CandidateOptions, Candidates, Detector, Frame, FreeStepOptions, IntersectionOptions,
    MinDistance, Pair, Point, Step, TriangleMesh, Violation, intersections, step,
};
use fastrand::Rng;

const PAIR: Pair = Pair::VertexEdge { vertex: 2, edge: 0 };

/// The edges (0, 1) and (0, 2): a rod of two edges with the vertex 0 in the middle.
fn two_edges() -> TriangleMesh {
    let mesh = TriangleMesh::with_edges(3, Vec::new(), &[[0, 1], [0, 2]]).unwrap();
    assert_eq!(mesh.edges(), [[0, 1], [0, 2]]);
    mesh
}

/// Vertex 2 at a height above edge (0, 1).
fn folding(z: f64) -> Vec<Point> {
    vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [2.0, 0.0, z]]
}

#[test]
fn a_rod_that_folds_through_its_neighbour_is_in_contact() {
    let mesh = two_edges();
    let (x0, x1) = (folding(1.0), folding(-1.0));
    let report = step(&mesh, &x0, &x1).unwrap();
    let earliest = report.earliest.unwrap();
    assert_eq!((earliest.pair, earliest.impact.time.lower()), (PAIR, 0.5));
    assert_eq!(
        (report.colliding[AnyKind::VertexEdge], report.colliding.total()),
        (1, 1)
    );

    let mut detector = Detector::new(mesh.clone());
    assert_eq!(detector.collides(&x0, &x1, CONTACT), Ok(true));
    assert_eq!(detector.collision(&x0, &x1, CONTACT), Ok(Some(earliest)));
    assert_eq!(detector.collisions(&x0, &x1, CONTACT), Ok(vec![earliest]));
    let taken = detector.free_step(&x0, &x1, &FreeStepOptions::default()).unwrap();
    assert!(taken.size > 0.4 && taken.size < 0.5);

    let mut audit = Audit::default();
    let frame = |x: Vec<Point>| Frame {
        positions: x,
        mesh: mesh.clone(),
    };
    assert_eq!(audit.examine(frame(x0)).unwrap(), None);
    let violation = audit.examine(frame(x1)).unwrap();
    assert_eq!(
        violation,
        Some(Violation::Contact {
            frame: 0,
            contact: earliest
        })
    );
}

/// The neighbours of a rod are nearer than a distance above the length of its edges, whatever the rod does.
#[test]
fn a_rod_is_not_in_contact_with_its_neighbours_within_a_distance() {
    let straight = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [-4.0, 0.0, 0.0]];
    for d in [1.0, 3.0, 100.0] {
        let uniform = MinDistance::uniform(Separation::new(d).unwrap());
        let thickness = MinDistance::thickness(Thickness::new(&[0.5 * d; 3]).unwrap());
        for min_distance in [uniform, thickness] {
            let mut detector = Detector::new(two_edges());
            let within = || Options::within(min_distance.clone());
            assert_eq!(
                detector.collides(&straight, &folding(0.25), within()),
                Ok(false),
                "{d}"
            );
            let contact = detector
                .collision(&folding(1.0), &folding(-1.0), within())
                .unwrap()
                .unwrap();
            assert_eq!(
                (contact.pair, contact.impact.time.lower(), contact.distance.upper),
                (PAIR, 0.5, 0.0)
            );
            let (x0, x1) = (folding(1.0), folding(-1.0));
            let options = FreeStepOptions::default().with_min_distance(min_distance.clone());
            let taken = detector.free_step(&x0, &x1, &options).unwrap();
            assert!(taken.size > 0.4 && taken.touching.total() == 0, "{taken:?}");

            let step = Step::new(detector.mesh(), &x0, &x1).unwrap();
            let options = CandidateOptions::default().with_min_distance(min_distance.clone());
            let candidates = Candidates::with_options(step, &Bvh, &options).unwrap();
            assert_eq!(candidates.collisions(step, within()), [contact]);

            let mut audit = Audit::default().with_min_distance(min_distance);
            let frame = |x: Vec<Point>| Frame {
                positions: x,
                mesh: two_edges(),
            };
            assert_eq!(audit.examine(frame(x0)).unwrap(), None);
            assert!(audit.examine(frame(x1)).unwrap().is_some());
        }
    }
}

/// An end edge that shrinks to a point puts its end on the edge before.
#[test]
fn rods_meet_themselves_in_every_way_but_along_one_edge() {
    let line = |count: u32| -> Vec<[u32; 2]> { (1..count).map(|vertex| [vertex - 1, vertex]).collect() };
    let at = |x: &[f64]| x.iter().map(|&x| [x, 0.0, 0.0]).collect::<Vec<Point>>();
    let is_free = |edges: &[[u32; 2]], x0: &[f64], x1: &[f64]| {
        let mesh = TriangleMesh::with_edges(x0.len(), Vec::new(), edges).unwrap();
        !Detector::new(mesh).collides(&at(x0), &at(x1), CONTACT).unwrap()
    };
    // A single edge that turns over by way of length 0 has no other primitive to touch.
    assert!(is_free(&line(2), &[0.0, 1.0], &[0.0, -1.0]));
    assert!(!is_free(&line(3), &[0.0, 1.0, 2.0], &[0.0, 1.0, 0.5]));
    assert!(!is_free(&line(4), &[0.0, 1.0, 2.0, 3.0], &[0.0, 2.0, 1.0, 3.0]));
    assert!(is_free(&line(4), &[0.0, 1.0, 2.0, 3.0], &[0.0, 1.0, 2.0, 2.5]));
    // A triangle of rods, flattened.
    let triangle = [[0, 1], [1, 2], [0, 2]];
    assert!(!is_free(&triangle, &[0.0, 1.0, 2.0], &[0.0, 1.0, 2.0]));
}

/// Faces, rods of up to five vertices, stars and triangles of rods, and points, between whole numbers or not.
fn scene(random: &mut Rng) -> (TriangleMesh, Vec<Point>, Vec<Point>) {
    let count = random.u32(4..10);
    let mut ids: Vec<u32> = (0..count).collect();
    random.shuffle(&mut ids);
    let place = |random: &mut Rng| ids[random.usize(..ids.len())];
    let mut edges = Vec::new();
    for start in (0..count as usize).step_by(5) {
        let end = (start + random.usize(2..6)).min(count as usize);
        edges.extend(ids[start..end].windows(2).map(|edge| [edge[0], edge[1]]));
    }
    if random.bool() {
        edges.push([place(random), place(random)]);
    }
    let faces = (0..random.u32(..2))
        .map(|_| [0; 3].map(|_| place(random)))
        .collect();
    let mesh = TriangleMesh::with_edges(count as usize, faces, &edges).unwrap();
    let whole = random.bool();
    let coordinate = |random: &mut Rng| {
        let x = 4.0 * random.f64() - 2.0;
        if whole { x.round() } else { x }
    };
    let size = if random.bool() { 1.0 } else { 0.125 };
    let x0: Vec<Point> = (0..count).map(|_| [0; 3].map(|_| coordinate(random))).collect();
    let x1 = x0
        .iter()
        .map(|x| x.map(|x| x + size * coordinate(random)))
        .collect();
    (mesh, x0, x1)
}

/// The first time at which two primitives without a common vertex come within d of each other, among all
/// vertices with all faces, loose edges and vertices, and all edges with each other.
fn first(mesh: &TriangleMesh, [x0, x1]: [&[Point]; 2], d: f64) -> Option<f64> {
    let at = |x: &[Point], vertex: u32| x[vertex as usize];
    let far = Separation::new(d).unwrap();
    let is_edge = |v: u32, w: u32| mesh.edges().contains(&[v.min(w), v.max(w)]);
    let mut times = Vec::new();
    for p in 0..mesh.vertex_count() as u32 {
        for &[a, b, c] in mesh.faces().iter().filter(|face| !face.contains(&p)) {
            let query = |x| [p, a, b, c].map(|v| at(x, v));
            times.push(
                Query::<VertexFace>::new(query(x0), query(x1))
                    .unwrap()
                    .collision(far)
                    .map(|collision| collision.time()),
            );
        }
        for &[a, b] in mesh.loose_edges().iter().filter(|edge| !edge.contains(&p)) {
            let query = |x| [p, a, b].map(|v| at(x, v));
            // The neighbours along a rod keep no distance, but do not touch.
            let far = if is_edge(p, a) || is_edge(p, b) {
                Separation::default()
            } else {
                far
            };
            times.push(
                Query::<VertexEdge>::new(query(x0), query(x1))
                    .unwrap()
                    .collision(far)
                    .map(|collision| collision.time()),
            );
        }
        // If one of two vertices has edges, these are at most as far apart, or both are ends of one edge.
        let has_edge = |v: u32| mesh.edges().as_flattened().contains(&v);
        for q in (0..p).filter(|&q| !has_edge(p) || !has_edge(q)) {
            let query = |x| [p, q].map(|v| at(x, v));
            times.push(
                Query::<VertexVertex>::new(query(x0), query(x1))
                    .unwrap()
                    .collision(far)
                    .map(|collision| collision.time()),
            );
        }
    }
    for (index, &[a, b]) in mesh.edges().iter().enumerate() {
        for &[c, d] in &mesh.edges()[..index] {
            if ![c, d].contains(&a) && ![c, d].contains(&b) {
                let query = |x| [a, b, c, d].map(|v| at(x, v));
                times.push(
                    Query::<EdgeEdge>::new(query(x0), query(x1))
                        .unwrap()
                        .collision(far)
                        .map(|collision| collision.time()),
                );
            }
        }
    }
    let lower = times.into_iter().flatten().map(ContactTime::lower);
    lower.min_by(f64::total_cmp)
}

#[test]
fn no_pair_is_missing_and_none_counts_too_much() {
    let mut random = Rng::with_seed(71);
    let (mut folds, mut blocked, mut free) = (0, 0, 0);
    for _ in 0..1000 {
        let (mesh, x0, x1) = scene(&mut random);
        let mut detector = Detector::new(mesh.clone());
        for d in [0.0, 0.125, 1.5] {
            let min_distance = MinDistance::uniform(Separation::new(d).unwrap());
            let within = || Options::within(min_distance.clone());
            let expected = first(&mesh, [&x0, &x1], d);
            let found = detector.collision(&x0, &x1, within()).unwrap();
            assert_eq!(
                found.map(|contact| contact.impact.time.lower()),
                expected,
                "{mesh:?} {x0:?} {x1:?} {d}"
            );
            assert_eq!(detector.collides(&x0, &x1, within()), Ok(expected.is_some()));
            let step = Step::new(&mesh, &x0, &x1).unwrap();
            let options = CandidateOptions::default().with_min_distance(min_distance.clone());
            let candidates = Candidates::with_options(step, &Bvh, &options).unwrap();
            assert_eq!(candidates.collision(step, within()), found);
            let options = FreeStepOptions::default().with_min_distance(min_distance.clone());
            let taken = detector.free_step(&x0, &x1, &options).unwrap();
            match expected {
                None => assert_eq!(taken.size, 1.0),
                Some(_) if taken.size > 0.0 => assert_eq!(first(&mesh, [&x0, &taken.positions], d), None),
                Some(_) => {}
            }
            let mut audit = Audit::default().with_min_distance(min_distance);
            let frame = |x: &[Point]| Frame {
                positions: x.to_vec(),
                mesh: mesh.clone(),
            };
            if audit.examine(frame(&x0)).unwrap().is_none() {
                let touching = IntersectionOptions::default();
                assert_eq!(intersections(&mesh, &x0, &Bvh, &touching).unwrap(), []);
                assert_eq!(first(&mesh, [&x0, &x0], d), None);
                assert_eq!(audit.examine(frame(&x1)).unwrap().is_none(), expected.is_none());
            }
            let of_end = |pair: Pair| match pair {
                Pair::VertexEdge { vertex, .. } => mesh.edges().as_flattened().contains(&vertex),
                _ => false,
            };
            folds += usize::from(found.is_some_and(|contact| of_end(contact.pair)));
            blocked += usize::from(taken.size == 0.0);
            free += usize::from(expected.is_none());
        }
    }
    assert!(
        folds > 20 && blocked > 100 && free > 100,
        "{folds} {blocked} {free}"
    );
}

/// A vertex on a loose edge is one contact of a vertex and an edge only where no two edges say the same.
#[test]
fn no_contact_is_reported_twice() {
    let mut random = Rng::with_seed(72);
    let mut count = 0;
    for _ in 0..1000 {
        let (mesh, x0, x1) = scene(&mut random);
        let contacts = Detector::new(mesh.clone()).collisions(&x0, &x1, CONTACT).unwrap();
        for contact in contacts {
            if let Pair::VertexEdge { vertex, edge } = contact.pair {
                let [a, b] = mesh.edges()[edge as usize];
                let mut of_vertex = mesh.edges().iter().filter(|edge| edge.contains(&vertex));
                assert!(of_vertex.all(|edge| edge.contains(&a) || edge.contains(&b)));
                assert!(![a, b].contains(&vertex));
                count += 1;
            }
        }
    }
    assert!(count > 50, "{count}");
}
