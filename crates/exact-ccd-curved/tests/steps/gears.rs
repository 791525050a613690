//! Two gears that turn, against their intersections at many times.

use std::f64::consts::{PI, TAU};

use exact_ccd::Point;
use exact_ccd_curved::{
    CurvedStep, CurvedStepOptions, End, Instances, RigidMotion, SearchOptions, Trajectory, curved_step,
};
use exact_ccd_mesh::{Bvh, Frame, IntersectionOptions, IntersectionsError, TriangleMesh, intersections};
use rayon::ThreadPoolBuilder;

use crate::within;

const TEETH: usize = 12;

/// A gear about the z axis: a prism over a star, with a phase in teeth.
fn gear(phase: f64, height: f64) -> Frame {
    let corner = |i: usize, z: f64| {
        let angle = TAU * (0.5 * i as f64 + phase) / TEETH as f64;
        let radius = if i.is_multiple_of(2) { 1.25 } else { 1.0 };
        [radius * angle.cos(), radius * angle.sin(), z]
    };
    let count = 2 * TEETH;
    let mut positions: Vec<Point> = [-height, height]
        .iter()
        .flat_map(|&z| (0..count).map(move |i| corner(i, z)))
        .collect();
    positions.extend([[0.0, 0.0, -height], [0.0, 0.0, height]]);
    let faces = (0..count).flat_map(|i| {
        let j = (i + 1) % count;
        let [a, b, c, d] = [i, j, i + count, j + count].map(|v| v as u32);
        let n = count as u32;
        [[a, b, d], [a, d, c], [b, a, 2 * n], [c, d, 2 * n + 1]]
    });
    Frame::new(positions, faces.collect()).unwrap()
}

/// Two gears, at x = 0 and x = 2.3, whose second turns `ratio` times as fast as the first.
struct Gears {
    instances: Instances,
    angle: f64,
    ratio: f64,
}

const CENTERS: [Point; 2] = [[0.0; 3], [2.3, 0.0, 0.0]];

impl Gears {
    fn new(angle: f64, ratio: f64) -> Self {
        let (mut positions, mut faces, mut trajectories, mut bodies) = (vec![], vec![], vec![], vec![]);
        for (body, (center, angle)) in CENTERS.into_iter().zip([angle, -ratio * angle]).enumerate() {
            // A tooth of one between two of the other, which is thicker: the corners of teeth meet faces.
            let (phase, height) = [(0.0, 0.25), (0.5 + 0.5 * TEETH as f64, 0.5)][body];
            let gear = gear(phase, height);
            let motion = RigidMotion::new(center, [0.0, 0.0, 1.0], angle, [0.0; 3]).unwrap();
            let first = positions.len() as u32;
            faces.extend(gear.mesh.faces().iter().map(|face| face.map(|v| v + first)));
            for vertex in gear.positions {
                let start = [0, 1, 2].map(|k: usize| vertex[k] + center[k]);
                positions.push(start);
                trajectories.push(motion.point(start));
                bodies.push(body as u32);
            }
        }
        let mesh = TriangleMesh::new(positions.len(), faces).unwrap();
        Self {
            instances: Instances {
                mesh,
                trajectories,
                bodies,
            },
            angle,
            ratio,
        }
    }

    fn step(&self) -> CurvedStep {
        // The edges of teeth are parallel, and may meet face to face: contact that cannot be proved.
        let search = SearchOptions::default()
            .with_time_tolerance(1e-9)
            .with_distance_tolerance(within(1e-9));
        let options = CurvedStepOptions::default()
            .with_can_collide(self.instances.can_collide())
            .with_search(search);
        curved_step(
            &self.instances.mesh,
            &self.instances.trajectories,
            within(0.0),
            &options,
        )
        .unwrap()
    }

    /// Returns true if the gears intersect at a time, by rotation in f64.
    fn intersect_at(&self, time: f64) -> Result<bool, IntersectionsError> {
        let place = |(trajectory, &body): (&exact_ccd_curved::RigidPoint, &u32)| {
            let start = trajectory.at(0.0).point;
            let center = CENTERS[body as usize];
            let angle = if body == 0 {
                self.angle
            } else {
                -self.ratio * self.angle
            };
            let (sine, cosine) = (angle * time).sin_cos();
            let (x, y) = (start[0] - center[0], start[1] - center[1]);
            [
                center[0] + cosine * x - sine * y,
                center[1] + sine * x + cosine * y,
                start[2],
            ]
        };
        let positions: Vec<Point> = self
            .instances
            .trajectories
            .iter()
            .zip(&self.instances.bodies)
            .map(place)
            .collect();
        Ok(!intersections(
            &self.instances.mesh,
            &positions,
            &Bvh,
            &IntersectionOptions::default(),
        )?
        .is_empty())
    }
}

#[test]
fn gears_that_fit_are_free_for_a_whole_turn() {
    let gears = Gears::new(TAU, 1.0);
    for sample in 0..500 {
        assert!(
            !gears.intersect_at(f64::from(sample) / 500.0).unwrap(),
            "the gears of this test fit"
        );
    }
    let step = gears.step();
    assert_eq!(
        (step.answer.end, step.answer.free_until, step.pair),
        (End::Free, 1.0, None)
    );
    println!("{step:?}");
}

#[test]
fn gears_that_do_not_fit_are_free_until_they_meet() {
    for (ratio, angle) in [(1.25, TAU), (0.5, -PI), (3.0, 20.0 * PI)] {
        let gears = Gears::new(angle, ratio);
        let step = gears.step();
        println!("{step:?}");
        let reached = step.answer.within.unwrap();
        assert_eq!(step.answer.end, End::Tolerance);
        assert!(step.answer.free_until > 0.0 && reached.by - step.answer.free_until <= 1e-9);
        // The corners of teeth lie in the planes of others: samples keep away from the end.
        for sample in 0..500 {
            let time = (step.answer.free_until - 1e-9) * f64::from(sample) / 499.0;
            assert!(!gears.intersect_at(time).unwrap(), "{time} {step:?}");
        }
        let after = (0..200).map(|sample| reached.by + 1e-6 * f64::from(sample));
        assert!(
            after.into_iter().any(|time| gears.intersect_at(time).unwrap()),
            "{step:?}"
        );
    }
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let gears = Gears::new(TAU, 1.25);
    let [one, four] = [1, 4].map(|threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| gears.step())
    });
    assert_eq!(one, four);
}
