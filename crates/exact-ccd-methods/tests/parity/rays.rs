//! Corners of F on the first rays (1, k, k²), k = 0, 1, 2, …, or such that these rays meet edges or
//! lie in planes of faces.

use exact_ccd::{EdgeEdge, Point, VertexFace};
use exact_ccd_methods::parity::Rounded;
use proptest::array::{uniform2, uniform3};
use proptest::prelude::*;

use exact_ccd_testing::kinds::query;
use exact_ccd_testing::parity::Rim;
use exact_ccd_testing::parity::laws::assert_defined;
use exact_ccd_testing::primitives::combine;
use exact_ccd_testing::runner::for_all;

/// A corner on one of the rays, opposite of one, or in the plane of two.
fn corner() -> impl Strategy<Value = Point> {
    let ray = (0..6i8).prop_map(|k| [1, k, k * k].map(f64::from));
    ([-1..=2i8, -1..=2i8], uniform2(ray)).prop_map(|(factors, rays)| combine(factors.map(f64::from), rays))
}

/// Queries made from the first three corners at t = 0 and at t = 1.
fn are_defined<K: Rim>(points_of: impl Fn([Point; 3]) -> [Point; 4]) {
    for_all(20_000, uniform2(uniform3(corner())), |corners| {
        assert_defined(&Rounded::check(query::<K>(&corners.map(&points_of))).unwrap());
    });
}

#[test]
fn that_meet_the_prism_of_a_vertex_and_a_face() {
    are_defined::<VertexFace>(|[a, b, c]| {
        let opposite = |point: Point| point.map(|x| -x);
        [[0.0; 3], opposite(a), opposite(b), opposite(c)]
    });
}

#[test]
fn that_meet_the_hexahedron_of_edges() {
    are_defined::<EdgeEdge>(|[a, b, c]| [a, b, [0.0; 3], combine([1.0, -1.0], [a, c])]);
}
