//! Queries constructed to stay apart, on two sides of a plane. All arithmetic is exact on integers.

use exact_ccd::{EdgeEdge, Point, Separation, VertexFace};
use proptest::array::{uniform2, uniform3};
use proptest::prelude::*;

use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::laws::checked;
use exact_ccd_testing::primitives::{Points, Primitives, combine, dot};
use exact_ccd_testing::runner::for_all;

fn direction() -> impl Strategy<Value = Point> {
    uniform3((-3..=3i8).prop_map(f64::from)).prop_filter("not zero", |vector| *vector != [0.0; 3])
}

fn assert_never_touches<K: Primitives>(points: &Points) {
    let times = checked(&query::<K>(points), Separation::ZERO);
    assert!(times.is_empty(), "{points:?}");
}

/// The points, moved along each other so that at both ends the first primitive lies at or above a
/// level of the scalar product with a direction, and the second one strictly below, by the smallest
/// distance between integers.
fn apart<K: Primitives>(mut points: Points, direction: Point, levels: [f64; 2]) -> Points {
    let unit = dot(direction, direction);
    for (now, level) in points.iter_mut().zip(levels) {
        for (i, point) in now.iter_mut().enumerate() {
            let height = dot(*point, direction) / unit - level;
            let steps = if i < K::FIRST {
                (-height).ceil().max(0.0)
            } else {
                -(height.floor() + 1.0).max(0.0)
            };
            *point = combine([1.0, steps], [*point, direction]);
        }
    }
    points
}

fn never_across_a_plane<K: Primitives>() {
    let levels = uniform2((-4..=4i8).prop_map(f64::from));
    for_all(
        8_000,
        (integers(), direction(), levels),
        |(points, direction, levels)| {
            let points = apart::<K>(points, direction, levels);
            for (now, level) in points.iter().zip(levels) {
                let level = level * dot(direction, direction);
                let (first, second) = now.split_at(K::FIRST);
                assert!(first.iter().all(|x| dot(*x, direction) >= level));
                assert!(second.iter().all(|x| dot(*x, direction) < level));
            }
            assert_never_touches::<K>(&points);
        },
    );
}

#[test]
fn a_plane_keeps_a_vertex_from_a_face() {
    never_across_a_plane::<VertexFace>();
}

#[test]
fn a_plane_keeps_edges_apart() {
    never_across_a_plane::<EdgeEdge>();
}

/// Returns true if a turning plane separates the primitives: n(t) · F is quadratic in t for n(t) =
/// (1 − t) n₀ + t n₁, and positive where its Bernstein coefficients are.
fn is_parted_by<K: Primitives>(points: &Points, [n0, n1]: [Point; 2]) -> bool {
    K::DOMAIN.iter().all(|&[u, v]| {
        let [f0, f1] = points.map(|now| combine(K::weights(u, v), now));
        dot(n0, f0) > 0.0 && dot(n0, f1) + dot(n1, f0) > 0.0 && dot(n1, f1) > 0.0
    })
}

/// Moves the first primitive at both ends along normals that form an acute angle, until they
/// separate.
fn out_of_the_way<K: Primitives>(mut points: Points, normals: [Point; 2]) -> Points {
    while !is_parted_by::<K>(&points, normals) {
        for (now, normal) in points.iter_mut().zip(normals) {
            for point in &mut now[..K::FIRST] {
                *point = combine([1.0, 1.0], [*point, normal]);
            }
        }
    }
    points
}

fn never_across_a_turning_plane<K: Primitives>() {
    let normals = uniform2(direction()).prop_map(|[a, b]| match dot(a, b) {
        0.0 => [a, combine([1.0, 1.0], [a, b])],
        cosine => [a, b.map(|x| x * cosine.signum())],
    });
    for_all(4_000, (small_integers(8), normals), |(points, normals)| {
        let points = out_of_the_way::<K>(points, normals);
        assert_never_touches::<K>(&points);
    });
}

#[test]
fn a_turning_plane_keeps_a_vertex_from_a_face() {
    never_across_a_turning_plane::<VertexFace>();
}

#[test]
fn a_turning_plane_keeps_edges_apart() {
    never_across_a_turning_plane::<EdgeEdge>();
}
