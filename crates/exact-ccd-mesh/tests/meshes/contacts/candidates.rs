//! The searches among candidates, compared with loops over all pairs.

use std::ops::ControlFlow;
use std::sync::Mutex;

use exact_ccd::batch::{Trajectories, VertexOutOfRange};
use exact_ccd::{
    AnyKind, CONTACT, Ccd, Decide, EdgeEdge, Exact, Guarantees, Kind, Query, TimeGuarantee, VertexFace,
};
use exact_ccd_mesh::{
    AllPairs, BoxKind, Bvh, CandidateError, CandidateOptions, Candidates, Contact, Detector, Pair, Point,
    Step, StepError, Sweep, TriangleMesh,
};
use fastrand::Rng;

use super::scene::{Scene, contacts, on_threads};
use crate::odd::Odd;

#[test]
fn contacts_of_candidates_are_those_of_all_pairs() {
    let mut random = Rng::with_seed(5);
    let mut between = 0;
    for _ in 0..150 {
        let (scene, _) = Scene::pieces(&mut random);
        let step = scene.step();
        let expected = contacts(step, &scene.pairs());
        let candidates = Candidates::new(step, &Bvh);
        assert_eq!(candidates.collisions(step, CONTACT), expected);
        assert_eq!(candidates.collision(step, CONTACT), expected.first().copied());
        assert_eq!(candidates.collides(step, CONTACT), !expected.is_empty());
        for until in [-0.0, 0.0, 0.3, 1.0]
            .into_iter()
            .chain(expected.iter().map(|contact| contact.impact.time.lower()))
        {
            let until_then: Vec<_> = expected
                .iter()
                .filter(|contact| {
                    let time = contact.impact.time;
                    time.lower() < until || time.is_exact() && time.lower() == until
                })
                .copied()
                .collect();
            between += usize::from(!until_then.is_empty() && until_then.len() < expected.len());
            let options = CONTACT.until(until);
            let mut detector = Detector::new(scene.mesh.clone());
            let (x0, x1) = (&scene.x0, &scene.x1);
            let (any, first) = (!until_then.is_empty(), until_then.first().copied());
            assert_eq!(candidates.collides(step, options), any, "{until}");
            assert_eq!(candidates.collision(step, options), first, "{until}");
            assert_eq!(candidates.collisions(step, options), until_then, "{until}");
            assert_eq!(detector.collides(x0, x1, options), Ok(any), "{until}");
            assert_eq!(detector.collision(x0, x1, options), Ok(first), "{until}");
            assert_eq!(detector.collisions(x0, x1, options), Ok(until_then), "{until}");
        }
        for time in [-5e-324, -1.0, 1.0f64.next_up(), f64::INFINITY, f64::NAN] {
            let options = CONTACT.until(time);
            let until_then = if time > 1.0 { &expected[..] } else { &[] };
            assert_eq!(candidates.collisions(step, options), until_then, "{time}");
            assert_eq!(
                candidates.collides(step, options),
                !until_then.is_empty(),
                "{time}"
            );
            let of_detector = Detector::new(scene.mesh.clone()).collisions(&scene.x0, &scene.x1, options);
            assert!(
                matches!(of_detector, Err(StepError::Time(error)) if error.time.to_bits() == time.to_bits()),
                "{time}: {of_detector:?}"
            );
        }
    }
    assert!(between > 100, "{between}");
}

#[test]
fn methods_decide_candidates_one_by_one() {
    let mut random = Rng::with_seed(6);
    let mut free = 0;
    for _ in 0..150 {
        let (scene, _) = Scene::pieces(&mut random);
        let step = scene.step();
        let candidates = Candidates::new(step, &Bvh);
        let methods: [&dyn Ccd; 2] = [&Exact, &Odd];
        for method in methods {
            let faces = candidates
                .of_kind(AnyKind::VertexFace)
                .iter()
                .filter_map(|&[vertex, face]| {
                    let query = step.query::<VertexFace>([vertex, face]).unwrap();
                    Decide::<VertexFace>::time_of_impact(method, &query)
                });
            let edges = candidates
                .of_kind(AnyKind::EdgeEdge)
                .iter()
                .filter_map(|&[a, b]| {
                    let query = step.query::<EdgeEdge>([a, b]).unwrap();
                    Decide::<EdgeEdge>::time_of_impact(method, &query)
                });
            let expected = faces.chain(edges).reduce(f64::min);
            assert_eq!(candidates.time_of_impact_by(step, method), expected);
            assert_eq!(candidates.collides_by(step, method), expected.is_some());
            free += usize::from(expected.is_none());
        }
        assert_eq!(
            candidates.collides_by(step, &Exact),
            candidates.collides(step, CONTACT)
        );
    }
    assert!(free > 10 && free < 290, "{free}");
}

#[test]
fn stored_and_streamed_candidates_are_the_same_with_every_broad_phase() {
    let mut random = Rng::with_seed(7);
    for _ in 0..60 {
        let (scene, scale) = Scene::pieces(&mut random);
        let step = scene.step();
        for boxes in [BoxKind::Swept, BoxKind::Moving] {
            for distance in [0.0, 0.2 * scale] {
                let options = CandidateOptions::default()
                    .with_distance(distance)
                    .with_boxes(boxes);
                let stored = Candidates::with_options(step, &Bvh, &options).unwrap();
                assert_eq!(Candidates::with_options(step, &Sweep, &options).unwrap(), stored);
                let streamed = Mutex::new(Vec::new());
                let flow = Candidates::stream(step, &AllPairs, &options, &|pairs| {
                    streamed.lock().unwrap().extend_from_slice(pairs);
                    ControlFlow::Continue(())
                });
                assert_eq!(flow.unwrap(), ControlFlow::Continue(()));
                let streamed: Candidates = streamed.into_inner().unwrap().into_iter().collect();
                assert_eq!(streamed, stored);
            }
        }
    }
}

/// Where no coordinate is rounded, a motion that all primitives have in common changes no candidate, and the
/// contacts are the same as by a search of all pairs.
#[test]
fn a_common_motion_does_not_matter() {
    let mut random = Rng::with_seed(11);
    let mut colliding = 0;
    for _ in 0..40 {
        let mut scene = Scene::sheets(&mut random, 4, 0.0, 1.0);
        let rounded = |x: &mut Vec<Point>| {
            x.as_flattened_mut()
                .iter_mut()
                .for_each(|x| *x = (*x * 1024.0).round() / 1024.0);
        };
        rounded(&mut scene.x0);
        rounded(&mut scene.x1);
        let candidates = Candidates::new(scene.step(), &Bvh);
        let expected = contacts(scene.step(), &scene.pairs());
        for size in [1.0, 1000.0] {
            scene
                .x1
                .iter_mut()
                .for_each(|[x, y, z]| (*x, *y, *z) = (*x + size, *y - 3.0 * size, *z + size));
            assert_eq!(Candidates::new(scene.step(), &Bvh), candidates);
            let found = candidates.collisions(scene.step(), CONTACT);
            assert_eq!(found, contacts(scene.step(), &scene.pairs()));
            let key = |contact: &Contact| (contact.pair, contact.impact.time);
            assert!(found.iter().map(key).eq(expected.iter().map(key)));
        }
        colliding += expected.len();
    }
    assert!(colliding > 100, "{colliding}");
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let mut random = Rng::with_seed(8);
    for _ in 0..5 {
        let scene = Scene::sheets(&mut random, 12, 0.0, 3.0);
        let step = scene.step();
        let options = CandidateOptions::default()
            .with_boxes(BoxKind::Moving)
            .with_distance(0.1);
        let [on_one, on_two, on_five] = [1, 2, 5].map(|threads| {
            on_threads(threads, || {
                let candidates = Candidates::with_options(step, &Bvh, &options).unwrap();
                let contacts = candidates.collisions(step, CONTACT);
                assert_eq!(candidates.collision(step, CONTACT), contacts.first().copied());
                (candidates, contacts)
            })
        });
        assert!(on_one.1.len() > 100);
        assert_eq!(on_one, on_two);
        assert_eq!(on_one, on_five);
    }
}

#[test]
fn pairs_that_a_mesh_does_not_have_are_no_contacts() {
    let (scene, _) = Scene::pieces(&mut Rng::with_seed(9));
    let nonsense: Candidates = [[u32::MAX, 0], [1000, u32::MAX], [u32::MAX; 2]]
        .into_iter()
        .flat_map(|[i, j]| {
            [
                Pair::VertexFace { vertex: i, face: j },
                Pair::EdgeEdge { a: i, b: j },
                Pair::VertexEdge { vertex: i, edge: j },
                Pair::VertexVertex { a: i, b: j },
            ]
        })
        .collect();
    assert_eq!(nonsense.counts().total(), 12);
    let neighbours = [
        Pair::VertexFace { vertex: 0, face: 0 },
        Pair::EdgeEdge { a: 0, b: 0 },
        Pair::VertexVertex { a: 1, b: 1 },
    ];
    let nonsense: Candidates = nonsense.pairs().chain(neighbours).collect();
    assert_eq!(nonsense.counts().total(), 15);
    assert!(!nonsense.is_empty() && Candidates::default().is_empty());
    assert!(!nonsense.collides(scene.step(), CONTACT));
    assert!(!nonsense.collides_by(scene.step(), &Odd));
    assert_eq!(nonsense.collisions(scene.step(), CONTACT), []);
    assert_eq!(nonsense.time_of_impact_by(scene.step(), &Exact), None);
}

/// Boxes around whole paths, as other software has, are not relative to anything that moves.
#[test]
fn swept_boxes_overlap_in_a_common_motion() {
    let mesh = TriangleMesh::new(3, Vec::new()).unwrap();
    let [x0, x1] = [0.0, 10.0].map(|shift| [0.0, 5.0, 16.0].map(|x| [x + shift, 0.0, 0.0]));
    let step = Step::new(&mesh, &x0, &x1).unwrap();
    for (boxes, expected) in [(BoxKind::Swept, 1), (BoxKind::Moving, 0)] {
        let options = CandidateOptions::default().with_boxes(boxes);
        let found = Candidates::with_options(step, &Bvh, &options).unwrap();
        assert_eq!(found.of_kind(AnyKind::VertexVertex).len(), expected, "{boxes:?}");
    }
}

#[test]
fn distances_that_are_no_distances_are_errors() {
    let (scene, _) = Scene::pieces(&mut Rng::with_seed(10));
    for distance in [-1.0, f64::NEG_INFINITY, f64::NAN] {
        let options = CandidateOptions::default().with_distance(distance);
        let error = Candidates::with_options(scene.step(), &Bvh, &options).unwrap_err();
        let CandidateError::Distance(found) = error else {
            panic!("{error}");
        };
        assert_eq!(found.to_bits(), distance.to_bits());
    }
    // All pairs are within an infinite distance.
    let options = CandidateOptions::default().with_distance(f64::INFINITY);
    for boxes in [BoxKind::Swept, BoxKind::Moving] {
        let options = options.clone().with_boxes(boxes);
        let candidates = Candidates::with_options(scene.step(), &Bvh, &options).unwrap();
        assert_eq!(candidates, scene.pairs());
    }
}

/// A face, a loose edge and a loose vertex, and three others that come to the same point at the end.
#[test]
fn candidates_meet_at_any_time_of_the_step() {
    let mesh = TriangleMesh::with_edges(12, vec![[0, 1, 2], [6, 7, 8]], &[[3, 4], [9, 10]]).unwrap();
    let x0 = (0..12)
        .map(|vertex| [if vertex < 6 { 0.0 } else { 8.0 }, 0.0, 0.0])
        .collect();
    let x1 = vec![[0.0; 3]; 12];
    let scene = Scene { mesh, x0, x1 };
    for boxes in [BoxKind::Swept, BoxKind::Moving] {
        let options = CandidateOptions::default().with_boxes(boxes);
        let candidates = Candidates::with_options(scene.step(), &Bvh, &options).unwrap();
        assert_eq!(candidates, scene.pairs());
        let counts = candidates.counts();
        assert!(counts[AnyKind::VertexEdge] > 0 && counts[AnyKind::VertexVertex] > 0);
    }
}

/// A method that finds a contact at the same time in each query; at no time, it refuses all queries.
struct At(Option<f64>);

impl<K: Kind> Decide<K> for At {
    fn collides(&self, _: &Query<K>) -> bool {
        true
    }

    fn times_of_impact(
        &self,
        _: &Trajectories,
        queries: &[K::Vertices],
        sink: &mut dyn FnMut(usize, f64),
    ) -> Result<(), VertexOutOfRange> {
        let time = self.0.ok_or(VertexOutOfRange {
            query: 0,
            vertex: 0,
            vertex_count: 0,
        })?;
        (0..queries.len()).for_each(|query| sink(query, time));
        Ok(())
    }
}

impl Ccd for At {
    fn name(&self) -> &'static str {
        "at"
    }

    fn guarantees(&self) -> Guarantees {
        Guarantees {
            false_negatives: false,
            false_positives: true,
            time: TimeGuarantee::Approximate,
        }
    }
}

#[test]
fn times_of_a_method_are_in_the_step() {
    let scene = Scene::sheets(&mut Rng::with_seed(36), 4, 0.0, 1.0);
    let candidates = Candidates::new(scene.step(), &Bvh);
    for (time, expected) in [
        (Some(0.25), 0.25),
        (Some(1.0), 1.0),
        (Some(1.5), 1.0),
        (Some(f64::INFINITY), 1.0),
        (Some(-0.5), 0.0),
        (Some(f64::NAN), 0.0),
        (None, 0.0),
    ] {
        assert_eq!(
            candidates.time_of_impact_by(scene.step(), &At(time)),
            Some(expected),
            "{time:?}"
        );
    }
}

#[test]
fn each_pair_is_kept_once() {
    let pairs = |i, j| {
        [
            Pair::VertexFace { vertex: i, face: j },
            Pair::EdgeEdge { a: i, b: j },
            Pair::VertexEdge { vertex: i, edge: j },
            Pair::VertexVertex { a: i, b: j },
        ]
    };
    let kept: Candidates = [[4, 7], [4, 7], [7, 4]]
        .into_iter()
        .flat_map(|[i, j]| pairs(i, j))
        .collect();
    assert_eq!(
        (
            kept.of_kind(AnyKind::VertexFace),
            kept.of_kind(AnyKind::VertexEdge)
        ),
        (&[[4, 7], [7, 4]][..], &[[4, 7], [7, 4]][..])
    );
    assert_eq!(
        (
            kept.of_kind(AnyKind::EdgeEdge),
            kept.of_kind(AnyKind::VertexVertex)
        ),
        (&[[4, 7]][..], &[[4, 7]][..])
    );
}

/// All vertices reach their faces at t = 1/3, which is no f64: the least pair is the earliest, wherever the
/// search begins.
#[test]
fn of_equal_times_the_least_pair_is_the_earliest() {
    let count = 3000;
    // Neighbours have far numbers.
    let place = |i: u32| {
        [
            f64::from(i * 1009 % count % 50),
            f64::from(i * 1009 % count / 50),
            0.0,
        ]
    };
    let corners =
        |i: u32| [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[x, y]| [place(i)[0] + x, place(i)[1] + y, 0.0]);
    let at = |z: f64| -> Vec<Point> {
        let vertices = (0..count).map(|i| [place(i)[0] + 0.125, place(i)[1] + 0.125, z]);
        (0..count).flat_map(corners).chain(vertices).collect()
    };
    let faces = (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mesh = TriangleMesh::new(4 * count as usize, faces).unwrap();
    let (x0, x1) = (at(1.0), at(-2.0));
    let least = Pair::VertexFace {
        vertex: 3 * count,
        face: 0,
    };
    let contact = Detector::new(mesh).collision(&x0, &x1, CONTACT).unwrap().unwrap();
    assert_eq!(contact.pair, least);
    assert!(!contact.impact.time.is_exact());
}
