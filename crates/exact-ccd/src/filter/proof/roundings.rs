//! The number of roundings of each value with a bound, and that the bound derives from it.
//!
//! The inputs of a test make the magnitude of the bound equal to the permanent, so that the quotient of both
//! is the constant of the bound.

use alloc::format;
use core::cmp::Ordering;
use core::ops::RangeInclusive;

use super::assertions::{assert_bound, assert_counts, assert_in_range, opposite_points, power, symbols};
use super::gappa::exponent;
use super::{Precise, Script, Symbol};
use crate::filter::coplanarity::{Coplanarity, Expansion};
use crate::filter::gap::{Touching, Within};
use crate::filter::hull::{Hull, diagonal_limit};
use crate::filter::planar::Planar;
use crate::filter::position::NearRoot;
use crate::fixed::moment::{self, Moment};
use crate::fixed::window::Window;
use crate::numbers::cubic::{Cubic, Root};
use crate::numbers::determinant::{determinant, error_of_determinant};
use crate::numbers::double_double::{DoubleDouble, ROUNDOFF};
use crate::numbers::number::Lanes;
use crate::numbers::precise_cubic::PreciseCubic;
use crate::numbers::roundoff::{LARGEST, UNDERFLOW, UNIT, margin};
use crate::numbers::vector::{cross, cross_along, interpolate};
use crate::tables::{EdgeEdge, Tables, VertexFace};

/// One of the parameters in [0, 1] at which an interpolation has two equal weights, or one of them.
const PARAMETERS: [f64; 3] = [0.0, 0.5, 1.0];

const SEEDS: RangeInclusive<u64> = 1..=20;

#[test]
fn the_margin_covers_roundings_and_those_of_the_bound() {
    for n in 1..=1000 {
        assert_eq!(margin(n), power(n));
        // In units of u² / 2: (margin (1 − k u) − n) (1 − n u) > n² u for k = 64 roundings of the bound.
        let (n, k) = (f64::from(n), 64.0);
        let rest = power(n as u32) * (1.0 - k * UNIT) - n;
        assert!(rest >= 0.5 && rest > 2.0 * n * n * UNIT);
    }
}

#[test]
fn the_range_is_between_underflow_and_overflow() {
    assert_eq!(LARGEST, 2.0_f64.powi(200));
    assert_eq!(UNDERFLOW * LARGEST * LARGEST * LARGEST, 1.0);
    // For the range 2ᵏ, 1000 errors of 2⁻¹⁰⁷⁵, each enlarged by two factors of 2ᵏ⁺¹, are below 2⁻³ᵏ.
    let is_above = |k: i32| 1000.0 * 2.0_f64.powi(2 * (k + 1) + 3 * k - 1000) * 2.0_f64.powi(-75) < 1.0;
    assert!((0..=212).all(is_above) && !is_above(213));
}

#[test]
fn coplanarity_cubics() {
    fn check<K: Tables>() {
        for seed in SEEDS {
            let planes = Coplanarity::<Symbol>::new::<K>(&symbols(opposite_points(seed)));
            let Cubic { bernstein, magnitude } = planes.cubic;
            assert_counts(&bernstein, 11, 3, magnitude.value);
            assert_bound(planes.cubic.coefficient_error().value, bernstein[1].permanent, 11);
            assert_in_range(&planes.cubic.coefficient_error());
            for t in PARAMETERS.map(Symbol::exactly) {
                for s in PARAMETERS.map(Symbol::exactly) {
                    assert_counts(&[planes.cubic.blossom(s, s, t)], 19, 3, magnitude.value);
                    assert_counts(&planes.cubic.slopes(s, t), 18, 3, 2.0 * magnitude.value);
                }
            }
            let half = Symbol::exactly(0.5);
            let value = planes.cubic.blossom(half, half, half);
            assert_bound(planes.cubic.blossom_error().value, value.permanent, 19);
            let [_, slope, _] = planes.cubic.slopes(half, half);
            assert_bound(planes.cubic.slope_error().value, slope.permanent, 18);
        }
    }
    check::<VertexFace>();
    check::<EdgeEdge>();
}

#[test]
fn normals() {
    fn check<K: Tables>() {
        for seed in SEEDS {
            let planes = Coplanarity::<Symbol>::new::<K>(&symbols(opposite_points(seed)));
            let total = |vector: [Symbol; 3]| vector.iter().map(|x| x.permanent).sum::<f64>();
            let extent = planes.extent.value;
            for normal in planes.normals {
                assert_counts(&normal, 4, 2, total(normal));
                assert!((total(normal) - extent).abs() < 1e-9 * extent);
            }
            assert_counts(&planes.mixed, 5, 2, 2.0 * extent);
            assert!((total(planes.mixed) - 2.0 * extent).abs() < 1e-9 * extent);
        }
        // Sides of length 1 along two axes: all lengths and the extent are 1.
        let mut start = [[0.0; 3]; 4];
        for (axis, &(i, _)) in K::SPAN[1..].iter().enumerate() {
            start[i][axis] = 1.0;
        }
        let mut planes = Coplanarity::<Symbol>::new::<K>(&symbols([start, start]));
        for normal in planes.normals.iter_mut().chain([&mut planes.mixed]) {
            *normal = normal.map(Symbol::afresh);
        }
        let bounds = planes.least_distances(Within(Symbol::input(1.0)));
        for bound in bounds {
            assert_eq!((bound.value - 1.0) / UNIT, power(11) + power(5));
            // And the sum with the error of the coefficient.
            assert!(bound.roundings < 11);
            assert_eq!(bound.degree, 3);
            assert_in_range(&bound);
        }
    }
    check::<VertexFace>();
    check::<EdgeEdge>();
}

#[test]
fn separating_directions() {
    fn check<K: Tables>() {
        for seed in SEEDS {
            // The first primitive is a point, the second one the origin: all corners are the same.
            let [start, _] = opposite_points(seed);
            let mut points = [[[0.0; 3]; 4]; 2];
            for now in &mut points {
                now[..K::CORNERS[0].1].fill(start[0]);
            }
            let hull = Hull::new::<K>(&symbols(points));
            let direction = start[1].map(|x| Symbol::exactly(x).of_degree(2));
            let along = hull.along(direction);
            let error = hull.error_along(direction);
            assert_counts(&along, 4, 3, along[0].permanent);
            assert_bound(error.value, along[0].permanent, 4);
            assert_in_range(&error);
            // The error of the sum of the reaches, for a unit direction.
            let unit = [1.0, 0.0, 0.0].map(|x| Symbol::exactly(x).of_degree(2));
            let limit = hull.limit_along(unit, Within(Symbol::input(0.0)));
            let [x, y, z] = hull.reaches();
            assert_bound(limit.value, (x + y + z).value, 4);
        }
        let points = symbols([[[LARGEST.recip(); 3], [0.0; 3], [0.0; 3], [0.0; 3]]; 2]);
        let direction = [1.0, 0.0, 0.0].map(|x| Symbol::exactly(x).of_degree(2));
        let hull = Hull::new::<K>(&points);
        let limit = hull.limit_along(direction, Within(Symbol::input(1.0)));
        assert_eq!(limit.roundings, 12);
        assert_eq!((limit.value - 1.0) / UNIT, power(12));
        assert_in_range(&limit);
        let error = hull.error_along(direction).value;
        assert_eq!(hull.limit_along(direction, Touching).value, error);
    }
    check::<VertexFace>();
    check::<EdgeEdge>();
}

#[test]
fn diagonals() {
    let [[[a, b, ..], [c, d, ..], ..], _] = symbols(opposite_points(1));
    let (x, y) = (a - c, b - d);
    let reaches = x.abs() + y.abs();
    for value in [x + y, x - y] {
        assert_counts(&[value], 2, 1, reaches.value);
    }
    let nothing = Symbol::input(0.0);
    assert_bound(
        diagonal_limit(nothing, reaches).value,
        x.permanent + y.permanent,
        2,
    );
    // The part of the distance: the constant is above √2 by what its roundings require.
    let limit = diagonal_limit(Symbol::input(1.0), nothing);
    let excess = (limit.value - core::f64::consts::SQRT_2) / (core::f64::consts::SQRT_2 * UNIT);
    assert!((excess - power(4)).abs() <= 2.0, "{excess}");
    assert!(limit.roundings < 4, "with that of the constant");
}

#[test]
fn quadratics_of_planar_motion() {
    for seed in SEEDS {
        // Not differences of 2, whose product is their sum.
        let points = opposite_points(seed).map(|now| now.map(|[x, y, _]| [4.0 * x, 4.0 * y, 1.0]));
        let [x, y] = [(0, 2), (1, 0)];
        let planar = Planar::new(&points).unwrap();
        let (coefficients, magnitude) = planar.expand::<Precise<false>>(x, y);
        assert_counts(&coefficients.map(|Precise(symbol)| symbol), 6, 2, 3.0 * magnitude);
        let ([q0, .., q1], magnitude) = planar.expand::<Precise<true>>(x, y);
        assert!(q0.0.permanent.max(q1.0.permanent) <= magnitude * (1.0 + 1e-9));
    }
}

#[test]
fn quadratics_at_a_moment() {
    let mut random = fastrand::Rng::with_seed(1);
    for _ in SEEDS {
        let quadratic = [(); 3].map(|()| Symbol::exactly(random.f64() - 0.5).of_degree(2).rounded());
        let magnitude = quadratic.iter().map(|q| q.value.abs()).sum();
        let near = Symbol::exactly(random.f64());
        assert_counts(&[moment::value_at(quadratic, near)], 7, 2, magnitude);
        let error = |radius: f64| moment::error_near(quadratic, Symbol::exactly(radius)).value;
        assert_bound(error(0.0), magnitude, 7);
    }
}

/// The change of a quadratic in a bracket is below its bound, which is 2.5 times the largest one.
#[test]
fn quadratics_in_a_bracket() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut largest: f64 = 0.0;
    for _ in 0..10_000 {
        let quadratic = [(); 3].map(|()| random.f64() - 0.5);
        let quadratic = [quadratic, [quadratic[0], 0.0, 0.0]][random.usize(..2)];
        let (radius, end) = (0.01 * random.f64(), 0.9 * random.f64());
        let near = [end, 0.0][random.usize(..2)];
        let change = moment::value_at(quadratic, near + radius) - moment::value_at(quadratic, near);
        largest = largest.max(change.abs() / moment::error_near(quadratic, radius));
    }
    assert!((0.39..=0.4).contains(&largest), "{largest}");
}

#[test]
fn linear_functions_at_a_moment() {
    // The time of a place in a window is the sum of its beginning and a part of its width, both rounded. The
    // coefficients of the value are rounded once. The terms of 1 − t, counted, add up to 2, so the terms of
    // the value add up to 2 |d₀| + |d₁|.
    let [low, width] = [0.25, 0.25].map(|time| Symbol::exactly(time).rounded());
    let t = low + Symbol::exactly(0.5) * width;
    assert_eq!(t.roundings, 3);
    let coefficient = || Symbol::exactly(1.0).of_degree(1).rounded();
    let value = (-t + 1.0) * coefficient() + t * coefficient();
    assert_counts(&[value], 7, 1, 3.0);
    // Of the value j u, the sign is certain from just above 2 margin(7) on.
    let bracket = Root {
        low: 0.5,
        high: 0.5,
        near: 0.5,
        slope: 1.0,
        before: Ordering::Less,
    };
    let sign = |units: f64| {
        let moment = Moment::Root(Window::STEP, bracket);
        moment.sign_of_linear([1.0 + 2.0 * units * UNIT, -1.0])
    };
    let threshold = 2.0 * power(7);
    assert_eq!(
        [sign(threshold), sign(threshold + 1.0)],
        [None, Some(Ordering::Greater)]
    );
    // In a bracket of this radius, the value changes by at most the slope, |d₀| + |d₁|. The bound has twice
    // the slope.
    let wide = Root {
        low: 0.375,
        ..bracket
    };
    let at = |start: f64| Moment::Root(Window::STEP, wide).sign_of_linear([start, -1.0]);
    assert_eq!([at(2.99), at(3.01)], [None, Some(Ordering::Greater)]);
}

#[test]
fn positions_near_a_root() {
    for seed in SEEDS {
        let points = opposite_points(seed);
        let [start, end] = symbols(points);
        let (d0, d1) = (start[1][0] - start[0][0], end[1][0] - end[0][0]);
        let place = interpolate(d0, d1, Symbol::exactly(0.5));
        assert_counts(&[place], 4, 1, d0.value.abs());
        let [a, b] = [start[0], start[1]].map(|point| point.map(Symbol::afresh));
        let product = cross_along(0, a, b);
        assert_counts(&[product], 2, 2, product.permanent);

        let root = Root {
            low: 0.5,
            high: 0.5,
            near: 0.5,
            slope: 1.0,
            before: Ordering::Less,
        };
        let bracket = NearRoot::new(&points, &root);
        let [x, y] = [(1, 0), (3, 2)].map(|difference| bracket.vector(difference));
        let error = bracket.cross_along(0, &x, &y).error;
        let exact = [(1, 0), (3, 2)].map(|(i, j): (usize, usize)| {
            [0, 1, 2].map(|axis: usize| Symbol::input(points[0][i][axis] - points[0][j][axis]))
        });
        let units = error / (UNIT * cross(exact[0], exact[1])[0].permanent);
        assert!(
            (units - 2.0 * power(4) - power(2)).abs() < 1e-9 * units,
            "{units}"
        );
        // A quarter of the step on either side: the slack is 4 / 4, and the relative error 2 + 1.
        let wide = Root {
            low: 0.25,
            high: 0.75,
            ..root
        };
        let error = NearRoot::new(&points, &wide).cross_along(0, &x, &y).error;
        let relative = error / cross(exact[0], exact[1])[0].permanent;
        assert!((relative - 3.0).abs() < 1e-9, "{relative}");
    }
}

#[test]
fn volumes() {
    for seed in SEEDS {
        let [[a, b, c, d], _] = symbols(opposite_points(seed));
        let from_a = |p: [Symbol; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let (u, v, w) = (from_a(b), from_a(c), from_a(d));
        let volume = determinant(u, v, w);
        assert_counts(&[volume], 8, 3, volume.permanent);
        assert_bound(error_of_determinant(u, v, w).value, volume.permanent, 8);
    }
}

#[test]
fn cubics_in_twice_the_precision() {
    fn check<K: Tables>() {
        for seed in SEEDS {
            let Expansion {
                coefficients,
                magnitude,
                ..
            } = Expansion::<Precise<true>>::new::<K>(&opposite_points(seed));
            let counts = coefficients.map(|Precise(symbol)| symbol);
            assert_counts(&counts, 7, 3, 3.0 * magnitude);
            let cubic = PreciseCubic::new(coefficients, magnitude);
            let Precise(end) = cubic.value(1.0);
            assert_counts(&[end], 16, 3, 27.0 * magnitude);
            let operations = cubic.error / (ROUNDOFF * end.permanent);
            assert!((operations - power(16)).abs() < 1e-9 * operations, "{operations}");
        }
    }
    check::<VertexFace>();
    check::<EdgeEdge>();
    assert!(PreciseCubic::new([DoubleDouble::default(); 4], 0.0).error >= UNDERFLOW);
}

#[test]
fn operations_in_twice_the_precision() {
    // Gappa proves the statements of these files; of the product, it does not prove half of the bound.
    for script in [
        include_str!("../../../proof/double_double_product.g"),
        include_str!("../../../proof/double_double_sum.g"),
    ] {
        let statement = format!("<= 1b{} }}\n", exponent(ROUNDOFF / 4.0));
        assert_eq!(script.matches(&statement).count(), 1, "{statement}");
    }
}

#[test]
fn absolute_errors() {
    // The differences, which are at most 1 in magnitude, are rounded.
    let [u, v, w] = [(); 3].map(|()| [(); 3].map(|()| Symbol::input(0.5).rounded()));
    let volume = Script {
        name: "volume",
        about: "the volume of differences: n = 8 and a permanent of 6 have 48 u",
        is_twice: false,
        parameters: &[],
        bounded: &[],
        value: determinant(u, v, w),
        units: 24,
    };
    volume.check();
    let points = opposite_points(1);
    let Expansion { coefficients, .. } = Expansion::<Precise<false>>::new::<EdgeEdge>(&points);
    let coefficient = Script {
        name: "coplanarity",
        about: "three times a coefficient of the cubic: n = 10 and a permanent of 18 have 180 u",
        value: coefficients[1].0,
        units: 94,
        ..volume
    };
    coefficient.check();
    /// The parameter that stands for all times.
    const TIME: f64 = 0.375;
    let given = [(); 4].map(|()| Precise::<true>(Symbol::input(0.5)));
    let Precise(value) = PreciseCubic::new(given, 1.0).value(TIME);
    let twice = Script {
        name: "precise_cubic",
        about: "a cubic at a time in twice the precision: n = 9 and a permanent of 15 have 135 units",
        is_twice: true,
        parameters: &[TIME],
        value,
        units: 135,
        ..volume
    };
    twice.check();
}

/// Differences and their products are within the errors of their estimates at all times of a bracket.
#[test]
fn estimates_hold_in_all_of_a_bracket() {
    let mut random = fastrand::Rng::with_seed(1);
    let bracket = Root {
        low: 0.25,
        high: 0.75,
        near: 0.5,
        slope: 1.0,
        before: Ordering::Less,
    };
    let edges = [(1, 0), (3, 2)];
    for exponent in [0, 20, -20, -700] {
        let unit = libm::ldexp(1.0, exponent);
        for _ in 0..2000 {
            // Many are zero, at one end of the step or at both.
            let mut number = || unit * f64::from(random.i32(-2..=2) * random.i32(0..=1));
            let points = [(); 2].map(|()| [(); 4].map(|()| [(); 3].map(|()| number())));
            let near = NearRoot::new(&points, &bracket);
            let [a, b] = edges.map(|difference| near.vector(difference));
            for t in [0.25, 0.5, 0.75] {
                // Without rounding.
                let [x, y] = edges.map(|(i, j): (usize, usize)| {
                    let d = |end: usize, axis: usize| points[end][i][axis] - points[end][j][axis];
                    [0, 1, 2].map(|axis: usize| interpolate(d(0, axis), d(1, axis), t))
                });
                let product = cross(x, y);
                for axis in 0..3 {
                    let found = near.component(&a, axis);
                    assert!((x[axis] - found.value).abs() <= found.error && found.error >= UNDERFLOW);
                    let found = near.cross_along(axis, &a, &b);
                    assert!((product[axis] - found.value).abs() <= found.error);
                    assert!(found.error == 0.0 || found.error >= UNDERFLOW);
                }
            }
        }
    }
}
