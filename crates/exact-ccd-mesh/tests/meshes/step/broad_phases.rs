//! Broad phases of other crates.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use exact_ccd::CONTACT;
use exact_ccd_mesh::{BoxPairs, Boxes, Bvh, Detector, PairSink, Point};

use super::motions::{falling_sheet, sheet};
use super::{motion, report};

/// A broad phase that counts its pairs.
#[derive(Default)]
struct Counted(AtomicUsize);

impl<const T: usize> BoxPairs<T> for Counted
where
    Bvh: BoxPairs<T>,
{
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Bvh.between(a, b, &|pairs| {
            self.0.fetch_add(pairs.len(), Ordering::Relaxed);
            sink(pairs)
        })
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Bvh.within(boxes, &|pairs| {
            self.0.fetch_add(pairs.len(), Ordering::Relaxed);
            sink(pairs)
        })
    }
}

/// Coordinates are relative to the other vertices, so that single precision suffices for these.
#[test]
fn a_vertex_far_away_does_not_increase_the_number_of_pairs() {
    let pairs = |strays: &[Point]| {
        let (mut x0, faces) = sheet(40, 0.0);
        x0.extend(strays);
        let x1: Vec<Point> = x0.iter().map(|[x, y, z]| [*x, *y, z - 0.1]).collect();
        let motion = motion(x0, x1, faces);
        let counted = Arc::new(Counted::default());
        let mut detector = Detector::with_broad_phase(motion.mesh.clone(), counted.clone());
        assert_eq!(detector.collides(&motion.x0, &motion.x1, CONTACT), Ok(false));
        counted.0.load(Ordering::Relaxed)
    };
    let near = pairs(&[[3.0, 4.0, 50.0]]);
    assert!(near > 10_000);
    for far in [1e9, -1e30, f64::MAX] {
        assert!(pairs(&[[far; 3]]) < near + near / 10, "{far}");
    }
    // Medians divide the vertices so that these are in the middle of the order.
    let row = (0..8).map(|i| [-1e6 - f64::from(i), 0.99, 0.0]);
    let strays: Vec<Point> = row.chain([[0.0, -1e9, 0.0]]).collect();
    assert!(pairs(&strays) < near + near / 10);
}

/// Boxes, too, are relative to the other vertices: the numbers of pairs, of candidates and of contacts are
/// those of the motion without the common part.
#[test]
fn a_common_motion_does_not_matter() {
    let apart = falling_sheet();
    let answers = |shift: f64| {
        let shifted = |x: &[Point]| {
            x.iter()
                .map(|[x, y, z]| [x + shift, y - shift, z + 2.0 * shift])
                .collect()
        };
        let motion = motion(apart.x0.clone(), shifted(&apart.x1), apart.mesh.faces().to_vec());
        let counted = Counted::default();
        let report = report(&motion, &counted);
        let mut detector = Detector::new(motion.mesh.clone());
        assert_eq!(
            detector.collision(&motion.x0, &motion.x1, CONTACT),
            Ok(report.earliest)
        );
        let contacts = detector.collisions(&motion.x0, &motion.x1, CONTACT).unwrap();
        let contacts: Vec<_> = contacts
            .into_iter()
            .map(|contact| (contact.pair, contact.impact.time))
            .collect();
        (
            counted.0.into_inner(),
            report.candidates,
            report.colliding,
            contacts,
        )
    };
    let expected = answers(0.0);
    assert!(expected.3.len() > 1000);
    for shift in [1.0, 1000.0, 1e9] {
        assert_eq!(answers(shift), expected, "{shift}");
    }
}

/// A broad phase that names primitives that do not exist.
struct Nonsense;

impl<const T: usize> BoxPairs<T> for Nonsense {
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        sink(&[[a.len() as u32, 0], [0, b.len() as u32], [u32::MAX; 2]])
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        self.between(boxes, boxes, sink)
    }
}

#[test]
fn nonsense_from_a_broad_phase_is_no_contact() {
    let motion = falling_sheet();
    assert!(report(&motion, &Nonsense).is_free());
    let mut detector = Detector::with_broad_phase(motion.mesh.clone(), Arc::new(Nonsense));
    assert_eq!(detector.collides(&motion.x0, &motion.x1, CONTACT), Ok(false));
    assert_eq!(detector.collision(&motion.x0, &motion.x1, CONTACT), Ok(None));
}
