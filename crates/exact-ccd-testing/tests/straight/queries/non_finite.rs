//! The errors name the first coordinate that is not a finite number.

use exact_ccd::{Axis, EdgeEdge, NonFinite, Point, Query, VertexFace};

const BAD: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

fn errors(points: [[Point; 4]; 2]) -> [NonFinite; 2] {
    [
        Query::<VertexFace>::new(points[0], points[1]).unwrap_err(),
        Query::<EdgeEdge>::new(points[0], points[1]).unwrap_err(),
    ]
}

#[test]
fn every_coordinate_is_checked() {
    for time in 0..2 {
        for point in 0..4 {
            for &axis in Axis::ALL {
                for value in BAD {
                    let mut points = [[[1.0; 3]; 4]; 2];
                    points[time][point][axis.index()] = value;
                    for error in errors(points) {
                        assert_eq!((error.time, error.point, error.axis), (Some(time), point, axis));
                        assert_eq!(error.value.to_bits(), value.to_bits());
                        assert_eq!(
                            error.to_string(),
                            format!(
                                "coordinate {axis} of point {point} at t = {time} is {value}, \
                                 not a finite number"
                            )
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn the_first_coordinate_is_named() {
    let mut points = [[[f64::MAX; 3]; 4]; 2];
    points[1] = [[f64::NAN; 3]; 4];
    points[0][2][1] = f64::NEG_INFINITY;
    points[0][3][0] = f64::INFINITY;
    for error in errors(points) {
        let expected = NonFinite {
            time: Some(0),
            point: 2,
            axis: Axis::Y,
            value: f64::NEG_INFINITY,
        };
        assert_eq!(error, expected);
    }
}

#[test]
fn the_largest_and_the_smallest_numbers_are_accepted() {
    for value in [f64::MAX, f64::MIN, 5e-324, -0.0] {
        let points = [[value; 3]; 4];
        assert!(Query::<VertexFace>::new(points, points).is_ok());
        assert!(Query::<EdgeEdge>::new(points, points).is_ok());
    }
}
