//! In a mesh shifted as a whole, differences of coordinates are exact.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use exact_ccd::Axis;
use exact_ccd::parity::{Displacement, Rounded, RoundingError};
use exact_ccd_mesh::{Aabb, Frame, Motion, Point, TriangleMesh};
use proptest::prelude::*;

/// The number of vertices: those of two triangles, and a loose one.
const VERTICES: usize = 7;

fn motion(x0: Vec<Point>, x1: Vec<Point>) -> Motion {
    let mesh = TriangleMesh::new(VERTICES, vec![[0, 1, 2], [3, 4, 5]]).unwrap();
    Motion { mesh, x0, x1 }
}

/// Coordinates of either sign and of very different magnitudes, including zero.
fn coordinate() -> impl Strategy<Value = f64> {
    let scaled = |(mantissa, exponent)| mantissa * 2f64.powi(exponent);
    prop_oneof![4 => (-1.0..1.0, -40..40).prop_map(scaled), 1 => Just(0.0)]
}

fn positions() -> impl Strategy<Value = Vec<Point>> {
    prop::collection::vec(prop::array::uniform3(coordinate()), VERTICES)
}

prop_compose! {
    fn motions()(x0 in positions(), x1 in positions()) -> Motion {
        motion(x0, x1)
    }
}

fn frames(motion: &Motion) -> [Frame; 2] {
    [&motion.x0, &motion.x1].map(|x| Frame::new(x.clone(), motion.mesh.faces().to_vec()).unwrap())
}

proptest! {
    #[test]
    fn every_query_of_a_shifted_motion_is_rounded(motion in motions()) {
        let shifted = motion.shifted(motion.displacement()).unwrap();
        let step = shifted.step().unwrap();
        for vertex in 0..VERTICES as u32 {
            for face in 0..2 {
                prop_assert!(Rounded::check(step.vertex_face(vertex, face).unwrap()).is_ok());
            }
        }
        for a in 0..6 {
            for b in 0..6 {
                prop_assert!(Rounded::check(step.edge_edge(a, b).unwrap()).is_ok());
            }
        }
    }

    #[test]
    fn a_shifted_motion_needs_no_shift(motion in motions()) {
        let shifted = motion.shifted(motion.displacement()).unwrap();
        prop_assert_eq!(shifted.displacement(), Displacement::default());
        prop_assert_eq!(&shifted.shifted(shifted.displacement()).unwrap(), &shifted);
    }

    #[test]
    fn each_vertex_is_shifted_at_both_times_and_the_mesh_stays(motion in motions()) {
        let displacement = motion.displacement();
        let shifted = motion.shifted(displacement).unwrap();
        let apply = |x: &[Point]| x.iter().map(|&point| displacement.apply(point)).collect::<Vec<_>>();
        prop_assert_eq!(&shifted.x0, &apply(&motion.x0));
        prop_assert_eq!(&shifted.x1, &apply(&motion.x1));
        prop_assert_eq!(shifted.mesh, motion.mesh);
    }

    #[test]
    fn two_frames_are_shifted_as_their_motion(motion in motions()) {
        let [start, end] = frames(&motion);
        let displacement = start.bounds().union(&end.bounds()).displacement();
        prop_assert_eq!(displacement, motion.displacement());
        let frames = [&start, &end].map(|frame| frame.shifted(displacement).unwrap());
        let [start, end] = frames;
        prop_assert_eq!(Motion::new(start, end).unwrap(), motion.shifted(displacement).unwrap());
    }
}

#[test]
fn an_axis_with_close_coordinates_is_not_shifted() {
    let at = |x, y, z| vec![[x, y, z]; VERTICES];
    let motion = motion(at(0.1, -3.0, 0.0), at(0.2, -1.5, 1.0));
    assert_eq!(motion.displacement().along_axes(), [0.0, 0.0, 1.0]);
}

#[test]
fn an_empty_mesh_needs_no_shift() {
    let mesh = TriangleMesh::new(0, vec![]).unwrap();
    let (x0, x1) = (vec![], vec![]);
    let motion = Motion { mesh, x0, x1 };
    assert_eq!(Aabb::EMPTY.displacement(), Displacement::default());
    assert_eq!(motion.displacement(), Displacement::default());
    assert_eq!(motion.shifted(motion.displacement()).unwrap(), motion);
}

#[test]
fn a_shift_out_of_range_is_an_error_that_names_the_axis() {
    for axis in 0..3 {
        let mut far = [0.0, 1.0, 3.0];
        far[axis] = -1e308;
        let mut x1 = vec![[1.0; 3]; VERTICES];
        x1[6] = far;
        let motion = motion(vec![[1.0; 3]; VERTICES], x1);
        let expected = RoundingError::OutOfRange {
            axis: Axis::ALL[axis],
        };
        assert_eq!(motion.shifted(motion.displacement()), Err(expected));
        let [_, end] = frames(&motion);
        assert_eq!(end.shifted(end.bounds().displacement()), Err(expected));
    }
}
