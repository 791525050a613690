//! Points of other libraries yield the same queries.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use exact_ccd::{EdgeEdge, Point, Query};

const START: [Point; 4] = [
    [0.0, 0.0, 1.0],
    [1.0, 0.0, 1.0],
    [0.5, -1.0, 0.0],
    [0.5, 1.0, 0.0],
];
const END: [Point; 4] = [
    [0.0, 0.0, -1.0],
    [1.0, 0.0, -1.0],
    [0.5, -1.0, 0.0],
    [0.5, 1.0, 0.0],
];

fn assert_same<P: Into<Point>>(convert: fn(Point) -> P) {
    let query = Query::<EdgeEdge>::from_points(START.map(convert), END.map(convert)).unwrap();
    assert_eq!(query, Query::<EdgeEdge>::new(START, END).unwrap());
}

#[test]
fn points_convert() {
    assert_same(glam::DVec3::from);
    assert_same(nalgebra::Point3::from);
    assert_same(nalgebra::Vector3::from);
    assert_same(mint::Point3::from);
    assert_same(mint::Vector3::from);
}
