//! The bounds of a distance above 0, by the numbers of [`proof`](crate::filter::proof).

use super::advance::Advancement;
use super::approach::{
    Approach, Near, Step, error_of_corner, error_of_point, error_of_quotient, error_of_velocity, is_inside,
    minor, minor_within, product, quotient,
};
use super::beside_contact::least_volume;
use super::closest::Closest;
use super::crossing::Crossings;
use super::largest_square;
use super::scaled::Scaled;
use super::snapshot::{
    Moving, OF_SQUARE, OF_SUM, OF_THRESHOLD, Precision, error_of_excess, excess, least_of, threshold,
};
use super::turning::{Heading, limit};
use crate::filter::coplanarity::Coplanarity;
use crate::filter::hull::Hull;
use crate::filter::proof::{
    Precise, Script, Symbol, assert_bound, assert_counts, opposite_points, power, symbols,
};
use crate::numbers::double_double::ROUNDOFF;
use crate::numbers::number::Number;
use crate::numbers::roundoff::UNIT;
use crate::numbers::vector::{cross, dot};
use crate::tables::{EdgeEdge, Tables, VertexFace, VertexVertex};
use crate::values::ContactTime;

#[test]
fn turning_directions() {
    fn check<K: Tables>() {
        for seed in 1..=20 {
            let hull = Hull::new::<K>(&symbols(opposite_points(seed)));
            let ends = [hull.corners(0), hull.corners(1)];
            let reach = hull.reaches();
            let total = reach[0].value + reach[1].value + reach[2].value;
            let nothing = Symbol::input(0.0);
            let advancement = Advancement::new(ends, nothing, reach);
            // Directions of components of at most 1.
            let [a, b] = [0.25, 0.75].map(|t| {
                let mut heading = advancement.at::<K>(Symbol::exactly(t));
                heading.direction = [1.0, -1.0, 1.0].map(Symbol::exactly);
                heading
            });
            for corner in 0..4 {
                for heading in [&a, &b] {
                    let places = [&a, &b].map(|other| heading.along_to(&other.corners[corner]));
                    assert_counts(&places, 7, 1, total);
                }
                assert_counts(&[a.across(&b, corner)], 8, 1, 2.0 * total);
            }
            // Of magnitudes that add up to `total`, with the error of `across` against twice the limit.
            assert_bound(limit(nothing, reach).value, total, 8);

            // At one of the times, corners and direction in twice the precision, rounded.
            let rounded = Heading {
                corners: ends[0],
                direction: b.direction.map(|component| component * Symbol::exactly(1.0)),
            };
            assert_counts(&[rounded.across(&b, 0)], 9, 1, 2.0 * total);
            assert_bound(limit(nothing, reach).value, total, 9);

            let across = [0, 1, 2].map(|axis: usize| ends[0][0][axis].afresh());
            let unit = Heading::new(ends[0], across).direction;
            assert!(unit.iter().all(|x| x.roundings == 6), "less than eight");
        }
        let nothing = [Symbol::input(0.0); 3];
        let least = limit(Symbol::input(1.0), nothing);
        assert_eq!((least.value - 1.0) / UNIT, power(12));
        assert_eq!(least.roundings, 4, "with the eight of the directions");
    }
    check::<VertexFace>();
    check::<EdgeEdge>();
}

#[test]
fn points_within_a_distance() {
    let point = [1.0, 0.0, 0.0].map(Symbol::input);
    let square = largest_square(point);
    assert_eq!(square.roundings, 6, "with that of the square of the distance");
    assert_eq!((square.value - 1.0) / UNIT, 2.0 * power(39) + power(7));
}

#[test]
fn scalar_products_of_vectors_with_errors() {
    let vectors = [[1.0, 2.0, 3.0], [-3.0, 1.0, 5.0]];
    let [a, b] = vectors.map(|value| Near { value, error: 0.0 });
    let symbol = {
        let [a, b] = vectors.map(|vector| vector.map(Symbol::exactly));
        dot(a, b)
    };
    assert_eq!(symbol.roundings, 3);
    assert_eq!(minor([3.0, 5.0], [-3.0, 7.0]), 36.0);
    let [a0, b0] = [[3.0, 5.0], [-3.0, 7.0]].map(|pair| pair.map(Symbol::exactly));
    let symbol = minor(a0, b0);
    assert_eq!(symbol.roundings, 2);
    let [p, q] = [a0, b0].map(|pair| pair.map(|x| [x.value, 0.0]));
    assert_bound(minor_within(p, q)[1], symbol.permanent, 2);
    let moved = a.plus(
        &b,
        Step {
            value: 0.5,
            error: 0.0,
        },
    );
    assert_bound(moved.error, a.extent() + 0.5 * b.extent(), 3);
    let [value, error] = product(&a, &b);
    assert_eq!(value, dot(vectors[0], vectors[1]));
    assert_bound(error, 2.0 * a.extent() * b.extent(), 3);
    // The rounding of a difference: 2 + 2 u has the rounding 2 u.
    let [two, small] = [2.0, -2.0 * UNIT].map(|x| Near {
        value: [x, 0.0, 0.0],
        error: 0.0,
    });
    let difference = two.minus(&small);
    assert_eq!((difference.value[0], difference.error), (2.0, 2.0 * UNIT));
}

/// The ends of what a number can be.
fn ends([value, error]: [f64; 2]) -> [f64; 2] {
    [value - error, value + error]
}

/// The corners of what a vector can be.
fn box_corners(near: &Near) -> impl Iterator<Item = [f64; 3]> + Clone {
    let sides = near.value.map(|x| ends([x, near.error]));
    (0..8_usize).map(move |corner| [0, 1, 2].map(|axis: usize| sides[axis][corner >> axis & 1]))
}

/// Asserts that an error bounds the differences of some numbers from a value, with a factor of at least
/// `least`.
#[track_caller]
fn assert_covers(values: impl Iterator<Item = f64>, [value, error]: [f64; 2], least: f64) {
    let far = values.fold(0.0, |far: f64, x| far.max((x - value).abs()));
    assert!(error >= least * far, "{error} for {far}");
}

/// Numbers and errors in multiples of 1 / 8, so that all products are exact; or all numbers but one are
/// exact.
fn numbers_with_errors<const N: usize>(count: usize) -> impl Iterator<Item = [[f64; 2]; N]> {
    let mut random = fastrand::Rng::with_seed(1);
    (0..count).map(move |_| {
        let only = random.usize(..2 * N);
        core::array::from_fn(|i| {
            let error = if only == i || only >= N {
                f64::from(random.i32(0..=8))
            } else {
                0.0
            };
            [f64::from(random.i32(-8..=8)), error].map(|x| x / 8.0)
        })
    })
}

/// Each bound is compared with the values at all ends of large errors, where the functions are farthest from
/// the value between. What is doubled for the roundings of the bound is at least twice as large.
#[test]
fn errors_of_numbers_and_vectors() {
    for [a, b, c, d] in numbers_with_errors(2000) {
        let both = |[p, q]: [[f64; 2]; 2]| {
            let [p, q] = [p, q].map(ends);
            p.into_iter()
                .flat_map(move |p| q.into_iter().map(move |q| [p, q]))
        };
        let minors = || both([a, b]).flat_map(|ab| both([c, d]).map(move |cd| minor(ab, cd)));
        assert_covers(minors(), minor_within([a, b], [c, d]), 1.0);
        if let Some(Step { value, error }) = quotient(a, b) {
            assert!(ends(b)[0] > 0.0);
            // The quotients are rounded themselves.
            assert_covers(both([a, b]).map(|[r, s]| r / s), [value, error], 2.0 - 1e-9);
        }
    }
    // The least denominator is less by twice its error.
    assert!(quotient([1.0, 0.0], [1.0, 0.5]).is_none());
    for [x, y, z, u, v, w, s] in numbers_with_errors(2000) {
        // Some vectors have one component only.
        let is_thin = z[1] == 0.0;
        let near = |[x, y, z]: [[f64; 2]; 3]| Near {
            value: [
                x[0],
                if is_thin { 0.0 } else { y[0] },
                if is_thin { 0.0 } else { z[0] },
            ],
            error: x[1],
        };
        let [a, b] = [near([x, y, z]), near([u, v, w])];
        let pairs = || box_corners(&a).flat_map(|p| box_corners(&b).map(move |q| [p, q]));
        let extents = box_corners(&a).map(|p| p.into_iter().map(f64::abs).sum());
        assert_eq!(extents.fold(0.0, f64::max), a.extent());
        assert_covers(pairs().map(|[p, q]| dot(p, q)), product(&a, &b), 2.0);
        let (difference, crossed) = (a.minus(&b), a.cross(&b));
        let step = Step {
            value: s[0],
            error: s[1],
        };
        let moved = a.plus(&b, step);
        for axis in 0..3 {
            let bound = |near: &Near| [near.value[axis], near.error];
            assert_covers(pairs().map(|[p, q]| p[axis] - q[axis]), bound(&difference), 1.0);
            assert_covers(pairs().map(|[p, q]| cross(p, q)[axis]), bound(&crossed), 2.0);
            let places = pairs().flat_map(|[p, q]| ends(s).map(|s| p[axis] + s * q[axis]));
            assert_covers(places, bound(&moved), 1.0);
        }
    }
}

#[test]
fn errors_of_closest_points() {
    // A component of a corner, of at most 1, moves by 2 w at most.
    let of_corner = error_of_corner(0.0) / (UNIT + 8.0 * ROUNDOFF);
    assert!((1.125..2.3).contains(&of_corner), "{of_corner}");
    assert_eq!(error_of_corner(0.25) - error_of_corner(0.0), 0.5);
    for m in [0.0, 1.0, 1e9] {
        let of_point = error_of_point(0.0, m) / (UNIT * m + 53.0 * ROUNDOFF);
        assert!((1.125..2.3).contains(&of_point), "{of_point} for {m}");
        assert_eq!(error_of_point(0.25, m), 0.5 + error_of_point(0.0, m));
    }
    // The largest velocities: 2 and −2 at corners, so that F has 2 − 4 u − 4 v.
    let inner = EdgeEdge::FEATURES.inner.unwrap();
    let velocity = [2.0, -2.0, -2.0, -2.0].map(|x| [x; 3]);
    let delta = 0.125;
    let at = |s: f64| Closest::Inner(inner, [s; 2]).point(&velocity)[0];
    assert_eq!(
        error_of_velocity(delta) - error_of_velocity(0.0),
        (at(0.5) - at(0.5 + delta)).abs()
    );
    let rounded = velocity.map(|corner| corner.map(|x| Precise::<false>(Symbol::exactly(x).rounded())));
    // Parameters with a product that is rounded.
    let [Precise(x), ..] = Closest::Inner(inner, [1.0 - UNIT; 2]).point(&rounded);
    assert_eq!((x.roundings, x.permanent.round()), (5, 10.0));
    assert_eq!(error_of_velocity(0.0), 64.0 * UNIT, "more than 5 · 10 u");
}

#[test]
fn parameters_and_directions_next_to_their_limits() {
    // Inside by more than twice the error, and 8 u for the roundings of the distance and of the bound.
    let is_inside = |error: f64| is_inside([0.75, 0.5], error).is_some();
    assert_eq!(
        [0.25, 0.25 - 4.0 * UNIT, 0.25 - 5.0 * UNIT].map(is_inside),
        [false, false, true]
    );
    // The direction of points at rest is off by 2 w. Four times that has to be within 2⁻³³ of it.
    let [p, q] = [[0.75, 0.0, 0.0], [0.0; 3]];
    let points = [[p, p, q, q]; 2];
    let scaled = Scaled::new(&Hull::new::<VertexVertex>(&points), 0.5).unwrap();
    let crossings = Crossings::new::<VertexVertex>(&points, &scaled);
    let now = crossings.precise.at::<VertexVertex>(0.0);
    let is_accurate = |factor: f64| {
        let width = factor * 0.75 * (-36.0_f64).exp2();
        let approach = Approach::new::<VertexVertex>(&now, &crossings.precise, width).unwrap();
        approach
            .impact::<VertexVertex>(ContactTime::exactly(0.0))
            .is_some()
    };
    assert_eq!([0.999, 1.001].map(is_accurate), [true, false]);
}

#[test]
fn quotients_of_numbers_with_errors() {
    let [r, s, of_r, of_s] = [3.0, 7.0, 1.0, 2.0].map(Symbol::exactly);
    let (value, least) = (r / s, (s - of_s).afresh().rounded());
    assert_eq!(value.roundings, 1);
    assert_eq!(error_of_quotient(value, of_r, of_s, least).roundings, 6);
    // The terms without roundings are 1, 1 and u: margin(6) u above that would do.
    assert_eq!(error_of_quotient(0.0, 1.0, 1.0, 1.0), 2.0);
    assert_eq!(error_of_quotient(1.0, 0.0, 1.0, 1.0), 2.0 + 4.0 * UNIT);
    assert_eq!(error_of_quotient(-1.0, 0.0, 0.0, 1.0), 4.0 * UNIT);
    // Quotients of 1 ± 1 / 4 and 1 ± 1 / 2 are at most 2.5.
    assert_eq!(error_of_quotient(1.0, 0.25, 0.5, 0.5), 2.0 * 1.5 + 4.0 * UNIT);
}

#[test]
fn a_small_distance_of_planes() {
    fn check<K: Tables>() {
        for seed in 1..=20 {
            let planes = Coplanarity::<Symbol>::new::<K>(&symbols(opposite_points(seed)));
            let d = Symbol::input(0.5);
            let least = least_volume(d, planes.extent);
            assert_counts(&[least], 8, 3, least.permanent);
            assert_eq!(least.value, 0.5 * planes.extent.value * (1.0 + power(8) * UNIT));
        }
    }
    check::<VertexFace>();
    check::<EdgeEdge>();
}

impl<const TWICE: bool> Precision for Precise<TWICE> {
    const SETTLED: f64 = 0.0;
    const REFINES: bool = TWICE;
}

/// The parameters of a script: numbers that occur nowhere else.
const T: f64 = 0.3;
const U: f64 = 0.21;
const V: f64 = 0.43;

/// The corners at the time T, and F at the parameters U and V.
fn corners_and_point<const TWICE: bool>() -> [[Symbol; 3]; 5] {
    let points = opposite_points(1);
    let scaled = Scaled::new(&Hull::new::<EdgeEdge>(&points), 0.5).unwrap();
    let corners = Moving::<Precise<TWICE>>::new::<EdgeEdge>(&points, &scaled).corners(T);
    let inner = EdgeEdge::FEATURES.inner.unwrap();
    let point = Closest::Inner(inner, [U, V]).point(&corners);
    let [a, b, c, d] = corners;
    [a, b, c, d, point].map(|vector| vector.map(|Precise(symbol)| symbol))
}

#[test]
fn absolute_errors() {
    let [a, b, c, _, point] = corners_and_point::<false>().map(|[x, ..]| x);
    let corner = Script {
        name: "corner",
        about: "a component of a corner",
        is_twice: false,
        parameters: &[T, U, V],
        bounded: &[a, b, c],
        value: a,
        units: 5,
    };
    corner.check();
    let rough = Script {
        name: "point",
        about: "a component of F",
        value: point,
        units: 39,
        ..corner
    };
    rough.check();
    let [a, b, c, _, point] = corners_and_point::<true>().map(|[x, ..]| x);
    let twice = Script {
        name: "precise_corner",
        about: "a component of a corner in twice the precision",
        is_twice: true,
        bounded: &[a, b, c],
        value: a,
        units: 8,
        ..corner
    };
    twice.check();
    Script {
        name: "precise_point",
        about: "a component of F in twice the precision",
        value: point,
        units: 53,
        ..twice
    }
    .check();
}

#[test]
fn distances_in_twice_the_precision() {
    let [g, h, x, y] = [
        [1.0, 0.5, 0.25],
        [-0.25, 1.0, 0.5],
        [0.5, 0.75, 1.0],
        [1.0, -0.5, 0.5],
    ]
    .map(|vector: [f64; 3]| vector.map(|x| Precise::<true>::difference(x, 0.0)));
    let extent = 3.5;
    let slack = Precise::<true>::difference(0.0, 0.0);
    let Precise(least) = least_of(dot(g, x), dot(h, y), slack);
    assert_eq!((least.roundings, least.value), (5, 0.625));
    assert!(least.permanent <= extent);
    let Precise(limit) = threshold(0.5, g, h);
    assert_eq!(
        (limit.roundings, limit.permanent, limit.value),
        (7, 1.3125, 1.3125)
    );
    let constants = [OF_SUM, OF_THRESHOLD, OF_SQUARE].map(|constant| constant / ROUNDOFF);
    assert_eq!(
        constants,
        [8 + least.roundings, limit.roundings + 1, 2].map(power)
    );

    let Precise(square) = excess(x, 0.5);
    assert_eq!(square.roundings, 4);
    let Precise(of_distance) = excess([slack; 3], 0.5);
    assert_eq!(of_distance.permanent, 0.25);
    // Each term of the bound exceeds the required one, and by less than 2.3 times.
    let required = |m: f64, d: f64| {
        ROUNDOFF * (106.0 * m + 4.0 * m * m + 2.0 * d * d) + 3.0 * (53.0 * ROUNDOFF) * (53.0 * ROUNDOFF)
    };
    for (m, d) in [(0.0, 0.0), (1e-9, 0.0), (1e9, 0.0), (0.0, 1.0)] {
        let ratio = error_of_excess(m, d) / required(m, d);
        assert!((1.125..2.3).contains(&ratio), "{ratio} for {m} and {d}");
    }
}
