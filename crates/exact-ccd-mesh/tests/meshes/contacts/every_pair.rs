//! A broad phase that passes on every pair, neighbours in the mesh too, changes no answer.

use std::ops::ControlFlow;
use std::sync::Arc;

use exact_ccd::{Options, Separation};
use exact_ccd_mesh::{
    BoxKind, BoxPairs, Boxes, BroadPhase, Bvh, CandidateOptions, Candidates, Detector, FreeStepOptions,
    MinDistance, PairSink, StepReport,
};
use fastrand::Rng;

use super::scene::Scene;

pub(crate) struct EveryPair;

impl<const T: usize> BoxPairs<T> for EveryPair {
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        a.iter().try_for_each(|(i, _)| {
            let pairs: Vec<_> = b.iter().map(|(j, _)| [i, j]).collect();
            sink(&pairs)
        })
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        boxes.iter().try_for_each(|(i, _)| {
            let later = boxes.iter().filter(|(j, _)| i < *j);
            let pairs: Vec<_> = later.map(|(j, _)| [i, j]).collect();
            sink(&pairs)
        })
    }
}

#[test]
fn every_pair_has_the_answers_of_those_that_meet() {
    let mut random = Rng::with_seed(81);
    let mut found = 0;
    for case in 0..200 {
        let (scene, scale) = if case % 2 == 0 {
            Scene::pieces(&mut random)
        } else {
            Scene::mixed(&mut random)
        };
        let d = Separation::new(scale * [0.0, 0.05][random.usize(..2)]).unwrap();
        let options = Options::within(MinDistance::from(d));
        let free = FreeStepOptions::default().with_min_distance(d);
        let (mesh, x0, x1) = (Arc::new(scene.mesh.clone()), &scene.x0, &scene.x1);
        let mut usual = Detector::new(mesh.clone());
        let mut every = Detector::with_broad_phase(mesh, Arc::new(EveryPair));
        let contacts = usual.collisions(x0, x1, options.clone());
        assert_eq!(every.collisions(x0, x1, options.clone()), contacts);
        assert_eq!(
            every.collision(x0, x1, options.clone()),
            usual.collision(x0, x1, options.clone())
        );
        assert_eq!(
            every.collides(x0, x1, options.clone()),
            usual.collides(x0, x1, options)
        );
        assert_eq!(every.free_step(x0, x1, &free), usual.free_step(x0, x1, &free));
        assert_eq!(
            every.free_steps(x0, x1, &[], &free),
            usual.free_steps(x0, x1, &[], &free)
        );
        let candidates = CandidateOptions::default().with_min_distance(d);
        let colliding = |broad_phase: &dyn BroadPhase| {
            let report = StepReport::with_options(scene.step(), broad_phase, &candidates, &|_| ()).unwrap();
            (report.colliding, report.earliest)
        };
        assert_eq!(colliding(&EveryPair), colliding(&Bvh));
        found += usize::from(!contacts.unwrap().is_empty());
    }
    assert!((50..200).contains(&found), "{found}");
}

/// Candidates are decided by the boxes in double precision, which is the same for every broad phase.
#[test]
fn every_pair_has_the_candidates_of_those_that_meet() {
    let mut random = Rng::with_seed(82);
    for case in 0..60 {
        let (scene, scale) = if case % 2 == 0 {
            Scene::pieces(&mut random)
        } else {
            Scene::mixed(&mut random)
        };
        for boxes in [BoxKind::Swept, BoxKind::Moving] {
            let options = CandidateOptions::default()
                .with_boxes(boxes)
                .with_distance(scale * [0.0, 0.05][random.usize(..2)]);
            let found = |broad_phase: &dyn BroadPhase| {
                Candidates::with_options(scene.step(), broad_phase, &options).unwrap()
            };
            assert_eq!(found(&EveryPair), found(&Bvh));
        }
    }
}
