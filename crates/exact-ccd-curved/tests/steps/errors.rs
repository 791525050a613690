//! Errors name the body, the vertex or the pair.

use exact_ccd_curved::{
    CurvedStepError, CurvedStepOptions, FromFunctions, Instance, InstanceError, Instances, Polynomial, Pose,
    Position, SearchError, SearchOptions, Trajectory as _, curved_step,
};
use exact_ccd_mesh::{Frame, TriangleMesh};

use crate::within;

fn triangle() -> Frame {
    Frame::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2]]).unwrap()
}

#[test]
fn a_pose_that_is_not_finite_names_its_body() {
    let (frame, rest) = (triangle(), Pose::at([0.0; 3]));
    let good = Instance {
        frame: &frame,
        start: rest,
        end: rest,
    };
    let bad = Instance {
        end: Pose::at([0.0, f64::NAN, 0.0]),
        ..good
    };
    let error = Instances::new(&[good, bad]).unwrap_err();
    assert!(matches!(error, InstanceError::Motion { body: 1, .. }), "{error}");
    assert_eq!(
        error.to_string(),
        "body 1: the displacement of a rigid motion has the value NaN, expected a finite number"
    );
    for x in [0.0, f64::INFINITY, f64::NAN] {
        let rotation = [0.0, x, 0.0, 0.0];
        let bad = Instance {
            start: Pose { rotation, ..rest },
            ..good
        };
        let error = Instances::new(&[good, bad]).unwrap_err();
        assert_eq!(
            error.to_string(),
            format!(
                "body 1: the rotation is the quaternion {rotation:?}, expected one that is finite and not zero"
            )
        );
    }
}

#[test]
fn positions_that_do_not_fit_a_mesh_name_the_body() {
    let (frame, rest) = (triangle(), Pose::at([0.0; 3]));
    let mut short = frame.clone();
    short.positions.pop();
    let body = |frame| Instance {
        frame,
        start: rest,
        end: rest,
    };
    let error = Instances::new(&[body(&short), body(&frame)]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "body 0: 2 positions, expected one for each of 3 vertices"
    );
}

#[test]
fn the_length_of_a_quaternion_does_not_matter() {
    let pose = |length: f64, [w, z]: [f64; 2]| Pose {
        origin: [0.5, 0.0, 1.0],
        rotation: [length * w, 0.0, 0.0, length * z],
    };
    let [start, end] = [[1.0, 0.0], [0.0, 1.0]];
    let expected = pose(1.0, start).motion_to(&pose(1.0, end));
    for length in [5e-324, 1e-170, 1e-140, 1e200, f64::MAX] {
        assert_eq!(pose(length, start).motion_to(&pose(length, end)), expected);
        assert_eq!(
            pose(length, end).place([1.0, 2.0, 3.0]),
            pose(1.0, end).place([1.0, 2.0, 3.0])
        );
    }
    let half_turn = expected.unwrap().point([1.5, 0.0, 0.0]);
    assert!((half_turn.at(1.0).point[0] + 0.5).abs() < 1e-15);
}

#[test]
fn trajectories_have_to_fit_the_mesh() {
    let mesh = TriangleMesh::new(3, vec![[0, 1, 2]]).unwrap();
    let trajectories = [Polynomial::new([[0.0; 3]]); 2];
    let error = curved_step(&mesh, &trajectories, within(0.0), &CurvedStepOptions::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "for the times from 0 to 1: at the start, 2 positions, expected one for each of 3 vertices"
    );
}

#[test]
fn a_bound_that_is_not_valid_names_its_vertex() {
    let mesh = TriangleMesh::new(3, vec![[0, 1, 2]]).unwrap();
    let trajectories = [0.0, 0.0, -1.0].map(|deviation| FromFunctions {
        position: |_| Position::exactly([0.0; 3]),
        deviation: move |_, _| deviation,
    });
    let step = |options| curved_step(&mesh, &trajectories, within(0.0), &options);
    let error = step(CurvedStepOptions::default()).unwrap_err();
    assert_eq!(
        error,
        CurvedStepError::Search(SearchError::Bound {
            point: 2,
            start: 0.0,
            end: 1.0
        })
    );
    let bad = CurvedStepOptions::default().with_search(SearchOptions::default().with_time_tolerance(-1.0));
    assert_eq!(
        step(bad),
        Err(CurvedStepError::Search(SearchError::Tolerance(-1.0)))
    );
}
