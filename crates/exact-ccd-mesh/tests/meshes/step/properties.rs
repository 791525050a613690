//! Reports and searches against each other and against integer arithmetic, on generated motions.

use std::sync::Arc;

use exact_ccd::{AnyKind, CONTACT};
use exact_ccd_mesh::{
    AllPairs, BroadPhase, Bvh, Candidates, Detector, Motion, StepError, StepReport, Sweep, step,
};
use proptest::prelude::*;

use super::motions::{small_motion, soup, steps};
use super::report;
use super::truth::Truth;

pub(crate) fn assert_searches_agree(motion: &Motion, report: &StepReport) {
    let all: [Arc<dyn BroadPhase>; 3] = [Arc::new(Bvh), Arc::new(Sweep), Arc::new(AllPairs)];
    for broad_phase in all {
        let (x0, x1) = (&motion.x0, &motion.x1);
        let mut detector = Detector::with_broad_phase(motion.mesh.clone(), broad_phase);
        assert_eq!(detector.collision(x0, x1, CONTACT), Ok(report.earliest));
        assert_eq!(detector.collides(x0, x1, CONTACT), Ok(!report.is_free()));
    }
}

proptest! {
    #[test]
    fn a_report_counts_the_contacts_of_every_pair(motion in small_motion()) {
        let truth = Truth::of(&motion);
        let candidates = Candidates::new(motion.step().unwrap(), &Bvh);
        prop_assert_eq!(candidates.of_kind(AnyKind::VertexFace), truth.vertex_face);
        prop_assert_eq!(candidates.of_kind(AnyKind::EdgeEdge), truth.edge_edge);
        prop_assert_eq!(candidates.of_kind(AnyKind::VertexEdge), truth.vertex_edge);
        prop_assert_eq!(candidates.of_kind(AnyKind::VertexVertex), truth.vertex_vertex);

        let report = step(&motion.mesh, &motion.x0, &motion.x1).unwrap();
        prop_assert_eq!(report.candidates, candidates.counts());
        prop_assert_eq!(report.colliding, truth.colliding);
        prop_assert_eq!(report.touching, truth.touching);
        prop_assert_eq!(report.is_free(), truth.earliest.is_none());
        let bits = |time: Option<f64>| time.map(f64::to_bits);
        let time = truth.earliest.map(|(_, impact)| impact.time.lower());
        prop_assert_eq!(bits(report.time_of_impact()), bits(time));
        let pair = truth.earliest.map(|(pair, _)| pair);
        prop_assert_eq!(report.earliest.map(|earliest| earliest.pair), pair);
        let impact = truth.earliest.map(|(_, impact)| impact);
        prop_assert_eq!(report.earliest.map(|earliest| earliest.impact), impact);

        prop_assert_eq!(self::report(&motion, &AllPairs), report);
        assert_searches_agree(&motion, &report);
    }

    #[test]
    fn the_earliest_contact_is_that_of_the_report(motion in prop_oneof![soup(-40..=4), soup(-40..=-6)]) {
        assert_searches_agree(&motion, &report(&motion, &Bvh));
    }

    #[test]
    fn answers_of_a_detector_do_not_depend_on_earlier_steps((mesh, steps) in steps()) {
        let mut detector = Detector::new(mesh.clone());
        for [x0, x1] in &steps {
            let mut other = Detector::new(mesh.clone());
            prop_assert_eq!(detector.collides(x0, x1, CONTACT), other.collides(x0, x1, CONTACT));
            prop_assert_eq!(detector.collision(x0, x1, CONTACT), other.collision(x0, x1, CONTACT));
        }
    }

    #[test]
    fn a_detector_answers_after_an_error((mesh, steps) in steps(), vertex in any::<prop::sample::Index>()) {
        let mut detector = Detector::new(mesh.clone());
        for [x0, x1] in &steps {
            let mut broken = x1.clone();
            broken[vertex.index(x1.len())][1] = f64::NAN;
            prop_assert!(matches!(detector.collides(x0, &broken, CONTACT), Err(StepError::End(_))));
            prop_assert!(matches!(detector.collision(&broken, x1, CONTACT), Err(StepError::Start(_))));
            let report = step(&mesh, x0, x1).unwrap();
            prop_assert_eq!(detector.collision(x0, x1, CONTACT), Ok(report.earliest));
        }
    }

    #[test]
    fn reversed_time_has_the_same_contacts(motion in small_motion()) {
        let forth = step(&motion.mesh, &motion.x0, &motion.x1).unwrap();
        let back = step(&motion.mesh, &motion.x1, &motion.x0).unwrap();
        prop_assert_eq!(forth.candidates, back.candidates);
        prop_assert_eq!(forth.colliding, back.colliding);
    }
}
