//! Random configurations of all kinds, most of them close to contact.

use exact_ccd::Point;
use exact_ccd::predicates::{EdgeFace, orient3d};
use proptest::array::{uniform4, uniform5};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

use exact_ccd_testing::alphabet;
use exact_ccd_testing::intersection as oracle;

type Points = [Point; 5];

/// Small integers, for which points coincide, lines meet and planes are shared; any fractions; and
/// extreme numbers.
fn points() -> impl Strategy<Value = Points> {
    let small = (-2..=2i8).prop_map(f64::from);
    let ordinary = -1.0..1.0;
    let worst = prop::sample::select(alphabet::ALPHABET.to_vec());
    prop_oneof![
        4 => of(small.clone()),
        2 => of(ordinary),
        1 => of(worst.clone()),
        1 => of(prop_oneof![small, worst]),
    ]
}

fn of(coordinate: impl Strategy<Value = f64>) -> impl Strategy<Value = Points> {
    uniform5(prop::array::uniform3(coordinate))
}

fn combine<const N: usize>(factors: [f64; N], points: [Point; N]) -> Point {
    [0, 1, 2].map(|axis: usize| (0..N).map(|i| factors[i] * points[i][axis]).sum())
}

/// Configurations with a point of the face's plane, with these coordinates in eighths, which may be
/// on a side, a corner or outside: the edge passes through or near it, or ends there, or lies in
/// the plane.
fn aimed([a, b, v1, v2, v3]: Points, aim: u8, [first, second]: [[i8; 2]; 2], length: f64) -> Points {
    let on_plane = |[u, v]: [i8; 2]| {
        let [u, v] = [u, v].map(|x| f64::from(x) / 8.0);
        combine([1.0 - u - v, u, v], [v1, v2, v3])
    };
    let target = on_plane(first);
    match aim {
        0 => [a, b, v1, v2, v3],
        1 => [a, combine([1.0 + length, -length], [target, a]), v1, v2, v3],
        2 => [a, target, v1, v2, v3],
        _ => [on_plane(second), target, v1, v2, v3],
    }
}

fn nudged(x: f64, steps: i8) -> f64 {
    let next = if steps < 0 { f64::next_down } else { f64::next_up };
    (0..steps.unsigned_abs()).fold(x, |x, _| next(x))
}

/// Configurations moved by a few units in the last place, with a separate unit on each axis.
fn configuration() -> impl Strategy<Value = Points> {
    let eighths = prop::sample::select(vec![-1, 0, 0, 0, 1, 2, 4, 7, 8, 8, 9]);
    let places = [[eighths.clone(), eighths.clone()], [eighths.clone(), eighths]];
    let length = prop_oneof![Just(1.0), Just(0.5), Just(0.0), 0.0..2.0];
    let steps = prop_oneof![6 => Just(0), 1 => -2..=2i8];
    let unit = prop_oneof![3 => Just(0), 1 => -60..=60, 1 => -400..=400, 1 => -960..=960]
        .prop_map(|exponent| 2f64.powi(exponent));
    let finite = |points: &Points| points.as_flattened().iter().all(|x| x.is_finite());
    (
        (points(), 0..5u8, places, length)
            .prop_map(|(points, aim, places, length)| aimed(points, aim, places, length)),
        uniform5(prop::array::uniform3(steps)),
        prop::array::uniform3(unit),
    )
        .prop_map(|(points, steps, units)| {
            let coordinate = |i: usize, axis: usize| nudged(points[i][axis], steps[i][axis]) * units[axis];
            [0, 1, 2, 3, 4].map(|i| [0, 1, 2].map(|axis| coordinate(i, axis)))
        })
        .prop_filter("finite", finite)
}

fn intersect([a, b, v1, v2, v3]: Points) -> bool {
    EdgeFace::new([a, b], [v1, v2, v3]).unwrap().intersects()
}

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(0),
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(cases(20_000))]

    #[test]
    fn common_points_are_those_of_the_definition(points in configuration()) {
        let [a, b, v1, v2, v3] = points;
        prop_assert_eq!(intersect(points), oracle::intersect([a, b], [v1, v2, v3]));
    }

    #[test]
    fn the_order_of_ends_and_corners_does_not_matter([a, b, x, y, z] in configuration()) {
        let expected = intersect([a, b, x, y, z]);
        for [a, b] in [[a, b], [b, a]] {
            for [v1, v2, v3] in [[x, y, z], [y, z, x], [z, x, y], [y, x, z], [x, z, y], [z, y, x]] {
                prop_assert_eq!(intersect([a, b, v1, v2, v3]), expected);
            }
        }
    }

    #[test]
    fn orientations_are_those_of_the_definition([a, b, c, d, _] in configuration()) {
        let expected = oracle::orientation([a, b, c, d]);
        prop_assert_eq!(orient3d([a, b, c, d]), Ok(expected));
        prop_assert_eq!(orient3d([b, a, c, d]), Ok(expected.reverse()));
        prop_assert_eq!(orient3d([b, c, a, d]), Ok(expected));
        prop_assert_eq!(orient3d([d, c, b, a]), Ok(expected));
    }

    /// Shewchuk's predicate, as implemented by another crate, on points of ordinary magnitude: few integers,
    /// so that many are in one plane, and fractions.
    #[test]
    fn orientations_are_those_of_the_literature(
        integers in uniform4([-3..=3i8, -3..=3i8, -3..=3i8]),
        fractions in uniform4([-1.0..1.0, -1.0..1.0, -1.0..1.0]),
    ) {
        for points in [integers.map(|point| point.map(f64::from)), fractions] {
            let [a, b, c, d] = points.map(|[x, y, z]| robust::Coord3D { x, y, z });
            let expected = robust::orient3d(a, b, c, d).partial_cmp(&0.0).unwrap();
            prop_assert_eq!(orient3d(points), Ok(expected), "{:?}", points);
        }
    }
}

/// The generator yields both answers often, in all degrees of degeneracy.
#[test]
fn the_configurations_are_of_all_kinds() {
    use proptest::strategy::ValueTree;
    let mut runner = proptest::test_runner::TestRunner::new(cases(1));
    let mut counts = [[0; 2]; 3];
    for _ in 0..5_000 {
        let points = configuration().new_tree(&mut runner).unwrap().current();
        let [a, b, v1, v2, v3] = points;
        let in_plane = [a, b]
            .into_iter()
            .filter(|&p| orient3d([v1, v2, v3, p]).unwrap().is_eq());
        counts[in_plane.count()][usize::from(intersect(points))] += 1;
    }
    assert!(
        counts.as_flattened().iter().all(|&count| count > 60),
        "{counts:?}"
    );
}
