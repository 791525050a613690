//! Motions that are refused.

use exact_ccd::motion::{Bezier, Chain, InvalidMotion, Pose, RigidMotion};
use exact_ccd::{Axis, VertexVertex};

const PLACES: [[f64; 3]; 2] = [[0.0; 3]; 2];

#[test]
fn a_quaternion_is_finite_and_not_zero() {
    let one = [1.0, 0.0, 0.0, 0.0];
    for value in [f64::NAN, f64::INFINITY] {
        let error = RigidMotion::new([one, [0.0, value, 0.0, 0.0]], &PLACES);
        let error = error.expect_err("it is not finite");
        assert!(
            matches!(
                error,
                InvalidMotion::Quaternion {
                    time: Some(1),
                    component: 1,
                    ..
                }
            ),
            "{error}"
        );
    }
    let zero = RigidMotion::new([[-0.0; 4], one], &PLACES);
    assert_eq!(zero, Err(InvalidMotion::Zero { time: Some(0) }));
    assert_eq!(
        Pose::new([0.0; 4], [0.0; 3]),
        Err(InvalidMotion::Zero { time: None })
    );
    let subnormal = [f64::from_bits(1), 0.0, 0.0, 0.0];
    assert!(RigidMotion::new([subnormal, one], &PLACES).is_ok());
}

#[test]
fn a_quaternion_that_vanishes_in_the_step_is_refused() {
    let quaternion = [1.0, -2.0, 3.0, 0.5];
    for factor in [1.0, 0.25, 1e300] {
        let opposite = quaternion.map(|x| -factor * x);
        let motion = RigidMotion::new([quaternion, opposite], &PLACES);
        assert_eq!(motion, Err(InvalidMotion::Vanishes), "{factor}");
        let beside = [opposite[0].next_up(), opposite[1], opposite[2], opposite[3]];
        assert!(RigidMotion::new([quaternion, beside], &PLACES).is_ok());
    }
}

#[test]
fn the_nearer_turn_is_the_one_with_a_positive_product() {
    let pose = |rotation| Pose::new(rotation, [0.0; 3]).expect("a rotation");
    let start = pose([1.0, 0.0, 0.0, 0.0]);
    let far = pose([-1.0, 0.0, 0.0, 0.5]);
    let near = far.nearer_turn(&start);
    assert_eq!(near.rotation(), [1.0, -0.0, -0.0, -0.5]);
    assert_eq!(near.nearer_turn(&start), near);
    let half = pose([0.0, 1.0, 0.0, 0.0]);
    assert_eq!(half.nearer_turn(&start), half);
    // 1e300 · 1e300 is no f64; the product of the others is larger still.
    let [one, other] = [[1e300, 1e300, 0.0, 0.0], [1e300, -1.1e300, 0.0, 0.0]].map(pose);
    assert_eq!(other.nearer_turn(&one).rotation()[0], -1e300);
}

#[test]
fn degrees_and_lengths_are_bounded() {
    let quaternions = [[1.0, 0.0, 0.0, 0.0]; 2];
    for count in [0, 1, 5] {
        let motion = RigidMotion::new(quaternions, &vec![[0.0; 3]; count]);
        assert_eq!(motion, Err(InvalidMotion::Degree { count, most: 4 }));
    }
    for count in [0, 1, 10] {
        let motion = Bezier::<VertexVertex>::new(&vec![[[0.0; 3]; 2]; count]);
        assert_eq!(motion, Err(InvalidMotion::Degree { count, most: 9 }));
    }
    let motion = RigidMotion::new(quaternions, &PLACES).expect("a motion");
    let chain = Chain::new(vec![motion; 9]);
    assert_eq!(chain, Err(InvalidMotion::Length { count: 9, most: 8 }));
}

#[test]
fn control_points_are_finite() {
    let control = [[[0.0; 3]; 2], [[0.0; 3], [0.0, f64::INFINITY, 0.0]]];
    let expected = InvalidMotion::ControlPoint {
        control: 1,
        point: 1,
        axis: Axis::Y,
        value: f64::INFINITY,
    };
    assert_eq!(Bezier::<VertexVertex>::new(&control), Err(expected));
    let message = "coordinate y of point 1 of control set 1 is inf, not a finite number";
    assert_eq!(expected.to_string(), message);
}
