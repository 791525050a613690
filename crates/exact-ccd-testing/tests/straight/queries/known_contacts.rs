//! Queries constructed with contact at a known time. All arithmetic is exact on integers.

use exact_ccd::{EdgeEdge, Point, Separation, VertexFace};
use proptest::array::uniform3;
use proptest::prelude::*;

use crate::queries::rational::Rational;
use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::laws::{checked, contain};
use exact_ccd_testing::primitives::{Points, Primitives, combine};
use exact_ccd_testing::runner::for_all;

/// The points, moved so that F(t, u, v) = (m − n t) d at the given (u, v).
fn with_contact<K: Primitives>(mut points: Points, [u, v]: [f64; 2], time: Rational, d: Point) -> Points {
    let [u, v] = K::in_domain(u, v);
    let (m, n) = time.parts();
    for (now, factor) in points.iter_mut().zip([m, m - n]) {
        let gap = combine(K::weights(u, v), *now);
        for point in &mut now[..K::FIRST] {
            *point = combine([1.0, -1.0, factor], [*point, gap, d]);
        }
    }
    points
}

fn contact_at_a_known_time<K: Primitives>() {
    let place = quarters().prop_map(|[_, u, v]| [u, v]);
    let factor = uniform3((-4..=4i8).prop_map(f64::from));
    let queries = (integers(), place, Rational::in_unit(12), factor);
    for_all(8_000, queries, |(points, place, time, d)| {
        let points = with_contact::<K>(points, place, time, d);
        let times = checked(&query::<K>(&points), Separation::ZERO);
        assert!(time.is_among(&times), "{times:?}: {points:?}");
    });
}

#[test]
fn a_vertex_touches_a_face_at_a_known_time() {
    contact_at_a_known_time::<VertexFace>();
}

#[test]
fn edges_touch_at_a_known_time() {
    contact_at_a_known_time::<EdgeEdge>();
}

fn graze_at_a_known_time<K: Primitives>() {
    let velocity = [-4..=4i8, -4..=4i8].prop_map(|factors| factors.map(f64::from));
    for_all(
        4_000,
        (integers(), quarters(), velocity),
        |(points, place, velocity)| {
            let points = grazing::<K>(points, place, velocity);
            let times = checked(&query::<K>(&points), Separation::ZERO);
            assert!(contain(&times, place[0]), "{times:?}: {points:?}");
        },
    );
}

#[test]
fn a_vertex_grazes_a_face_at_a_known_time() {
    graze_at_a_known_time::<VertexFace>();
}

#[test]
fn edges_graze_at_a_known_time() {
    graze_at_a_known_time::<EdgeEdge>();
}
