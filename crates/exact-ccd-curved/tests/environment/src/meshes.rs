//! Triangles that move: contacts by a detector, and candidates.

use std::sync::Arc;

use exact_ccd::CONTACT;
use exact_ccd_mesh::{
    BoxKind, Bvh, CandidateOptions, Candidates, Detector, FreeStepOptions, Pair, Point, Step, Sweep,
    TriangleMesh,
};

use crate::random::Random;

/// Enough that the work is shared among threads.
const TRIANGLES: usize = 60;

/// A mesh in a step.
pub struct Scene {
    name: &'static str,
    mesh: TriangleMesh,
    ends: [Vec<Point>; 2],
}

/// The contacts of a scene: their pairs, and the two f64 around their times.
pub type Contacts = Vec<(Pair, u64, u64)>;

impl Scene {
    /// Small triangles that move a little, by the function that makes a point near the center of a triangle.
    fn new(name: &'static str, seed: u64, point: impl Fn(&mut Random, [f64; 2]) -> Point) -> Self {
        let mut random = Random(seed);
        let faces = (0..TRIANGLES as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
        let mut ends = [Vec::new(), Vec::new()];
        for _ in 0..TRIANGLES {
            let center = [random.number(), random.number()];
            for _ in 0..3 {
                ends[0].push(point(&mut random, center));
                ends[1].push(point(&mut random, center));
            }
        }
        let mesh = TriangleMesh::new(3 * TRIANGLES, faces.collect()).expect("the faces are valid");
        Self { name, mesh, ends }
    }

    /// All scenes: in the plane x = −y, in units of the smallest subnormal number, and in space.
    pub fn all() -> [Self; 3] {
        let near = |random: &mut Random, x: f64| x + 0.03 * random.number();
        [
            Self::new("plane", 1, |random, [a, b]| {
                // Near 0, where most differences are not f64.
                let x = near(random, 0.0);
                [x, -x, near(random, 2.0 * a + 0.1 * b)]
            }),
            Self::new("subnormal", 2, |random, [a, b]| {
                let mut coordinate = |x: f64| {
                    let size = (40.0 * x).round() + random.integer(4);
                    let magnitude = f64::from_bits(size.abs() as u64);
                    if size < 0.0 { -magnitude } else { magnitude }
                };
                [coordinate(a), coordinate(b), coordinate(0.0)]
            }),
            Self::new("space", 3, |random, [a, b]| {
                [near(random, 3.0 * a), near(random, 3.0 * b), near(random, 0.0)]
            }),
        ]
    }

    /// The contacts of the step in five ways: all; the earliest; all with the other broad phase; and among
    /// the candidates of both kinds of boxes.
    pub fn contacts(&self) -> [Contacts; 5] {
        let [x0, x1] = &self.ends;
        let key = |contact: &exact_ccd_mesh::Contact| {
            let time = contact.impact.time;
            (contact.pair, time.lower().to_bits(), time.upper().to_bits())
        };
        let mut detector = Detector::new(self.mesh.clone());
        let all = detector.collisions(x0, x1, CONTACT).expect("the step is valid");
        let earliest = detector.collision(x0, x1, CONTACT).expect("the step is valid");
        let mut sweep = Detector::with_broad_phase(self.mesh.clone(), Arc::new(Sweep));
        let swept = sweep.collisions(x0, x1, CONTACT).expect("the step is valid");
        let among = |boxes: BoxKind| {
            let step = Step::new(&self.mesh, x0, x1).expect("the step is valid");
            let options = CandidateOptions::default().with_boxes(boxes);
            let candidates = Candidates::with_options(step, &Bvh, &options).expect("the options are valid");
            candidates.collisions(step, CONTACT).iter().map(key).collect()
        };
        [
            all.iter().map(key).collect(),
            earliest.iter().map(key).collect(),
            swept.iter().map(key).collect(),
            among(BoxKind::Swept),
            among(BoxKind::Moving),
        ]
    }

    pub fn name(&self) -> &'static str {
        self.name
    }
}

/// A vertex that falls onto a face from the least positive height: the mesh, the start and the end.
fn low() -> (TriangleMesh, [Vec<Point>; 2]) {
    let mesh = TriangleMesh::new(4, vec![[0, 1, 2]]).expect("the face is valid");
    let at = |z: f64| vec![[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [1.0, 1.0, z]];
    (mesh, [at(f64::from_bits(1)), at(-0.6)])
}

/// The positions of a free step from the least height, which keeps all of the time.
pub fn low_step() -> Option<Vec<Point>> {
    let (mesh, [x0, x1]) = low();
    let options = FreeStepOptions::default().with_keep(1.0);
    let step = Detector::new(mesh).free_step(&x0, &x1, &options).ok()?;
    Some(step.positions)
}

/// Returns true if the step to these positions is free.
pub fn is_free(positions: &[Point]) -> bool {
    let (mesh, [x0, _]) = low();
    Detector::new(mesh).collides(&x0, positions, CONTACT) == Ok(false)
}
