//! The bounds of a distance above 0, by the numbers of [`proof`](crate::filter::proof).

use super::advance::Advancement;
use super::approach::{Near, OF_MINOR, Step, error_of_quotient, minor, product};
use super::beside_contact::least_volume;
use super::closest::Closest;
use super::largest_square;
use super::scaled::Scaled;
use super::snapshot::{
    Moving, OF_SQUARE, OF_SUM, OF_THRESHOLD, Precision, error_of_excess, excess, least_of, threshold,
};
use super::turning::{Heading, limit};
use crate::filter::coplanarity::Coplanarity;
use crate::filter::double_double::ROUNDOFF;
use crate::filter::hull::Hull;
use crate::filter::number::Number;
use crate::filter::proof::{
    Precise, Script, Symbol, assert_bound, assert_counts, opposite_points, power, symbols,
};
use crate::filter::roundoff::UNIT;
use crate::filter::vector::dot;
use crate::kind::{EdgeEdge, Kind, Tables, VertexFace};
use crate::query::Query;

#[test]
fn turning_directions() {
    fn check<K: Kind>() {
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
    let [a0, b0] = [vectors[0], vectors[1]].map(|[x, y, _]| [x, y].map(Symbol::exactly));
    assert_eq!(minor(a0, b0).roundings, 2);
    assert_eq!(OF_MINOR / UNIT, power(2));
    let moved = a.plus(
        &b,
        Step {
            value: 0.5,
            error: 0.0,
        },
    );
    assert_bound(moved.error, a.extent() + 0.5 * b.extent(), 3);
    let [value, error] = product(&a, &b);
    assert_eq!(value, symbol.value);
    assert_bound(error, 2.0 * a.extent() * b.extent(), 3);
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
    fn check<K: Kind>() {
        for seed in 1..=20 {
            let planes = Coplanarity::<Symbol>::new::<K>(&symbols(opposite_points(seed)));
            let d = Symbol::input(0.5);
            let least = least_volume(d, planes.extent());
            assert_counts(&[least], 8, 3, least.permanent);
            assert_eq!(least.value, 0.5 * planes.extent().value * (1.0 + power(8) * UNIT));
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
    let query = Query::<EdgeEdge>::from_finite(points);
    let scaled = Scaled::new(&Hull::new::<EdgeEdge>(&points), 0.5).unwrap();
    let corners = Moving::<Precise<TWICE>>::new(&query, &scaled).corners(T);
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
    assert_eq!(least.roundings, 5);
    assert!(least.permanent <= extent);
    let Precise(limit) = threshold(0.5, g, h);
    assert_eq!((limit.roundings, limit.permanent), (7, limit.value));
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
