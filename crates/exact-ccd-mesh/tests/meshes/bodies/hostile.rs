//! Poses with the largest and the least numbers have the answers of all pairs in integers.

use exact_ccd::CONTACT;
use exact_ccd::motion::Pose;
use exact_ccd_mesh::{Bodies, Frame, Point};
use fastrand::Rng;

use super::all_contacts;

const NUMBERS: [f64; 8] = [0.0, -0.0, 1.0, 5e-324, -5e-324, 1.7e308, -1.7e308, 1e-160];

fn pose(random: &mut Rng) -> Pose {
    loop {
        let rotation = [(); 4].map(|()| NUMBERS[random.usize(..8)]);
        let place = [(); 3].map(|()| NUMBERS[random.usize(..8)]);
        if let Ok(pose) = Pose::new(rotation, place) {
            return pose;
        }
    }
}

fn tetrahedron(size: f64) -> Frame {
    let corners: [Point; 4] = [[0.0; 3], [size, 0.0, 0.0], [0.0, size, 0.0], [0.0, 0.0, size]];
    let faces = vec![[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
    Frame::new(corners.to_vec(), faces).unwrap()
}

/// The time that these take is bounded by the number of pairs: no pair is decided in many parts of the step.
#[test]
fn contacts_in_hostile_poses_are_those_of_all_pairs() {
    let mut random = Rng::with_seed(1);
    let mut decided = 0;
    for case in 0..6 {
        let frames = [1.0, [1.0, 1.7e308, 5e-324][case % 3]].map(tetrahedron);
        let bodies = Bodies::new(frames.clone()).unwrap();
        let [start, end] = [(); 2].map(|()| [(); 2].map(|()| pose(&mut random)));
        let Ok(motions) = bodies.motions(&start, &end) else {
            continue;
        };
        let expected = all_contacts(&frames, &motions, CONTACT);
        let found = bodies.collisions(&motions, CONTACT).unwrap();
        assert_eq!(found, expected, "{case}");
        decided += 1;
        let first = bodies.collision(&motions, CONTACT).unwrap();
        assert_eq!(first, expected.first().copied(), "{case}");
    }
    assert!(decided > 2, "{decided}");
}
