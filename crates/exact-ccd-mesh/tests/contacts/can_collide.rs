//! Every search examines only the pairs that can collide.

use exact_ccd_mesh::{
    BoxKind, Bvh, CanCollide, CandidateOptions, Candidates, Detector, Pair, StepReport, TriangleMesh,
};
use fastrand::Rng;

use crate::scene::{PIECES, Scene, contacts};

/// True for the vertices of two primitives that can collide, by definition.
type Definition = Box<dyn Fn(&[u32], &[u32]) -> bool>;

/// A rule, the pairs of vertex lists that it allows, by definition, and flags of the vertices that take
/// part, all if there are none.
type Rule = (CanCollide, Definition, Vec<bool>);

fn is_in(parts: &[bool], vertex: u32) -> bool {
    parts.get(vertex as usize) != Some(&false)
}

/// Rules of all kinds for the vertices of a scene of pieces.
fn rules(random: &mut Rng) -> Vec<Rule> {
    let count = 4 * PIECES;
    let flags: Vec<bool> = (0..count).map(|_| random.u8(..3) > 0).collect();
    // Shorter than the number of vertices.
    let groups: Vec<u32> = (0..count - 3).map(|vertex| vertex as u32 / 4 % 2).collect();
    let parts: Vec<bool> = (0..count - 2).map(|_| random.u8(..8) > 0).collect();
    let odd = |a: &[u32], b: &[u32]| (a[0] + b[0]) % 2 == 1;
    let group =
        |groups: &[u32], vertex: u32| groups.get(vertex as usize).map_or(1000 + vertex, |&group| group);
    vec![
        (CanCollide::all(), Box::new(|_, _| true), Vec::new()),
        (CanCollide::new(odd), Box::new(odd), Vec::new()),
        (
            CanCollide::any_vertices(|v, w| v + w == 20),
            Box::new(|a, b| a.iter().any(|v| b.iter().any(|w| v + w == 20))),
            Vec::new(),
        ),
        (
            CanCollide::not_two_obstacles(flags.clone()),
            {
                let flags = flags.clone();
                Box::new(move |a, b| [a, b].concat().iter().any(|&vertex| !flags[vertex as usize]))
            },
            Vec::new(),
        ),
        (
            CanCollide::different_groups(groups.clone()),
            Box::new(move |a, b| {
                let first = group(&groups, a[0]);
                [a, b]
                    .concat()
                    .iter()
                    .any(|&vertex| group(&groups, vertex) != first)
            }),
            Vec::new(),
        ),
        (
            CanCollide::not_two_obstacles(flags.clone()).among(parts.clone()),
            {
                let parts = parts.clone();
                Box::new(move |a, b| {
                    let all = [a, b].concat();
                    all.iter().all(|&vertex| is_in(&parts, vertex))
                        && all.iter().any(|&vertex| !flags[vertex as usize])
                })
            },
            parts,
        ),
        (
            CanCollide::all().among(vec![false; count]),
            Box::new(|_, _| false),
            vec![false; count],
        ),
    ]
}

#[test]
fn contacts_are_those_of_the_pairs_that_can_collide() {
    let mut random = Rng::with_seed(3);
    let (mut found, mut left_out) = (0, 0);
    for _ in 0..60 {
        let (scene, scale) = Scene::pieces(&mut random);
        let step = scene.step();
        for (rule, is_allowed, parts) in rules(&mut random) {
            // Pairs of the definition, not of the rule itself.
            let pairs = scene.pairs_among(&CanCollide::all(), |vertex| is_in(&parts, vertex));
            let all = contacts(step, &pairs);
            let expected: Vec<_> = all
                .iter()
                .filter(|contact| {
                    let vertices = contact.pair.vertices(&scene.mesh).unwrap();
                    let (a, b) = vertices.split_at(match contact.pair {
                        Pair::EdgeEdge { .. } => 2,
                        Pair::VertexFace { .. } | Pair::VertexEdge { .. } | Pair::VertexVertex { .. } => 1,
                    });
                    is_allowed(a, b)
                })
                .copied()
                .collect();
            found += expected.len();
            left_out += all.len() - expected.len();

            for boxes in [BoxKind::Swept, BoxKind::Moving] {
                let options = CandidateOptions::default()
                    .with_distance(0.1 * scale)
                    .with_boxes(boxes)
                    .with_can_collide(rule.clone());
                let candidates = Candidates::with_options(step, &Bvh, &options).unwrap();
                assert_eq!(candidates.contacts(step), expected);
                let report = StepReport::with_options(step, &Bvh, &options, &|_| ()).unwrap();
                assert_eq!(report.candidates, candidates.counts());
                assert_eq!(report.colliding.total(), expected.len());
                assert_eq!(report.earliest, expected.first().copied());
            }

            let mut detector = Detector::new(scene.mesh.clone()).with_can_collide(rule);
            for _ in 0..2 {
                let (x0, x1) = (&scene.x0, &scene.x1);
                assert_eq!(detector.contacts(x0, x1, 1.0).unwrap(), expected);
                assert_eq!(
                    detector.earliest_contact(x0, x1).unwrap(),
                    expected.first().copied()
                );
                assert_eq!(detector.is_free(x0, x1).unwrap(), expected.is_empty());
            }
        }
    }
    assert!(found > 1000 && left_out > 500, "{found} {left_out}");
}

#[test]
fn candidates_are_those_of_all_pairs_that_can_collide() {
    let mut random = Rng::with_seed(4);
    for _ in 0..40 {
        let (scene, _) = Scene::pieces(&mut random);
        let all = Candidates::new(scene.step(), &Bvh);
        for (rule, ..) in rules(&mut random) {
            let allowed = scene.pairs(&rule);
            let options = CandidateOptions::default().with_can_collide(rule);
            let candidates = Candidates::with_options(scene.step(), &Bvh, &options).unwrap();
            let both = |a: &[[u32; 2]], b: &[[u32; 2]]| -> Vec<[u32; 2]> {
                a.iter().filter(|pair| b.contains(pair)).copied().collect()
            };
            assert_eq!(
                candidates.vertex_face(),
                both(all.vertex_face(), allowed.vertex_face())
            );
            assert_eq!(candidates.edge_edge(), both(all.edge_edge(), allowed.edge_edge()));
        }
    }
}

#[test]
fn edges_and_vertices_are_loose_among_those_that_take_part() {
    // The face is at rest; vertex 3 passes through its edge from 0 to 1.
    let at = |z: f64| [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [1.0, 0.0, z]];
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).unwrap();
    let rule = CanCollide::all().among(vec![true, true, false, true]);
    let mut detector = Detector::new(mesh).with_can_collide(rule);
    let contact = detector.earliest_contact(&at(1.0), &at(-1.0)).unwrap().unwrap();
    assert_eq!(contact.pair, Pair::VertexEdge { vertex: 3, edge: 0 });
    assert_eq!(contact.impact.time.lower(), 0.5);
}

#[test]
fn the_corner_of_a_face_that_is_one_vertex_meets_rods_and_points() {
    // The face is vertex 0 three times.
    let at = |z: f64| [[0.0, 0.0, z], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -0.5]];
    let mesh = TriangleMesh::with_edges(4, vec![[0; 3]], &[[1, 2]]).unwrap();
    let mut detector = Detector::new(mesh);
    let contacts = detector.contacts(&at(1.0), &at(-1.0), 1.0).unwrap();
    let pairs: Vec<_> = contacts.iter().map(|contact| contact.pair).collect();
    let expected = [
        Pair::VertexEdge { vertex: 0, edge: 0 },
        Pair::VertexFace { vertex: 3, face: 0 },
        Pair::VertexVertex { a: 0, b: 3 },
    ];
    assert_eq!(pairs, expected);
}
