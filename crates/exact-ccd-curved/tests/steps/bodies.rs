//! Rigid bodies whose times of contact are known, and bodies that never meet.

use exact_ccd::Point;
use exact_ccd_curved::{End, Instance, Instances, Pose, Proximity};
use exact_ccd_mesh::{Frame, Pair};

use crate::step;

/// A box between two corners.
fn cuboid(lower: Point, upper: Point) -> Frame {
    let corners = (0..8).map(|i| [0, 1, 2].map(|k: usize| if i >> k & 1 == 0 { lower[k] } else { upper[k] }));
    let quads = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let faces = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    Frame::new(corners.collect(), faces.collect()).unwrap()
}

/// A pose turned about the z axis.
fn turned(angle: f64, origin: Point) -> Pose {
    Pose {
        origin,
        rotation: [(angle / 2.0).cos(), 0.0, 0.0, (angle / 2.0).sin()],
    }
}

/// A bar that turns about its end by the angle, and a blade whose edge is the line x = 0, y = 1.
fn bar_and_blade(angle: f64) -> Instances {
    let bar = cuboid([0.0, -0.125, -0.125], [2.0, 0.125, 0.125]);
    let blade = Frame::new(
        vec![[0.0, 1.0, -0.5], [0.0, 1.0, 0.5], [-1.0, 1.5, 0.0]],
        vec![[0, 1, 2]],
    )
    .unwrap();
    let rest = Pose::at([0.0; 3]);
    Instances::new(&[
        Instance {
            frame: &bar,
            start: rest,
            end: turned(angle, [0.0; 3]),
        },
        Instance {
            frame: &blade,
            start: rest,
            end: rest,
        },
    ])
    .unwrap()
}

#[test]
fn a_bar_that_turns_meets_a_blade() {
    // In the coordinates of the bar, the line is at y = cos φ.
    let time = 0.125_f64.acos() / 2.0;
    for tolerance in [1e-3, 1e-6, 1e-12] {
        let step = step(&bar_and_blade(2.0), 0.0, tolerance);
        let reached = step.answer.within.unwrap();
        assert_eq!(
            (step.answer.end, reached.proximity),
            (End::Tolerance, Proximity::Contact)
        );
        assert!(
            step.answer.free_until <= time + 1e-15 && time - 1e-15 <= reached.by,
            "{step:?}"
        );
        assert!(reached.by - step.answer.free_until <= tolerance);
        assert!(matches!(step.pair, Some(Pair::EdgeEdge { .. })));
    }
    // The same at a distance of 1/8 more.
    let step = step(&bar_and_blade(2.0), 0.125, 1e-12);
    let time = 0.25_f64.acos() / 2.0;
    assert!((step.answer.free_until - time).abs() < 1e-12, "{step:?}");
}

#[test]
fn a_bar_that_stops_short_is_free() {
    let step = step(&bar_and_blade(1.4), 0.0, 1e-9);
    assert!(step.answer.is_free() && step.pair.is_none() && step.answer.free_until == 1.0);
    assert!(step.candidates > 0);
}

#[test]
fn pairs_of_one_body_are_left_out() {
    let bar = cuboid([0.0; 3], [2.0, 0.125, 0.125]);
    let (start, end) = (Pose::at([0.0; 3]), turned(3.0, [5.0, 1.0, 0.0]));
    let instances = Instances::new(&[Instance {
        frame: &bar,
        start,
        end,
    }])
    .unwrap();
    let step = step(&instances, 0.0, 1e-9);
    assert_eq!((step.answer.end, step.candidates), (End::Free, 0));
}

#[test]
fn a_motion_ends_at_its_pose() {
    let bar = cuboid([-1.0; 3], [2.0, 0.5, 0.25]);
    let mut random = fastrand::Rng::with_seed(4);
    for _ in 0..1_000 {
        let mut pose = || Pose {
            origin: [0; 3].map(|_| random.f64()),
            rotation: [0; 4].map(|_| random.f64() - 0.5),
        };
        let (start, end) = (pose(), pose());
        let instances = Instances::new(&[Instance {
            frame: &bar,
            start,
            end,
        }])
        .unwrap();
        for (trajectory, &vertex) in instances.trajectories.iter().zip(&bar.positions) {
            for (time, pose) in [(0.0, start), (1.0, end)] {
                let actual = exact_ccd_curved::Trajectory::at(trajectory, time).point;
                let place = pose.place(vertex);
                assert!(
                    (0..3).all(|k| (actual[k] - place[k]).abs() < 1e-13),
                    "{actual:?} {place:?}"
                );
            }
        }
    }
}
