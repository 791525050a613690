//! Random motions against the distance at many times.

use exact_ccd::{CONTACT, EdgeEdge, Point, Query, Separation, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_curved::{Answer, CurvedKind, End, RigidMotion, SearchOptions, time_of_impact};

use crate::{points, within};

/// A body that turns about an axis, by its matrix (Rodrigues 1840).
struct Body {
    center: Point,
    axis: Point,
    angle: f64,
    displacement: Point,
}

impl Body {
    fn random(random: &mut fastrand::Rng, turns: f64) -> Self {
        let vector = |random: &mut fastrand::Rng, size: f64| [0; 3].map(|_| size * (random.f64() - 0.5));
        let axis = vector(random, 1.0);
        let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        Self {
            center: vector(random, 2.0),
            axis: axis.map(|x| x / length),
            angle: (random.f64() - 0.5) * 2.0 * turns * std::f64::consts::TAU,
            displacement: vector(random, 3.0),
        }
    }

    fn motion(&self) -> RigidMotion {
        RigidMotion::new(self.center, self.axis, self.angle, self.displacement).unwrap()
    }

    fn place(&self, point: Point, time: f64) -> Point {
        let (sine, cosine) = (self.angle * time).sin_cos();
        let [x, y, z] = self.axis;
        let skew = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
        let arm = [0, 1, 2].map(|k: usize| point[k] - self.center[k]);
        [0, 1, 2].map(|row: usize| {
            let turned = (0..3).map(|k| {
                let unit = if row == k { cosine } else { 0.0 };
                (unit + sine * skew[row][k] + (1.0 - cosine) * self.axis[row] * self.axis[k]) * arm[k]
            });
            self.center[row] + turned.sum::<f64>() + time * self.displacement[row]
        })
    }
}

/// Above the errors of positions in this file, whose coordinates are below 10 and angles below 100.
const ROUNDING: f64 = 1e-11;

const SAMPLES: usize = 10_000;

/// Distances are certain up to this, and times.
const TOLERANCE: f64 = 1e-7;

/// Searches `count` pairs of primitives, of bodies that turn up to 8 times.
fn agrees_with_samples<K: CurvedKind>(
    count: usize,
    seed: u64,
    search: impl Fn(&K::Points, &dyn Fn(usize) -> RigidMotion, Separation, &SearchOptions) -> Answer,
) {
    let mut random = fastrand::Rng::with_seed(seed);
    let (mut near, mut free, mut touchable) = (0, 0, 0);
    for case in 0..count {
        let turns = [0.01, 0.3, 8.0][case % 3];
        let bodies = [0; 2].map(|_| Body::random(&mut random, turns));
        let corners = points::<K>(|_| [0; 3].map(|_| 3.0 * (random.f64() - 0.5)));
        let body = |point: usize| &bodies[usize::from(point >= K::FIRST)];
        let d = [0.0, 0.1, 0.8][random.usize(0..3)];
        let options = SearchOptions::default()
            .with_time_tolerance(TOLERANCE)
            .with_distance_tolerance(within(TOLERANCE))
            .with_chord_limit(100_000);
        let answer = search(&corners, &|point| body(point).motion(), within(d), &options);

        let is_within = |time: f64, d: f64| {
            let places = points::<K>(|point| body(point).place(corners.as_ref()[point], time));
            Query::<K>::new(places, places).unwrap().collides(within(d))
        };
        if d > ROUNDING && answer.free_until > 0.0 {
            // Before the end of the certain part, no sample is within d by more than rounding.
            for _ in 0..SAMPLES {
                let time = random.f64() * answer.free_until;
                assert!(!is_within(time, d - ROUNDING), "{time} {answer:?}");
            }
        } else {
            // Primitives that pass through each other between two samples do so on the chords too. Where the
            // certain part ends with a contact, the last chord is left out.
            let place = |sample: usize| {
                let time = answer.free_until * sample as f64 / SAMPLES as f64;
                points::<K>(|point| body(point).place(corners.as_ref()[point], time))
            };
            let last = if answer.is_free() { SAMPLES } else { SAMPLES - 1 };
            for sample in 0..last {
                let [start, end] = [sample, sample + 1].map(place);
                let collides = Query::<K>::new(start, end).unwrap().collides(CONTACT);
                assert!(!collides || answer.free_until == 0.0, "{sample} {answer:?}");
            }
            if answer.free_until > 0.0 {
                touchable += 1;
            }
        }
        if answer.is_free() {
            free += 1;
            assert_eq!((answer.free_until, answer.within), (1.0, None));
            continue;
        }
        near += 1;
        assert_eq!(answer.end, End::Tolerance);
        let reached = answer.within.unwrap();
        assert!(answer.free_until <= reached.by && reached.by - answer.free_until <= TOLERANCE);
        // Points are slower than 300, so that the distance changes by less than that in the bracket.
        assert!(
            is_within(reached.by, d + TOLERANCE + 300.0 * TOLERANCE),
            "{answer:?}"
        );
    }
    assert!(
        near > 4 && free > count / 10 && touchable > count / 10,
        "{near} {free} {touchable}"
    );
}

macro_rules! samples_of {
    ($name:ident, $kind:ty, $count:literal) => {
        #[test]
        fn $name() {
            agrees_with_samples::<$kind>($count, 11, |points, motion, d, options| {
                let trajectories = std::array::from_fn(|point| motion(point).point(points[point]));
                time_of_impact::<$kind, _>(&trajectories, d, options).unwrap()
            });
        }
    };
}

samples_of!(a_vertex_and_a_face, VertexFace, 120);
samples_of!(two_edges, EdgeEdge, 120);
samples_of!(a_vertex_and_an_edge, VertexEdge, 120);
samples_of!(two_vertices, VertexVertex, 120);
