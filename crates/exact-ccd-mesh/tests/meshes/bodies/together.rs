//! Bodies that move together.

use std::f64::consts::TAU;

use exact_ccd::CONTACT;
use exact_ccd::motion::{Chain, Pose, RigidMotion};
use exact_ccd_mesh::{Bodies, Frame};
use fastrand::Rng;

use super::{body, number, point};

/// The same outermost motion of each body changes no contact and no time.
#[test]
fn a_common_motion_changes_nothing() {
    let mut random = Rng::with_seed(6);
    let mut touching = 0;
    for case in 0..8 {
        let is_lattice = case % 2 == 0;
        let frames = [(); 2].map(|()| body(&mut random, is_lattice));
        let own = [(); 2].map(|()| {
            let quaternions = [(); 2].map(|()| [1.0, number(&mut random, false), 0.25, -0.5]);
            let places = [(); 2].map(|()| point(&mut random, is_lattice));
            RigidMotion::new(quaternions, &places).unwrap()
        });
        let places = [(); 3].map(|()| point(&mut random, is_lattice));
        let common = RigidMotion::new([[1.0, 0.5, 0.0, 0.25], [0.5, -0.25, 1.0, 0.0]], &places).unwrap();
        let bodies = Bodies::new(frames).unwrap();
        let alone: [Chain; 2] = own.clone().map(Chain::from);
        let together = own.map(|motion| Chain::new([common.clone(), motion]).unwrap());
        let [alone, together] = [alone, together].map(|motions| {
            let contacts = bodies.collisions(&motions, CONTACT).unwrap().into_iter();
            let keys = contacts.map(|contact| {
                (
                    contact.impact.time,
                    contact.kind,
                    contact.bodies,
                    contact.primitives,
                )
            });
            keys.collect::<Vec<_>>()
        });
        assert_eq!(alone, together, "{case}");
        touching += usize::from(!alone.is_empty());
    }
    assert!(touching >= 2, "{touching}");
}

/// A plane separates rings that turn together close to each other, and a turn about another axis makes
/// them touch.
#[test]
fn rings_that_turn_close_to_each_other_are_free() {
    let ring = || {
        let point = |i: u32, [radius, height]: [f64; 2]| {
            let (sin, cos) = (f64::from(i) * TAU / 24.0).sin_cos();
            [radius * cos, radius * sin, height]
        };
        let section = [[1.5, 0.0], [1.0, 0.5], [0.5, 0.0], [1.0, -0.5]];
        let positions = (0..24).flat_map(|i| section.map(|corner| point(i, corner)));
        let faces = (0..24).flat_map(|i| {
            (0..4).flat_map(move |j| {
                let at = |i: u32, j: u32| i % 24 * 4 + j % 4;
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
        });
        Frame::new(positions.collect(), faces.collect()).unwrap()
    };
    let bodies = Bodies::new([ring(), ring()]).unwrap();
    // The rings are 1 high, and 1/64 apart.
    let at = |rotation: [f64; 4], height: f64| Pose::new(rotation, [0.0, 0.0, height]).unwrap();
    let high = 1.0 + 1.0 / 64.0;
    let start = [[1.0, 0.0, 0.0, 0.0]; 2];
    let step = |ends: [[f64; 4]; 2]| {
        let [start, end] = [start, ends].map(|[one, other]| [at(one, 0.0), at(other, high)]);
        let motions = bodies.motions(&start, &end).unwrap();
        bodies.collision(&motions, CONTACT).unwrap()
    };
    let about_z = [1.0, 0.0, 0.0, 0.5];
    assert_eq!(step([about_z, about_z]), None);
    assert_eq!(step([about_z, [1.0, 0.0, 0.0, -0.25]]), None);
    let tilted = step([about_z, [1.0, 0.0625, 0.0, 0.5]]).unwrap();
    assert!(tilted.impact.time.lower() > 0.0);
}
