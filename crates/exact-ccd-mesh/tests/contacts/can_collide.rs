//! Every search examines only the pairs that can collide.

use exact_ccd_mesh::{BoxKind, Bvh, CanCollide, CandidateOptions, Candidates, Detector, Pair, StepReport};
use fastrand::Rng;

use crate::scene::{PIECES, Scene, contacts};

/// True for the vertices of two primitives that can collide, by definition.
type Definition = Box<dyn Fn(&[u32], &[u32]) -> bool + Sync>;

/// Rules of all kinds for the vertices of a scene of pieces, and the pairs of vertex lists that
/// they allow, by definition.
fn rules(random: &mut Rng) -> Vec<(CanCollide, Definition)> {
    let count = 4 * PIECES;
    let flags: Vec<bool> = (0..count).map(|_| random.u8(..3) > 0).collect();
    // Shorter than the number of vertices.
    let groups: Vec<u32> = (0..count - 3).map(|vertex| vertex as u32 / 4 % 2).collect();
    let parts: Vec<bool> = (0..count - 2).map(|_| random.u8(..8) > 0).collect();
    let odd = |a: &[u32], b: &[u32]| (a[0] + b[0]) % 2 == 1;
    let group =
        |groups: &[u32], vertex: u32| groups.get(vertex as usize).map_or(1000 + vertex, |&group| group);
    let is_in = |parts: &[bool], vertex: u32| parts.get(vertex as usize) != Some(&false);
    vec![
        (CanCollide::all(), Box::new(|_, _| true)),
        (CanCollide::new(odd), Box::new(odd)),
        (
            CanCollide::any_vertices(|v, w| v + w == 20),
            Box::new(|a, b| a.iter().any(|v| b.iter().any(|w| v + w == 20))),
        ),
        (CanCollide::not_two_obstacles(flags.clone()), {
            let flags = flags.clone();
            Box::new(move |a, b| [a, b].concat().iter().any(|&vertex| !flags[vertex as usize]))
        }),
        (CanCollide::different_groups(groups.clone()), {
            Box::new(move |a, b| {
                let first = group(&groups, a[0]);
                [a, b]
                    .concat()
                    .iter()
                    .any(|&vertex| group(&groups, vertex) != first)
            })
        }),
        (
            CanCollide::not_two_obstacles(flags.clone()).among(parts.clone()),
            {
                Box::new(move |a, b| {
                    let all = [a, b].concat();
                    all.iter().all(|&vertex| is_in(&parts, vertex))
                        && all.iter().any(|&vertex| !flags[vertex as usize])
                })
            },
        ),
        (
            CanCollide::all().among(vec![false; count]),
            Box::new(|_, _| false),
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
        let all = contacts(step, &scene.pairs(&CanCollide::all()));
        for (rule, is_allowed) in rules(&mut random) {
            // Pairs of the definition, not of the rule itself.
            let is_allowed = |pair: Pair| {
                let four = pair.vertices(&scene.mesh).unwrap();
                let first = if pair < (Pair::EdgeEdge { a: 0, b: 0 }) {
                    1
                } else {
                    2
                };
                let (a, b) = four.split_at(first);
                is_allowed(a, b)
            };
            let allowed = all.iter().filter(|contact| is_allowed(contact.pair));
            let expected: Vec<_> = allowed.copied().collect();
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

            let mut open = Detector::new(scene.mesh.clone());
            let is_free = open.is_free_of(&scene.x0, &scene.x1, is_allowed).unwrap();
            assert_eq!(is_free, expected.is_empty());
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
    assert!(found > 1000 && left_out > 1000, "{found} {left_out}");
}

#[test]
fn candidates_are_those_of_all_pairs_that_can_collide() {
    let mut random = Rng::with_seed(4);
    for _ in 0..40 {
        let (scene, _) = Scene::pieces(&mut random);
        let all = Candidates::new(scene.step(), &Bvh);
        for (rule, _) in rules(&mut random) {
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
