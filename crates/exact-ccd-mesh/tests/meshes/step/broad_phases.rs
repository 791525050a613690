//! Broad phases of other crates.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use exact_ccd::CONTACT;
use exact_ccd_mesh::{
    BoxPairs, Boxes, BroadPhase, Bvh, Detector, FreeStepOptions, IntersectionOptions, Motion, PairSink,
    Point, intersections,
};

use super::motions::{falling_sheet, sheet};
use super::{motion, report};

/// A broad phase that counts its calls and pairs, for boxes at rest and boxes that move.
#[derive(Default)]
struct Counted {
    calls: [AtomicUsize; 2],
    pairs: [AtomicUsize; 2],
}

impl Counted {
    fn begin<'a, const T: usize>(
        &'a self,
        sink: &'a PairSink<'a>,
    ) -> impl Fn(&[[u32; 2]]) -> ControlFlow<()> + Sync + 'a {
        self.calls[T - 1].fetch_add(1, Ordering::Relaxed);
        move |pairs| {
            self.pairs[T - 1].fetch_add(pairs.len(), Ordering::Relaxed);
            sink(pairs)
        }
    }

    /// The numbers of calls with boxes at rest, and with boxes that move.
    fn calls(&self) -> [usize; 2] {
        self.calls.each_ref().map(|count| count.load(Ordering::Relaxed))
    }

    fn pairs(&self) -> usize {
        self.pairs.iter().map(|count| count.load(Ordering::Relaxed)).sum()
    }
}

impl<const T: usize> BoxPairs<T> for Counted
where
    Bvh: BoxPairs<T>,
{
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Bvh.between(a, b, &self.begin::<T>(sink))
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Bvh.within(boxes, &self.begin::<T>(sink))
    }
}

/// A detector that counts, and its counts.
fn counting(motion: &Motion) -> (Detector, Arc<Counted>) {
    let counted = Arc::new(Counted::default());
    (
        Detector::with_broad_phase(motion.mesh.clone(), counted.clone()),
        counted,
    )
}

/// Triangles that fall through others, some of them from nearby.
fn falling_triangles() -> Motion {
    let triangle = |i: u32, z: f64| {
        let (x, y) = (f64::from(i % 60), f64::from(i / 60));
        [[x, y, z], [x + 0.3, y, z], [x, y + 0.3, z]]
    };
    let floor: Vec<Point> = (0..3600).flat_map(|i| triangle(i, 0.0)).collect();
    let height = |i: u32| if i % 31 == 7 { 0.001 } else { 0.5 };
    let falling = (0..3600).flat_map(|i| triangle(i, height(i)));
    let end = (0..3600).flat_map(|i| triangle(i, -1.0));
    let x0: Vec<Point> = floor.iter().copied().chain(falling).collect();
    let x1 = floor.into_iter().chain(end).collect();
    motion(x0, x1, (0..7200).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect())
}

/// The sample finds a triangle nearby, and boxes are placed anew for the time until then.
#[test]
fn an_early_contact_leaves_few_pairs() {
    let motion = falling_triangles();
    let candidates = report(&motion, &Bvh).candidates.total();
    let (mut detector, counted) = counting(&motion);
    let contact = detector.collision(&motion.x0, &motion.x1, CONTACT).unwrap();
    assert!(contact.is_some_and(|contact| contact.impact.time.upper() < 0.001));
    assert!(
        10 * counted.pairs() < candidates,
        "{} of {candidates}",
        counted.pairs()
    );
}

/// Both the sample and the search after it count.
#[test]
fn boxes_at_rest_serve_short_displacements_only() {
    let (x0, faces) = sheet(40, 0.0);
    let calls = |size: f64| {
        let x1 = x0
            .iter()
            .enumerate()
            .map(|(i, [x, y, z])| [*x, *y, z + size * (i % 2) as f64]);
        let motion = motion(x0.clone(), x1.collect(), faces.clone());
        let (mut detector, counted) = counting(&motion);
        assert_eq!(detector.collision(&motion.x0, &motion.x1, CONTACT), Ok(None));
        counted.calls()
    };
    let [at_rest, moving] = calls(0.1);
    assert!(at_rest > 0 && moving == 0, "{at_rest} {moving}");
    let [at_rest, moving] = calls(5.0);
    assert!(at_rest == 0 && moving > 0, "{at_rest} {moving}");
}

/// The search that certifies a free step is among the pairs that the first one kept.
#[test]
fn a_free_step_has_one_broad_phase() {
    for motion in [falling_sheet(), falling_triangles()] {
        let (mut detector, of_contact) = counting(&motion);
        detector.collision(&motion.x0, &motion.x1, CONTACT).unwrap();
        let (mut detector, of_step) = counting(&motion);
        let step = detector.free_step(&motion.x0, &motion.x1, &FreeStepOptions::default());
        assert!(step.unwrap().size > 0.0);
        assert_eq!(of_step.calls(), of_contact.calls());
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
        let (mut detector, counted) = counting(&motion);
        assert_eq!(detector.collides(&motion.x0, &motion.x1, CONTACT), Ok(false));
        counted.pairs()
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

/// So does single precision at rest, where an edge is shorter than its units.
#[test]
fn a_place_far_away_does_not_increase_the_number_of_pairs_at_rest() {
    let pairs = |shift: f64| {
        let (x0, faces) = sheet(40, 0.0);
        let x: Vec<Point> = x0.iter().map(|[x, y, z]| [x + shift, y - shift, *z]).collect();
        let motion = motion(x.clone(), x, faces);
        let counted = Counted::default();
        let options = IntersectionOptions::default();
        assert_eq!(
            intersections(&motion.mesh, &motion.x0, &counted, &options),
            Ok(Vec::new())
        );
        counted.pairs()
    };
    let near = pairs(0.0);
    assert!(near > 1000);
    assert_eq!(pairs(f64::from(1 << 30)), near);
}

/// A mesh of any size has the boxes of the same mesh at the size 1, as far as their powers of two.
#[test]
fn the_size_of_a_mesh_does_not_increase_the_number_of_pairs() {
    let apart = falling_sheet();
    let answers = |power: i32| {
        let scaled = |x: &[Point]| -> Vec<Point> {
            let times = |x: &f64| x * 2.0_f64.powi(power / 2) * 2.0_f64.powi(power - power / 2);
            x.iter().map(|point| point.each_ref().map(times)).collect()
        };
        let motion = motion(scaled(&apart.x0), scaled(&apart.x1), apart.mesh.faces().to_vec());
        let counted = Counted::default();
        let report = report(&motion, &counted);
        let at_rest = Counted::default();
        let options = IntersectionOptions::default();
        let crossing = intersections(&motion.mesh, &motion.x0, &at_rest, &options);
        let (mut detector, certified) = counting(&motion);
        let free = detector.free_step(&motion.x0, &motion.x1, &FreeStepOptions::default());
        let time = report.earliest.map(|contact| contact.impact.time);
        (
            counted.pairs(),
            at_rest.pairs(),
            certified.pairs(),
            time,
            crossing.unwrap().len(),
            free.unwrap().size,
        )
    };
    let expected = answers(0);
    assert!(expected.0 > 10_000 && expected.1 > 1000);
    for power in [-900, -300, -130, -60, 60, 130, 300, 1000] {
        assert_eq!(answers(power), expected, "{power}");
    }
}

/// Boxes, too, are relative to the other vertices: without the common part of the motion, the numbers of
/// pairs, of candidates and of contacts are the same.
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
        (counted.pairs(), report.candidates, report.colliding, contacts)
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
    let found = detector
        .free_steps(&motion.x0, &motion.x1, &[], &FreeStepOptions::default())
        .unwrap();
    assert_eq!(found.sizes, vec![1.0; motion.x0.len()]);
    let mut detector = detector.with_start_check(true);
    assert_eq!(detector.collides(&motion.x0, &motion.x1, CONTACT), Ok(false));
}

/// The pairs of the default broad phase, and some that do not exist.
struct Partly;

impl<const T: usize> BoxPairs<T> for Partly
where
    Bvh: BoxPairs<T>,
{
    fn between(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Nonsense.between(a, b, sink)?;
        Bvh.between(a, b, sink)
    }

    fn within(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Nonsense.within(boxes, sink)?;
        Bvh.within(boxes, sink)
    }
}

#[test]
fn nonsense_beside_pairs_changes_no_free_step() {
    let motion = falling_sheet();
    let options = FreeStepOptions::default();
    let sizes = |broad_phase: Arc<dyn BroadPhase>| {
        let detector = Detector::with_broad_phase(motion.mesh.clone(), broad_phase);
        let mut detector = detector.with_start_check(true);
        detector
            .free_steps(&motion.x0, &motion.x1, &[], &options)
            .unwrap()
            .sizes
    };
    let expected = sizes(Arc::new(Bvh));
    assert!(expected.iter().any(|&size| size < 1.0));
    assert_eq!(sizes(Arc::new(Partly)), expected);
}

/// The step does not count as short, the part of it until the contacts of the sample does, and is longer than
/// half of it: boxes at rest are placed then, and find an earlier contact beside the sample.
#[test]
fn boxes_at_rest_are_placed_after_the_sample() {
    let distance = 0.109375;
    let floor = |x: f64, y: f64| [[x, y, 0.0], [x + 0.3, y, 0.0], [x, y + 0.3, 0.0]];
    let above = |x: f64, y: f64, z: f64| {
        [
            [x + 0.05, y + 0.05, z],
            [x + 0.1, y + 0.05, z],
            [x + 0.05, y + 0.1, z],
        ]
    };
    let places: Vec<[f64; 2]> = (0..3600)
        .map(|i| [f64::from(i % 60), f64::from(i / 60)])
        .collect();
    let resting = places.iter().flat_map(|&[x, y]| floor(x, y));
    let faces = (0..7200).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let height = |place: usize, early: usize| distance * if place == early { 0.6 } else { 0.7 };
    let falling = |early: usize, down: f64| -> Vec<Point> {
        let points = places.iter().enumerate();
        points
            .flat_map(|(i, &[x, y])| above(x, y, height(i, early) - down))
            .collect()
    };
    let at = |early, down| resting.clone().chain(falling(early, down)).collect();
    let mut motion = motion(at(0, 0.0), at(0, distance), faces);
    for early in [0, 1234, 2345, 3599] {
        (motion.x0, motion.x1) = (at(early, 0.0), at(early, distance));
        let mut detector = Detector::new(motion.mesh.clone());
        let contact = detector.collision(&motion.x0, &motion.x1, CONTACT).unwrap();
        let time = contact.unwrap().impact.time.lower();
        assert!((0.59..0.61).contains(&time), "{early} {time}");
    }
}
