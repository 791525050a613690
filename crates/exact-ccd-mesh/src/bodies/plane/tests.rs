//! Separating planes against rational arithmetic, and the bound of their round-off against the count of
//! their roundings.

mod counted;
mod rational;

use exact_ccd::motion::{Chain, RigidMotion};
use exact_ccd::{Options, Point, Separation};
use fastrand::Rng;

use super::super::Bodies;
use super::super::encounter::Encounter;
use super::super::part::Part;
use super::super::placed::turned_back;
use super::super::scene::Scene;
use super::super::world::World;
use super::{ROUNDOFF, gap};
use crate::mesh::Frame;
use crate::vector::product;
use counted::Counted;
use rational::{Rational, exactly};

fn point(random: &mut Rng, size: f64) -> Point {
    [(); 3].map(|()| size * (2.0 * random.f64() - 1.0))
}

/// A motion that turns little or much, at a place that is near or far away.
fn motion(random: &mut Rng, place: Point) -> RigidMotion {
    loop {
        let start = [(); 4].map(|()| 2.0 * random.f64() - 1.0);
        let turn = [1.0, 1e-3, 1e-9][random.usize(..3)];
        let end = start.map(|x| x + turn * (2.0 * random.f64() - 1.0));
        let degree = random.usize(1..=3);
        let size = [1.0, 1e-6][random.usize(..2)];
        let step = point(random, size);
        let places: Vec<Point> = (0..=degree)
            .map(|k| [0, 1, 2].map(|axis: usize| place[axis] + k as f64 * step[axis]))
            .collect();
        if let Ok(motion) = RigidMotion::new([start, end], &places) {
            return motion;
        }
    }
}

/// A part of the step, of any length.
fn part(random: &mut Rng) -> Part {
    (0..random.u32(..12)).fold(Part::WHOLE, |part, _| {
        part.halves().map_or(part, |halves| halves[random.usize(..2)])
    })
}

/// Two bodies of a few points.
struct Case {
    bodies: Bodies,
    motions: [Chain; 2],
    part: Part,
    d: f64,
}

impl Case {
    /// Bodies with their origins `apart` from each other.
    fn new(random: &mut Rng, direction: Point, apart: f64, offset: f64) -> Self {
        let frames = [(); 2].map(|()| {
            let count = random.usize(1..12);
            let positions = (0..count).map(|_| point(random, 1.0)).collect();
            Frame::new(positions, Vec::new()).expect("finite points")
        });
        let places = [offset, offset + apart].map(|x| direction.map(|n| x * n));
        Self {
            bodies: Bodies::new(frames).expect("finite points"),
            motions: places.map(|place| motion(random, place).into()),
            part: part(random),
            d: [0.0, 0.25][random.usize(..2)],
        }
    }

    /// The direction of planes that separate both bodies, and the scene.
    fn separated(&self) -> Option<(Point, Scene)> {
        let options = Options::within(Separation::new(self.d).expect("a distance"));
        let world = World::new(&self.bodies, &self.motions, options);
        let encounter = Encounter::new([0, 1], &world, &self.motions);
        let scene = encounter.scene(self.part);
        let direction = encounter.separating_direction(&scene, [0, 0])?;
        Some((direction, scene))
    }

    /// The exact gap between both bodies along a direction, at a time.
    fn gap(&self, direction: Point, time: f64) -> Rational {
        let along = |body: usize| {
            let positions = &self.bodies.bodies[body].frame.positions;
            let motion = &self.motions[body].motions()[0];
            let places = positions.iter().map(move |&v| rational::place(motion, v, time));
            places.map(move |place| rational::product(&direction.map(exactly), &place))
        };
        let first = along(0).max().expect("there are points");
        along(1).min().expect("there are points") - first
    }

    /// Returns true if planes separate both bodies, and if they certainly do: at the ends of the part, the
    /// gap is greater than the distance and the deviation, and in between, greater than the distance.
    fn assert_separated(&self) -> bool {
        let Some((direction, scene)) = self.separated() else {
            return false;
        };
        let length = rational::product(&direction.map(exactly), &direction.map(exactly));
        let is_beyond = |time: f64, least: f64| {
            let gap = self.gap(direction, time);
            gap > Rational::ZERO && &gap * &gap > exactly(least) * exactly(least) * &length
        };
        let Part { start, end, .. } = scene.part;
        for time in [start, end] {
            assert!(is_beyond(time, self.d + scene.deviation), "{direction:?} {time}");
        }
        for k in 1..8 {
            let time = start + (end - start) * f64::from(k) / 8.0;
            assert!(is_beyond(time, self.d), "{direction:?} {time}");
        }
        true
    }
}

/// The nearest bodies that are separated are found by bisection: their gap is as small as it can be.
#[test]
fn planes_separate_bodies_in_rational_arithmetic() {
    let mut random = Rng::with_seed(1);
    let mut separated = 0;
    for _ in 0..60 {
        let direction = [[1.0, 0.0, 0.0], [0.6, 0.0, 0.8]][random.usize(..2)];
        // Far from the origin, places have large errors.
        let offset = [0.0, 1e3, 1e9, 1e300][random.usize(..4)];
        let seed = random.u64(..);
        let case = |apart: f64| Case::new(&mut Rng::with_seed(seed), direction, apart, offset);
        let mut near = 0.0;
        let mut far = 16.0 + 1e-9 * offset;
        if !case(far).assert_separated() {
            continue;
        }
        separated += 1;
        for _ in 0..40 {
            let middle = 0.5 * (near + far);
            if case(middle).separated().is_some() {
                far = middle;
            } else {
                near = middle;
            }
        }
        assert!(case(far).assert_separated());
    }
    assert!(separated > 30, "{separated}");
}

/// The count of the round-off of a gap, in units of the sum of the largest distances from the origin, which
/// are 1. All points are given exactly, or computed with errors that are bounded elsewhere.
fn count(random: &mut Rng) -> f64 {
    // The magnitudes of this rotation have the norm 5/3. No rotation has more than √3.
    let third = 1.0 / 3.0;
    let turn = [[2.0, -1.0, 2.0], [2.0, 2.0, -1.0], [-1.0, 2.0, 2.0]];
    let turn = turn.map(|row| row.map(|x| Counted::exactly(third * x)));
    let sign = |random: &mut Rng| if random.bool() { 1.0 } else { -1.0 };
    let direction = [(); 3].map(|()| Counted::exactly(sign(random) / f64::sqrt(3.0)));
    let back = turned_back(turn, direction);
    let vertex = back.map(|x| Counted::exactly(x.value.signum() / f64::sqrt(3.0)));
    let along = product(back, vertex);
    let place = direction.map(|x| Counted::exactly(x.value));
    let gap = gap(direction, place.map(|x| Counted::exactly(-x.value)), place);
    // Two bodies: each with two errors of places along the direction.
    (4.0 * along.error() + gap.error()) / 2.0
}

/// Half of the bound would be refused.
#[test]
fn the_bound_of_the_round_off_is_the_count_of_roundings() {
    let mut random = Rng::with_seed(2);
    let counts = (0..100).map(|_| count(&mut random));
    let most = counts.fold(0.0, f64::max);
    assert!(most <= ROUNDOFF, "{most:e}");
    assert!(most > 0.5 * ROUNDOFF, "{most:e}");
}

/// The exact gap differs from the computed one by at most its count, on places that nearly cancel too.
#[test]
fn gaps_have_the_counted_errors() {
    let mut random = Rng::with_seed(3);
    for case in 0..10_000 {
        let direction = point(&mut random, 1.0);
        let first = point(&mut random, 1.0);
        let second = if case % 2 == 0 {
            point(&mut random, 1.0)
        } else {
            [0, 1, 2].map(|axis: usize| first[axis] + 1e-12 * (random.f64() - 0.5))
        };
        let counted = gap(
            direction.map(Counted::exactly),
            first.map(Counted::exactly),
            second.map(Counted::exactly),
        );
        let [first, second] = [first, second].map(|p| p.map(exactly));
        let difference = [0, 1, 2].map(|axis: usize| &second[axis] - &first[axis]);
        let error = rational::product(&direction.map(exactly), &difference) - exactly(counted.value);
        let bound = exactly(counted.error());
        assert!(error <= bound && -error <= bound, "{direction:?}");
    }
}
