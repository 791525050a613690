//! Contacts within a minimum distance, compared with loops over all pairs.

use exact_ccd::{AnyKind, CONTACT, Options, Separation, Thickness};
use exact_ccd_mesh::{
    AllPairs, Audit, BoxKind, Bvh, CandidateError, CandidateOptions, Candidates, Contact, Detector, Frame,
    FreeStepOptions, MinDistance, PairCounts, Point, Step, StepError, StepReport, Sweep, ThicknessCount,
    TriangleMesh, Violation,
};
use fastrand::Rng;

use super::scene::{Scene, contacts, contacts_within, on_threads, touching};

fn separation(d: f64) -> Separation {
    Separation::new(d).unwrap()
}

/// One distance for all, thicknesses, and both with an inner distance.
fn min_distances(random: &mut Rng, vertices: usize, scale: f64) -> Vec<MinDistance> {
    let d = scale * [0.125, 0.25, 0.3][random.usize(..3)];
    let values: Vec<f64> = (0..vertices)
        .map(|_| scale * [0.0, 0.0625, 0.125, 0.07][random.usize(..4)])
        .collect();
    let uniform = MinDistance::uniform(separation(d));
    let thickness = MinDistance::thickness(Thickness::new(&values).unwrap());
    let inner = separation(scale * [0.0, 0.0625][random.usize(..2)]);
    vec![
        MinDistance::default(),
        uniform.clone().with_inner(inner),
        thickness.clone().with_inner(inner),
        uniform,
        thickness,
    ]
}

#[test]
fn answers_are_those_of_all_pairs() {
    let mut random = Rng::with_seed(30);
    let (mut free, mut kinds) = (0, PairCounts::default());
    for case in 0..30 {
        let (scene, scale) = Scene::mixed(&mut random);
        let (mesh, step) = (&scene.mesh, scene.step());
        let all = scene.pairs();
        let mut detector = Detector::new(mesh.clone());
        for min_distance in min_distances(&mut random, mesh.vertex_count(), scale) {
            let expected = contacts_within(step, &all, &min_distance);
            let earliest = expected.first().copied();
            let name = format!("case {case}, {min_distance:?}");

            let (x0, x1) = (&scene.x0[..], &scene.x1[..]);
            let within = || Options::within(min_distance.clone());
            let until = random.f64();
            let until_then: Vec<_> = expected
                .iter()
                .copied()
                .filter(|contact| {
                    let time = contact.impact.time;
                    time.lower() < until || time.is_exact() && time.lower() == until
                })
                .collect();
            // Memory of another distance does not matter.
            assert_eq!(detector.collision(x0, x1, within()).unwrap(), earliest, "{name}");
            assert_eq!(
                detector.collides(x0, x1, within()),
                Ok(!expected.is_empty()),
                "{name}"
            );
            assert_eq!(detector.collisions(x0, x1, within()).unwrap(), expected, "{name}");
            let any = !until_then.is_empty();
            assert_eq!(
                detector.collides(x0, x1, within().until(until)),
                Ok(any),
                "{name}"
            );
            let first = until_then.first().copied();
            assert_eq!(
                detector.collision(x0, x1, within().until(until)),
                Ok(first),
                "{name}"
            );
            assert_eq!(
                detector.collisions(x0, x1, within().until(until)),
                Ok(until_then),
                "{name}"
            );

            for boxes in [BoxKind::Swept, BoxKind::Moving] {
                let options = CandidateOptions::default()
                    .with_min_distance(min_distance.clone())
                    .with_boxes(boxes);
                let candidates = Candidates::with_options(step, &Bvh, &options).unwrap();
                assert_eq!(
                    Candidates::with_options(step, &Sweep, &options).unwrap(),
                    candidates
                );
                assert_eq!(
                    Candidates::with_options(step, &AllPairs, &options).unwrap(),
                    candidates
                );
                assert_eq!(candidates.collisions(step, within()), expected, "{name}");
                assert_eq!(candidates.collision(step, within()), earliest, "{name}");
                assert_eq!(
                    candidates.collides(step, within()),
                    !expected.is_empty(),
                    "{name}"
                );
                let end = step.at(random.f64());
                let shorter = Step::new(mesh, x0, &end).unwrap();
                let expected_before = contacts_within(shorter, &all, &min_distance);
                assert_eq!(
                    candidates.collisions(shorter, within()),
                    expected_before,
                    "{name}"
                );

                let report = StepReport::with_options(step, &Bvh, &options, &|_| ()).unwrap();
                let listed = StepReport::with_contacts(step, &Bvh, &options, &|_| ()).unwrap();
                assert_eq!(listed, (report, expected.clone()), "{name}");
                assert_eq!(report.candidates, candidates.counts(), "{name}");
                let colliding = expected.iter().map(|contact| contact.pair).collect();
                assert_eq!(report.colliding, colliding, "{name}");
                assert_eq!(
                    report.touching,
                    touching(step, &all, &min_distance).collect(),
                    "{name}"
                );
                assert_eq!(report.earliest, earliest, "{name}");
            }
            free += usize::from(expected.is_empty());
            for Contact { pair, .. } in expected {
                kinds[pair.kind()] += 1;
            }
        }
    }
    assert!(
        free > 10 && kinds.iter().all(|(_, &count)| count > 5),
        "{free} {kinds:?}"
    );
}

#[test]
fn a_larger_distance_has_all_contacts_of_a_smaller_one_and_no_later_ones() {
    let mut random = Rng::with_seed(31);
    for _ in 0..60 {
        let (scene, scale) = Scene::mixed(&mut random);
        let mut detector = Detector::new(scene.mesh.clone());
        let mut last: Option<Vec<Contact>> = None;
        for d in [0.0, 0.05, 0.125, 0.2, 0.5] {
            let options = Options::within(separation(scale * d));
            let contacts = detector.collisions(&scene.x0, &scene.x1, options).unwrap();
            for before in last.iter().flatten() {
                let now = contacts.iter().find(|now| now.pair == before.pair).unwrap();
                assert!(now.impact.time <= before.impact.time);
            }
            last = Some(contacts);
        }
    }
}

/// A free step is free for the rounded positions, and with `keep` 1 as long as it may be. The next step
/// starts where it ends, so that nearly all pairs are at their distance.
#[test]
fn free_steps_are_free_within_the_distance() {
    let mut random = Rng::with_seed(32);
    let (mut moved, mut touching_at_start) = (0, 0);
    for _ in 0..20 {
        let (scene, scale) = Scene::mixed(&mut random);
        for min_distance in min_distances(&mut random, scene.mesh.vertex_count(), 0.2 * scale) {
            let mut detector = Detector::new(scene.mesh.clone());
            let mut now = Scene {
                mesh: scene.mesh.clone(),
                x0: scene.x0.clone(),
                x1: scene.x1.clone(),
            };
            for keep in [1.0, 0.5, 1.0] {
                let options = FreeStepOptions::default().with_keep(keep);
                let options = options.with_min_distance(min_distance.clone());
                let all = now.pairs();
                let free = detector.free_step(&now.x0, &now.x1, &options).unwrap();
                let expected = contacts_within(now.step(), &all, &min_distance);
                assert_eq!(free.contact, expected.first().copied());
                let starting: PairCounts = touching(now.step(), &all, &min_distance).collect();
                assert_eq!(free.touching, starting);
                touching_at_start += starting.total();
                if free.size == 0.0 {
                    assert_eq!(free.positions, now.x0);
                } else {
                    let taken = Step::new(&now.mesh, &now.x0, &free.positions).unwrap();
                    assert_eq!(contacts_within(taken, &all, &min_distance), []);
                    moved += usize::from(free.size < 1.0);
                }
                if let Some(contact) = free.contact {
                    let largest = keep * contact.impact.time.lower();
                    assert!(free.size <= largest);
                    if free.size < largest {
                        let end = now.step().at(largest);
                        let longer = Step::new(&now.mesh, &now.x0, &end).unwrap();
                        assert_ne!(contacts_within(longer, &all, &min_distance), []);
                    }
                } else {
                    assert_eq!(free.size, 1.0);
                }
                now.x0 = free.positions;
            }
        }
    }
    assert!(
        moved > 50 && touching_at_start > 50,
        "{moved} {touching_at_start}"
    );
}

/// The frames of certified steps pass an audit with the same distance, and one with a larger distance finds
/// the first contact within it.
#[test]
fn audits_certify_the_distance() {
    let mut random = Rng::with_seed(36);
    let (mut certified, mut violated) = (0, 0);
    for _ in 0..90 {
        let (scene, scale) = Scene::mixed(&mut random);
        for min_distance in min_distances(&mut random, scene.mesh.vertex_count(), 0.1 * scale) {
            let mut detector = Detector::new(scene.mesh.clone());
            let options = FreeStepOptions::default().with_min_distance(min_distance.clone());
            let free = detector.free_step(&scene.x0, &scene.x1, &options).unwrap();
            let frame = |x: &[Point]| Frame {
                mesh: scene.mesh.clone(),
                positions: x.to_vec(),
            };
            let mut audit = Audit::default().with_min_distance(min_distance.clone());
            let options = Options::within(min_distance.clone());
            let at_rest = detector.collision(&scene.x0, &scene.x0, options).unwrap();
            let first = audit.examine(frame(&scene.x0)).unwrap();
            assert!(first.is_some() || at_rest.is_none());
            if first.is_some() {
                continue;
            }
            let step = audit.clone().examine(frame(&free.positions)).unwrap();
            assert_eq!(step, None);
            certified += 1;
            let full = audit.examine(frame(&scene.x1)).unwrap();
            let expected = free
                .contact
                .map(|contact| Violation::Contact { frame: 0, contact });
            assert_eq!(full, expected);
            violated += usize::from(full.is_some());
        }
    }
    assert!(certified > 20 && violated > 5, "{certified} {violated}");
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let mut random = Rng::with_seed(33);
    let scene = Scene::sheets(&mut random, 12, 0.0, 2.0);
    let min_distance = MinDistance::uniform(separation(0.45)).with_inner(separation(0.01));
    let [on_one, on_two, on_five] = [1, 2, 5].map(|threads| {
        on_threads(threads, || {
            let mut detector = Detector::new(scene.mesh.clone());
            let options = Options::within(min_distance.clone());
            let contacts = detector.collisions(&scene.x0, &scene.x1, options).unwrap();
            let options = FreeStepOptions::default().with_min_distance(min_distance.clone());
            let free = detector.free_step(&scene.x0, &scene.x1, &options).unwrap();
            let options = CandidateOptions::default().with_min_distance(min_distance.clone());
            let report = StepReport::with_options(scene.step(), &Bvh, &options, &|_| ()).unwrap();
            assert_eq!((report.touching, report.earliest), (free.touching, free.contact));
            (contacts, free, report)
        })
    });
    let (contacts, free, _) = &on_one;
    let touching = free.touching.total();
    assert!(
        contacts.len() > 50 && touching > 10,
        "{} {touching}",
        contacts.len()
    );
    assert_eq!(on_one, on_two);
    assert_eq!(on_one, on_five);
}

/// Without a minimum distance, the answers of a mesh with loose parts agree in all ways of asking.
#[test]
fn loose_parts_are_in_contact_for_every_search() {
    let mut random = Rng::with_seed(34);
    for _ in 0..60 {
        let (scene, _) = Scene::mixed(&mut random);
        let step = scene.step();
        let expected = contacts(step, &scene.pairs());
        let candidates = Candidates::new(step, &Bvh);
        assert_eq!(candidates.collisions(step, CONTACT), expected);
        assert_eq!(
            candidates.collides_by(step, &exact_ccd::Exact),
            !expected.is_empty()
        );
        let earliest = expected.first().map(|contact| contact.impact.time.lower());
        assert_eq!(candidates.time_of_impact_by(step, &exact_ccd::Exact), earliest);
        assert_eq!(StepReport::new(step, &Bvh, &|_| ()).time_of_impact(), earliest);
        let mut detector = Detector::new(scene.mesh.clone());
        let at_rest = detector
            .free_step(&scene.x0, &scene.x0, &FreeStepOptions::default())
            .unwrap();
        let touches = expected.iter().any(|contact| contact.impact.touching_at_start());
        assert_eq!(at_rest.size, if touches { 0.0 } else { 1.0 });
    }
}

#[test]
fn an_audit_does_not_use_an_inner_distance() {
    let frame = Frame::new(
        vec![[0.0; 3], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [1.0, 1.0, 0.3]],
        vec![[0, 1, 2]],
    );
    let frame = frame.unwrap();
    let outer = MinDistance::uniform(separation(0.5));
    for distance in [outer.clone(), outer.with_inner(separation(0.1))] {
        let violation = Audit::default()
            .with_min_distance(distance)
            .examine(frame.clone())
            .unwrap();
        assert!(matches!(violation, Some(Violation::Contact { frame: 0, .. })));
    }
}

/// Candidates of a mesh of four vertices, with a thickness each, in a step of a mesh of eight.
#[test]
fn vertices_of_another_mesh_have_no_thickness() {
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).unwrap();
    let face = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let start = [&face[..], &[[1.0, 1.0, 2.0]]].concat();
    let thickness = MinDistance::thickness(Thickness::new(&[0.25; 4]).unwrap());
    let options = CandidateOptions::default()
        .with_distance(4.0)
        .with_min_distance(thickness.clone());
    let step = Step::new(&mesh, &start, &start).unwrap();
    let candidates = Candidates::with_options(step, &Bvh, &options).unwrap();
    assert_eq!(candidates.of_kind(AnyKind::VertexFace), [[3, 0]]);

    let other = TriangleMesh::new(8, vec![[4, 5, 6]]).unwrap();
    let at = |height: f64| [&[[1.0, 1.0, height]; 4], &face[..], &[[9.0; 3]]].concat();
    for (heights, is_free) in [([2.0, 0.25], false), ([2.0, 0.5], true)] {
        let [x0, x1] = heights.map(at);
        let step = Step::new(&other, &x0, &x1).unwrap();
        let within = || Options::within(thickness.clone());
        assert_eq!(candidates.collides(step, within()), !is_free, "{heights:?}");
        assert_eq!(candidates.collisions(step, within()).len(), usize::from(!is_free));
        assert_eq!(candidates.collision(step, within()).is_none(), is_free);
    }
}

#[test]
fn a_number_of_thicknesses_that_is_not_that_of_vertices_is_an_error() {
    let (scene, _) = Scene::mixed(&mut Rng::with_seed(35));
    let thickness = MinDistance::thickness(Thickness::new(&[0.5; 21]).unwrap());
    let expected = ThicknessCount {
        count: 21,
        vertex_count: 22,
    };
    assert_eq!(
        expected.to_string(),
        "21 thicknesses, expected one for each of the 22 vertices"
    );
    assert_eq!(thickness.check(&scene.mesh), Err(expected));
    let mut detector = Detector::new(scene.mesh.clone());
    let found = detector.collides(&scene.x0, &scene.x1, Options::within(thickness.clone()));
    assert_eq!(found, Err(StepError::ThicknessCount(expected)));
    let options = CandidateOptions::default().with_min_distance(thickness);
    let candidates = Candidates::with_options(scene.step(), &Bvh, &options);
    assert_eq!(candidates.unwrap_err(), CandidateError::ThicknessCount(expected));
}

/// A vertex above a face, which both rest or move together: every step has its own distances.
#[test]
fn a_detector_takes_new_distances() {
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).unwrap();
    let x0 = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.25, 0.25, 1.0]];
    let mut detector = Detector::new(mesh);
    for by in [0.0, 100.0] {
        let x1 = x0.map(|x| x.map(|x| x + by));
        for large in [1.0, 10.0] {
            for (size, is_near) in [(0.125, false), (large, true)] {
                let thickness = MinDistance::thickness(Thickness::new(&[size; 4]).unwrap());
                let uniform = MinDistance::uniform(separation(size));
                for distance in [thickness, uniform] {
                    let found = detector.collides(&x0, &x1, Options::within(distance));
                    assert_eq!(found, Ok(is_near), "{by} {size}");
                }
            }
        }
    }
}

/// A vertex starts within the outer distance, and reaches the inner one late in the step; another one
/// reaches the outer distance, in which the inner one does not count.
#[test]
fn an_inner_distance_counts_for_what_starts_within_the_outer_one() {
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).unwrap();
    let at = |z: f64| [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [1.0, 1.0, z]];
    let mut detector = Detector::new(mesh);
    let outer = MinDistance::from(separation(2.0));
    for (inner, start, end, time) in [
        (0.25, 1.0, 0.0, Some(0.75)),
        (0.25, 1.0, 0.5, None),
        (0.25, 3.0, 0.0, Some(1.0 / 3.0)),
        (2.0, 1.0, 0.5, Some(0.0)),
        (3.0, 1.0, 0.5, Some(0.0)),
        (3.0, 2.5, 0.5, Some(0.25)),
    ] {
        let options = || Options::within(outer.clone().with_inner(separation(inner)));
        let (x0, x1) = (at(start), at(end));
        let lower = |contact: &Contact| contact.impact.time.lower();
        let earliest = detector.collision(&x0, &x1, options()).unwrap();
        assert_eq!(earliest.as_ref().map(lower), time, "{inner} {start} {end}");
        assert_eq!(detector.collides(&x0, &x1, options()), Ok(time.is_some()));
        assert_eq!(
            detector.collides_if(&x0, &x1, options(), |_| true),
            Ok(time.is_some())
        );
        assert_eq!(detector.collides_if(&x0, &x1, options(), |_| false), Ok(false));
        let all = detector.collisions(&x0, &x1, options()).unwrap();
        assert_eq!(all.iter().map(lower).collect::<Vec<_>>(), Vec::from_iter(time));
    }
}
