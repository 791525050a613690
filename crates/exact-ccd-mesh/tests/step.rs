//! The report of a step against integer arithmetic for every pair of primitives.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::ops::{ControlFlow, RangeInclusive};
use std::sync::atomic::{AtomicUsize, Ordering};

use exact_ccd::{EdgeEdge, Impact, Kind, Query, VertexEdge, VertexFace, VertexVertex, exact};
use exact_ccd_mesh::{
    AllPairs, Boxes, BroadPhase, Bvh, Candidates, Detector, Motion, Pair, PairCounts, PairSink, Point, Step,
    StepError, StepReport, Sweep, TriangleMesh, advance, step,
};
use proptest::prelude::*;

fn motion(x0: Vec<Point>, x1: Vec<Point>, faces: Vec<[u32; 3]>) -> Motion {
    let mesh = TriangleMesh::new(x0.len(), faces).unwrap();
    Motion { mesh, x0, x1 }
}

fn report(motion: &Motion, broad_phase: &impl BroadPhase) -> StepReport {
    StepReport::new(motion.step().unwrap(), broad_phase, &|_| ())
}

/// The contacts of a step in integer arithmetic, for every pair without a common vertex.
#[derive(Default)]
struct Truth {
    vertex_face: Vec<[u32; 2]>,
    edge_edge: Vec<[u32; 2]>,
    vertex_edge: Vec<[u32; 2]>,
    vertex_vertex: Vec<[u32; 2]>,
    colliding: PairCounts,
    touching: PairCounts,
    earliest: Option<(Pair, Impact)>,
}

impl Truth {
    fn of(motion: &Motion) -> Self {
        let mut truth = Self::default();
        let at = |vertices| [&motion.x0, &motion.x1].map(|x| gather(x, vertices));
        for vertex in 0..motion.x0.len() as u32 {
            for (face, &[a, b, c]) in (0..).zip(motion.mesh.faces()) {
                if [a, b, c].contains(&vertex) {
                    continue;
                }
                let [t0, t1] = at([vertex, a, b, c]);
                if boxes_meet([&t0[..1], &t1[..1]], [&t0[1..], &t1[1..]]) {
                    truth.vertex_face.push([vertex, face]);
                }
                let pair = Pair::VertexFace { vertex, face };
                let (colliding, touching) = truth.count(pair, Query::<VertexFace>::new(t0, t1).unwrap());
                truth.colliding.vertex_face += colliding;
                truth.touching.vertex_face += touching;
            }
        }
        let edges = motion.mesh.edges();
        for (b, &[b0, b1]) in (0..).zip(edges) {
            for (a, &[a0, a1]) in (0..).zip(&edges[..b as usize]) {
                if [a0, a1].iter().any(|vertex| [b0, b1].contains(vertex)) {
                    continue;
                }
                let [t0, t1] = at([a0, a1, b0, b1]);
                if boxes_meet([&t0[..2], &t1[..2]], [&t0[2..], &t1[2..]]) {
                    truth.edge_edge.push([a, b]);
                }
                let (colliding, touching) =
                    truth.count(Pair::EdgeEdge { a, b }, Query::<EdgeEdge>::new(t0, t1).unwrap());
                truth.colliding.edge_edge += colliding;
                truth.touching.edge_edge += touching;
            }
        }
        truth.edge_edge.sort_unstable();
        truth.count_loose(motion);
        truth
    }

    /// Counts the pairs of loose vertices with loose edges and with each other.
    fn count_loose(&mut self, motion: &Motion) {
        let points: Vec<u32> = motion.mesh.loose_vertices().collect();
        let rods = motion.mesh.loose_edges();
        let first_rod = (motion.mesh.edges().len() - rods.len()) as u32;
        for (i, &p) in points.iter().enumerate() {
            for (edge, &[a, b]) in (first_rod..).zip(rods) {
                let [t0, t1] = [&motion.x0, &motion.x1].map(|x| gather(x, [p, a, b]));
                if boxes_meet([&t0[..1], &t1[..1]], [&t0[1..], &t1[1..]]) {
                    self.vertex_edge.push([p, edge]);
                }
                let pair = Pair::VertexEdge { vertex: p, edge };
                let (colliding, touching) = self.count(pair, Query::<VertexEdge>::new(t0, t1).unwrap());
                self.colliding.vertex_edge += colliding;
                self.touching.vertex_edge += touching;
            }
            for &q in &points[i + 1..] {
                let [t0, t1] = [&motion.x0, &motion.x1].map(|x| gather(x, [p, q]));
                if boxes_meet([&t0[..1], &t1[..1]], [&t0[1..], &t1[1..]]) {
                    self.vertex_vertex.push([p, q]);
                }
                let pair = Pair::VertexVertex { a: p, b: q };
                let (colliding, touching) = self.count(pair, Query::<VertexVertex>::new(t0, t1).unwrap());
                self.colliding.vertex_vertex += colliding;
                self.touching.vertex_vertex += touching;
            }
        }
    }

    /// Counts a pair: 1 if it collides, and 1 if it touches at t = 0. Keeps the earliest contact.
    fn count<K: Kind>(&mut self, pair: Pair, query: Query<K>) -> (usize, usize) {
        let Some(time) = exact::contact_times(&query).first() else {
            return (0, 0);
        };
        let impact = query.impact().unwrap();
        assert_eq!(impact.time, time);
        let key =
            |(pair, impact): &(Pair, Impact)| (impact.time.lower().to_bits(), !impact.time.is_exact(), *pair);
        let earlier = self
            .earliest
            .is_none_or(|earliest| key(&(pair, impact)) < key(&earliest));
        if earlier {
            self.earliest = Some((pair, impact));
        }
        (1, usize::from(time.is_exact() && time.lower() == 0.0))
    }
}

fn gather<const N: usize>(x: &[Point], vertices: [u32; N]) -> [Point; N] {
    vertices.map(|vertex| x[vertex as usize])
}

/// True if the boxes around two primitives over the step have a common point.
fn boxes_meet(a: [&[Point]; 2], b: [&[Point]; 2]) -> bool {
    (0..3).all(|axis| {
        let interval = |points: [&[Point]; 2]| {
            let values = points.concat().into_iter().map(|point| point[axis]);
            (
                values.clone().fold(f64::INFINITY, f64::min),
                values.fold(f64::NEG_INFINITY, f64::max),
            )
        };
        let ((a_lower, a_upper), (b_lower, b_upper)) = (interval(a), interval(b));
        a_lower <= b_upper && b_lower <= a_upper
    })
}

/// Motions of a few faces, with or without area, rods and points between whole numbers, so that many
/// contacts coincide in time.
fn small_motion() -> impl Strategy<Value = Motion> {
    let coordinate = || (-2..=2).prop_map(f64::from);
    let positions = move |count| prop::collection::vec(prop::array::uniform3(coordinate()), count);
    let faces = |count: usize| prop::collection::vec(prop::array::uniform3(0..count as u32), 2..9);
    let rods = |count: usize| prop::collection::vec(prop::array::uniform2(0..count as u32), 0..4);
    (3_usize..20)
        .prop_flat_map(move |count| (positions(count), positions(count), faces(count), rods(count)))
        .prop_map(|(x0, x1, faces, rods)| {
            let mesh = TriangleMesh::with_edges(x0.len(), faces, &rods).unwrap();
            Motion { mesh, x0, x1 }
        })
}

/// Triangles that pass through each other, far from the origin, at speeds between powers of 2.
fn soup(speeds: RangeInclusive<i32>) -> impl Strategy<Value = Motion> {
    let triangle = move || {
        let vector = || prop::array::uniform3(-1.0..1.0);
        (vector(), vector(), vector(), vector(), speeds.clone()).prop_map(|(at, u, v, velocity, exponent)| {
            let (size, speed) = (0.2, 2.0_f64.powi(exponent));
            let corner = |offset: Point| -> [Point; 2] {
                let start = [0, 1, 2].map(|k: usize| 1000.0 + at[k] + size * offset[k]);
                [start, [0, 1, 2].map(|k: usize| start[k] + speed * velocity[k])]
            };
            [corner([0.0; 3]), corner(u), corner(v)]
        })
    };
    prop::collection::vec(triangle(), 2..60).prop_map(|triangles| {
        let corners: Vec<[Point; 2]> = triangles.concat();
        let faces = (0..triangles.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]);
        let at = |time: usize| corners.iter().map(|ends| ends[time]).collect();
        motion(at(0), at(1), faces.collect())
    })
}

/// Unrelated steps of one mesh, some of them slow, some of them far from the origin.
fn steps() -> impl Strategy<Value = (TriangleMesh, Vec<[Vec<Point>; 2]>)> {
    let coordinate = || prop_oneof![(-2..=2).prop_map(f64::from), -2.0..2.0];
    let points = move |count| prop::collection::vec(prop::array::uniform3(coordinate()), count);
    let step = move |count| (points(count), points(count), -30..=0, -3..=9);
    (3_u32..40)
        .prop_flat_map(move |count| {
            let faces = prop::collection::vec(prop::array::uniform3(0..count), 2..40);
            let steps = prop::collection::vec(step(count as usize), 1..6);
            (Just(count as usize), faces, steps)
        })
        .prop_map(|(count, faces, steps)| {
            let steps = steps.into_iter().map(|(x0, directions, speed, scale)| {
                let [speed, scale] = [speed, scale].map(|exponent| 2.0_f64.powi(exponent));
                let x0: Vec<Point> = x0.iter().map(|x| x.map(|x| scale * x)).collect();
                let x1 = advance(&x0, &directions, scale * speed);
                [x0, x1]
            });
            (TriangleMesh::new(count, faces).unwrap(), steps.collect())
        })
}

fn assert_searches_agree(motion: &Motion, report: &StepReport) {
    fn check(step: Step<'_>, broad_phase: &impl BroadPhase, report: &StepReport) {
        assert_eq!(step.earliest_contact(broad_phase), report.earliest);
        assert_eq!(step.is_free(broad_phase), report.is_free());
    }
    let step = motion.step().unwrap();
    check(step, &Bvh, report);
    check(step, &Sweep, report);
    check(step, &AllPairs, report);
}

proptest! {
    #[test]
    fn a_report_counts_the_contacts_of_every_pair(motion in small_motion()) {
        let truth = Truth::of(&motion);
        let candidates = Candidates::new(motion.step().unwrap(), &Bvh);
        prop_assert_eq!(candidates.vertex_face(), truth.vertex_face);
        prop_assert_eq!(candidates.edge_edge(), truth.edge_edge);
        prop_assert_eq!(candidates.vertex_edge(), truth.vertex_edge);
        prop_assert_eq!(candidates.vertex_vertex(), truth.vertex_vertex);

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
            let step = Step::new(&mesh, x0, x1).unwrap();
            prop_assert_eq!(detector.is_free(x0, x1), Ok(step.is_free(&Bvh)));
            prop_assert_eq!(detector.earliest_contact(x0, x1), Ok(step.earliest_contact(&Bvh)));
        }
    }

    #[test]
    fn a_detector_answers_after_an_error((mesh, steps) in steps(), vertex in any::<prop::sample::Index>()) {
        let mut detector = Detector::new(mesh.clone());
        for [x0, x1] in &steps {
            let mut broken = x1.clone();
            broken[vertex.index(x1.len())][1] = f64::NAN;
            prop_assert!(matches!(detector.is_free(x0, &broken), Err(StepError::End(_))));
            prop_assert!(matches!(detector.earliest_contact(&broken, x1), Err(StepError::Start(_))));
            let report = step(&mesh, x0, x1).unwrap();
            prop_assert_eq!(detector.earliest_contact(x0, x1), Ok(report.earliest));
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

/// A square sheet of 2 n² faces with sides of length n, at a height.
fn sheet(n: u32, height: f64) -> (Vec<Point>, Vec<[u32; 3]>) {
    let row = n + 1;
    let positions = (0..row * row).map(|v| [f64::from(v % row), f64::from(v / row), height]);
    let squares = (0..n * n).map(|square| square / n * row + square % n);
    let faces = squares.flat_map(|v| [[v, v + 1, v + row], [v + 1, v + row + 1, v + row]]);
    (positions.collect(), faces.collect())
}

/// A sheet that falls through a parallel one, so that all pairs touch at the same time.
fn falling_sheet() -> Motion {
    let (lower, mut faces) = sheet(24, 0.0);
    let count = lower.len() as u32;
    faces.extend(faces.clone().iter().map(|face| face.map(|corner| corner + count)));
    let upper = |height| [lower.clone(), sheet(24, height).0].concat();
    motion(upper(0.5), upper(-1.0), faces)
}

#[test]
fn the_report_is_the_same_on_any_number_of_threads() {
    let motion = falling_sheet();
    let reports = [1, 2, 5].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            let report = report(&motion, &Bvh);
            assert_searches_agree(&motion, &report);
            report
        })
    });
    // Enough for several batches on every thread.
    assert!(reports[0].candidates.vertex_face > 10_000 && reports[0].candidates.edge_edge > 10_000);
    assert_eq!(reports[0], reports[1]);
    assert_eq!(reports[0], reports[2]);
}

#[test]
fn among_contacts_at_the_same_time_the_least_pair_is_named() {
    let report = report(&falling_sheet(), &Bvh);
    assert!(report.colliding.vertex_face > 1000);
    let earliest = report.earliest.unwrap();
    // Vertex 0 falls from or onto the corner of the first face of the other sheet, the first of its
    // 24 × 24 × 2.
    let face = 24 * 24 * 2;
    assert_eq!(earliest.pair, Pair::VertexFace { vertex: 0, face });
    assert_eq!(earliest.impact.time.lower(), 1.0_f64 / 3.0);
    assert_eq!(report.touching, PairCounts::default());
}

#[test]
fn neighbours_are_left_out() {
    // A tetrahedron whose corners coincide.
    let corners = vec![[0.0; 3]; 4];
    let faces = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let motion = motion(corners.clone(), corners, faces);
    let report = report(&motion, &Bvh);
    // Each vertex and the face opposite, each edge and the edge opposite.
    let opposite = PairCounts {
        vertex_face: 4,
        edge_edge: 3,
        ..PairCounts::default()
    };
    assert_eq!(report.candidates, opposite);
    assert_eq!(report.touching, opposite);
}

#[test]
fn one_face_alone_is_free() {
    let flips = motion(
        vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        vec![[1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
        vec![[0, 1, 2]],
    );
    let report = report(&flips, &Bvh);
    assert!(report.is_free());
    assert_eq!(report.time_of_impact(), None);
    assert_eq!(report.candidates.total(), 0);
}

#[test]
fn no_mesh_is_free() {
    let nothing = motion(vec![], vec![], vec![]);
    assert!(report(&nothing, &Bvh).is_free());
    let point = motion(vec![[0.0; 3]], vec![[0.0; 3]], vec![]);
    assert!(report(&point, &Bvh).is_free());
}

#[test]
fn points_that_coincide_touch() {
    let (a, b) = ([0.0; 3], [1.0, 0.0, 0.0]);
    let points = motion(vec![a, b, a], vec![a, a, b], vec![]);
    let report = report(&points, &Bvh);
    assert_eq!(
        (report.colliding.vertex_vertex, report.touching.vertex_vertex),
        (3, 1)
    );
    let earliest = report.earliest.unwrap();
    assert_eq!(earliest.pair, Pair::VertexVertex { a: 0, b: 2 });
    assert!(earliest.impact.touching_at_start());
}

#[test]
fn progress_adds_up_to_the_candidates() {
    let motion = falling_sheet();
    let done = AtomicUsize::new(0);
    let report = StepReport::new(motion.step().unwrap(), &Bvh, &|count| {
        done.fetch_add(count, Ordering::Relaxed);
    });
    assert_eq!(done.into_inner(), report.candidates.total());
}

#[test]
fn positions_that_do_not_fit_are_errors() {
    let mesh = TriangleMesh::new(3, vec![[0, 1, 2]]).unwrap();
    let good = [[0.0; 3]; 3];
    let message = |x0: &[Point], x1: &[Point]| step(&mesh, x0, x1).unwrap_err().to_string();
    assert_eq!(
        message(&good[..2], &good),
        "at the start, 2 positions, expected one for each of 3 vertices"
    );
    assert_eq!(
        message(&good, &[[0.0; 3]; 4]),
        "at the end, 4 positions, expected one for each of 3 vertices"
    );
    let mut bad = good;
    bad[2][1] = f64::NEG_INFINITY;
    assert_eq!(
        message(&bad, &good),
        "at the start, vertex 2 has y = -inf, expected a finite number"
    );
    bad[1][0] = f64::NAN;
    assert_eq!(
        message(&good, &bad),
        "at the end, vertex 1 has x = NaN, expected a finite number"
    );
}

#[test]
fn primitives_that_a_mesh_does_not_have_have_no_query() {
    let motion = falling_sheet();
    let step = motion.step().unwrap();
    let [vertices, faces, edges] = [
        motion.mesh.vertex_count(),
        motion.mesh.faces().len(),
        motion.mesh.edges().len(),
    ]
    .map(|count| count as u32);
    assert!(step.vertex_face(vertices - 1, faces - 1).is_some());
    assert_eq!(step.vertex_face(vertices, faces - 1), None);
    assert_eq!(step.vertex_face(vertices - 1, faces), None);
    assert!(step.edge_edge(edges - 1, 0).is_some());
    assert_eq!(step.edge_edge(edges, 0), None);
    assert_eq!(step.edge_edge(0, u32::MAX), None);
}

#[test]
fn a_query_has_its_points_in_the_order_of_its_primitives() {
    let x0 = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]];
    let x1 = x0.map(|[x, _, _]| [x, 1.0, 0.0]);
    let mesh = TriangleMesh::new(4, vec![[3, 1, 0], [2, 1, 3]]).unwrap();
    let step = Step::new(&mesh, &x0, &x1).unwrap();
    let query = step.vertex_face(2, 0).unwrap();
    assert_eq!(*query.points(), [x0, x1].map(|x| [x[2], x[3], x[1], x[0]]));
    // The edges are 01, 12, 03, 13, 23.
    let query = step.edge_edge(1, 2).unwrap();
    assert_eq!(*query.points(), [x0, x1].map(|x| [x[1], x[2], x[0], x[3]]));
}

/// A broad phase that counts its pairs.
#[derive(Default)]
struct Counted(AtomicUsize);

impl BroadPhase for Counted {
    fn between<const T: usize>(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Bvh.between(a, b, &|pairs| {
            self.0.fetch_add(pairs.len(), Ordering::Relaxed);
            sink(pairs)
        })
    }

    fn within<const T: usize>(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        Bvh.within(boxes, &|pairs| {
            self.0.fetch_add(pairs.len(), Ordering::Relaxed);
            sink(pairs)
        })
    }
}

/// Coordinates are relative to the other vertices, so that single precision suffices for these.
#[test]
fn a_vertex_far_away_does_not_increase_the_number_of_pairs() {
    let pairs = |stray: Point| {
        let (mut x0, faces) = sheet(40, 0.0);
        x0.push(stray);
        let x1: Vec<Point> = x0.iter().map(|[x, y, z]| [*x, *y, z - 0.1]).collect();
        let motion = motion(x0, x1, faces);
        let counted = Counted::default();
        assert!(motion.step().unwrap().is_free(&counted));
        counted.0.into_inner()
    };
    let near = pairs([3.0, 4.0, 50.0]);
    assert!(near > 10_000);
    for far in [1e9, -1e30, f64::MAX] {
        assert!(pairs([far; 3]) < near + near / 10, "{far}");
    }
}

/// A broad phase that names primitives that do not exist.
struct Nonsense;

impl BroadPhase for Nonsense {
    fn between<const T: usize>(&self, a: &Boxes<T>, b: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        sink(&[[a.len() as u32, 0], [0, b.len() as u32], [u32::MAX; 2]])
    }

    fn within<const T: usize>(&self, boxes: &Boxes<T>, sink: &PairSink<'_>) -> ControlFlow<()> {
        self.between(boxes, boxes, sink)
    }
}

#[test]
fn nonsense_from_a_broad_phase_is_no_contact() {
    let motion = falling_sheet();
    assert!(report(&motion, &Nonsense).is_free());
    assert!(motion.step().unwrap().is_free(&Nonsense));
    assert_eq!(motion.step().unwrap().earliest_contact(&Nonsense), None);
}

/// Vertex 3 reaches the face just after t = 1/2, vertex 4 just then: both times round down to 1/2.
#[test]
fn exactly_a_time_is_before_just_above_it() {
    let face = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let vertices = |late: f64, punctual: f64| vec![[1.0, 1.0, late], [1.0, 2.0, punctual]];
    let motion = motion(
        [face.to_vec(), vertices(1.0, 1.0)].concat(),
        [face.to_vec(), vertices((-1f64).next_up(), -1.0)].concat(),
        vec![[0, 1, 2]],
    );
    for vertex in [3, 4] {
        let time = motion
            .step()
            .unwrap()
            .vertex_face(vertex, 0)
            .unwrap()
            .time_of_impact();
        assert_eq!(time, Some(0.5));
    }
    let earliest = report(&motion, &Bvh).earliest.unwrap();
    assert_eq!(earliest.pair, Pair::VertexFace { vertex: 4, face: 0 });
    assert!(earliest.impact.time.is_exact());
}
