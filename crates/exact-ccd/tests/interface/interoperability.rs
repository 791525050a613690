//! Points of other libraries yield the same queries, and all public types can be sent to other threads.

use exact_ccd::batch::{self, Trajectories};
use exact_ccd::predicates::EdgeFace;
use exact_ccd::{
    Axis, Ccd, Collision, ContactTime, EdgeEdge, Exact, Guarantees, Impact, Interval, Intervals, NonFinite,
    Options, Point, Query, Stage, Thickness, TimeGuarantee, VertexFace,
};

const _: () = {
    const fn assert_send_and_sync<T: Send + Sync>() {}
    assert_send_and_sync::<(Query<VertexFace>, Query<EdgeEdge>, NonFinite, Axis, Stage)>();
    assert_send_and_sync::<(Collision<'_, VertexFace>, Collision<'_, EdgeEdge>)>();
    assert_send_and_sync::<(ContactTime, Interval, Intervals, Impact, Options, Thickness)>();
    assert_send_and_sync::<(Exact, Guarantees, TimeGuarantee, &dyn Ccd)>();
    assert_send_and_sync::<(Trajectories, batch::Instructions)>();
    assert_send_and_sync::<(
        batch::TrajectoriesError,
        batch::VertexOutOfRange,
        batch::NonFiniteQuery,
    )>();
    assert_send_and_sync::<EdgeFace>();
};

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
