//! The steps of the scenes, compared with a plain loop over all candidates.

use std::sync::Arc;

use exact_ccd::{AnyKind, CONTACT, EdgeEdge, VertexFace};
use exact_ccd_data::DataKind;
use exact_ccd_mesh::{
    Bvh, Candidates, Detector, Pair, PairCounts, Point, Step, StepReport, Sweep, advance, step,
};
use rayon::ThreadPoolBuilder;

use crate::scenes;

/// A pair in contact. The order is that in which a step prefers one as its earliest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Contact {
    /// The bits of the time of impact: times are not negative, so that these are in the same order.
    toi: u64,
    is_above: bool,
    /// 0 for a vertex and a face, 1 for two edges.
    kind: u8,
    ids: [u32; 2],
}

fn contacts<K: DataKind>(kind: u8, step: &Step<'_>, candidates: &[[u32; 2]]) -> Vec<Contact> {
    let contact = |&ids| {
        let time = step.query::<K>(ids)?.collision(CONTACT)?.time();
        Some(Contact {
            toi: time.lower().to_bits(),
            is_above: !time.is_exact(),
            kind,
            ids,
        })
    };
    candidates.iter().filter_map(contact).collect()
}

fn earliest(report: &StepReport) -> Option<Contact> {
    report.earliest.map(|earliest| {
        let (kind, ids) = match earliest.pair {
            Pair::VertexFace { vertex, face } => (0, [vertex, face]),
            Pair::EdgeEdge { a, b } => (1, [a, b]),
            other => panic!("the scenes have no loose primitives: {other:?}"),
        };
        Contact {
            toi: earliest.impact.time.lower().to_bits(),
            is_above: !earliest.impact.time.is_exact(),
            kind,
            ids,
        }
    })
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn a_step_reports_what_a_loop_over_all_candidates_finds() {
    for scene in scenes() {
        let name = scene.name();
        let motion = scene.motion().unwrap();
        let report = step(&motion.mesh, &motion.x0, &motion.x1).unwrap();

        let step = motion.step().unwrap();
        let candidates = Candidates::new(step, &Bvh);
        let faces = contacts::<VertexFace>(0, &step, candidates.of_kind(AnyKind::VertexFace));
        let edges = contacts::<EdgeEdge>(1, &step, candidates.of_kind(AnyKind::EdgeEdge));
        let counts = |of_interest: fn(&&Contact) -> bool| {
            let mut counts = PairCounts::default();
            counts[AnyKind::VertexFace] = faces.iter().filter(of_interest).count();
            counts[AnyKind::EdgeEdge] = edges.iter().filter(of_interest).count();
            counts
        };

        assert_eq!(report.candidates, candidates.counts(), "{name}");
        assert_eq!(report.colliding, counts(|_| true), "{name}");
        assert_eq!(
            report.touching,
            counts(|contact| contact.toi == 0 && !contact.is_above),
            "{name}"
        );
        assert_eq!(
            earliest(&report),
            faces.iter().chain(&edges).min().copied(),
            "{name}"
        );
        assert!(!report.is_free(), "{name}");
    }
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn a_step_reports_the_same_on_any_number_of_threads() {
    for scene in scenes() {
        let motion = scene.motion().unwrap();
        let [on_one, on_two] = [1, 2].map(|threads| {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let report = step(&motion.mesh, &motion.x0, &motion.x1).unwrap();
                let mut detector = Detector::new(motion.mesh.clone());
                let mut sweep = Detector::with_broad_phase(motion.mesh.clone(), Arc::new(Sweep));
                let (x0, x1) = (&motion.x0, &motion.x1);
                for _ in 0..2 {
                    let earliest = detector.collision(x0, x1, CONTACT).unwrap();
                    assert_eq!(earliest, report.earliest, "{}", scene.name());
                    assert_eq!(sweep.collision(x0, x1, CONTACT), Ok(earliest));
                    assert_eq!(detector.collides(x0, x1, CONTACT), Ok(!report.is_free()));
                }
                report
            })
        });
        assert_eq!(on_one, on_two, "{}", scene.name());
    }
}

/// The step that ends just before the earliest contact is free by every search.
#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn a_step_until_before_the_earliest_contact_is_free() {
    for scene in scenes() {
        let motion = scene.motion().unwrap();
        let mut detector = Detector::new(motion.mesh.clone());
        let earliest = detector.collision(&motion.x0, &motion.x1, CONTACT);
        let earliest = earliest.unwrap().expect("each scene has a contact");
        let size = 0.9 * earliest.impact.time.lower();
        let direction: Vec<_> = motion
            .x0
            .iter()
            .zip(&motion.x1)
            .map(|(a, b)| difference(*b, *a))
            .collect();
        let end = advance(&motion.x0, &direction, size);
        let (collides, collision) = (
            detector.collides(&motion.x0, &end, CONTACT),
            detector.collision(&motion.x0, &end, CONTACT),
        );
        assert_eq!((collides, collision), (Ok(false), Ok(None)), "{}", scene.name());
    }
}

fn difference(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// All candidates of the small scene, and a fraction of the candidates of the other scenes.
#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn candidates_have_the_contact_times_of_the_exact_path() {
    fn check<K: DataKind>(step: &Step<'_>, candidates: &[[u32; 2]]) {
        let stride = if candidates.len() < 50_000 { 1 } else { 211 };
        for &ids in candidates.iter().step_by(stride) {
            let query = step.query::<K>(ids).expect("a pair of the mesh");
            assert_eq!(
                query.intervals(CONTACT),
                query.exactly().intervals(CONTACT),
                "{query:?}"
            );
        }
    }
    for scene in scenes() {
        let motion = scene.motion().unwrap();
        let step = motion.step().unwrap();
        let candidates = Candidates::new(step, &Bvh);
        check::<VertexFace>(&step, candidates.of_kind(AnyKind::VertexFace));
        check::<EdgeEdge>(&step, candidates.of_kind(AnyKind::EdgeEdge));
    }
}

/// The same bits at any optimisation level, on any machine: `cargo test` and `cargo test --release`
/// both compare with these.
#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn contacts_and_times_have_the_recorded_bits() {
    let digests = scenes().into_iter().map(|scene| {
        let motion = scene.motion().unwrap();
        let step = motion.step().unwrap();
        let candidates = Candidates::new(step, &Bvh);
        let faces = contacts::<VertexFace>(0, &step, candidates.of_kind(AnyKind::VertexFace));
        let edges = contacts::<EdgeEdge>(1, &step, candidates.of_kind(AnyKind::EdgeEdge));
        let words = faces.iter().chain(&edges).flat_map(|contact| {
            let [a, b] = contact.ids.map(u64::from);
            [contact.toi, u64::from(contact.is_above), a, b]
        });
        (scene.name(), fnv_1a(words))
    });
    let expected = [
        ("cloth-ball", 11676334898218327127),
        ("cloth-funnel", 16450644589896873935),
        ("rod-twist", 9862288484661653189),
    ];
    let expected: Vec<_> = expected.map(|(name, digest)| (name.to_owned(), digest)).into();
    assert_eq!(digests.collect::<Vec<_>>(), expected);
}

/// Fowler, Noll and Vo's hash of words of eight bytes.
fn fnv_1a(words: impl Iterator<Item = u64>) -> u64 {
    let bytes = words.flat_map(u64::to_le_bytes);
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
    })
}
