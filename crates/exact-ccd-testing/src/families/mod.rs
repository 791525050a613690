//! Families of queries, each with its own numerical difficulty.

mod ingredients;

pub use self::ingredients::quarters;
pub use crate::contacts::grazing;

use proptest::array::{uniform2, uniform3, uniform4, uniform8};
use proptest::prelude::*;

use self::ingredients::{change, nudges, parameters};
use crate::alphabet::ALPHABET;
use crate::changes::{Change, nudge, scaled};
use crate::contacts::touching;
use crate::primitives::{Points, Primitives, combine};

fn points_of(coordinate: impl Strategy<Value = f64> + Clone) -> impl Strategy<Value = Points> + Clone {
    uniform2(uniform4(uniform3(coordinate)))
}

/// Few small integers: every relation among them occurs by chance.
pub fn small_integers(radius: i8) -> impl Strategy<Value = Points> + Clone {
    points_of((-radius..=radius).prop_map(f64::from))
}

/// Integers whose sums are exact and whose products are not.
pub fn large_integers() -> impl Strategy<Value = Points> + Clone {
    const RADIUS: i64 = 1 << 36;
    points_of((-RADIUS..=RADIUS).prop_map(|n| n as f64))
}

/// Small or large integers.
pub fn integers() -> impl Strategy<Value = Points> + Clone {
    prop_oneof![small_integers(8), large_integers()]
}

/// Fractions with all 53 bits in use.
pub fn fractions() -> impl Strategy<Value = Points> + Clone {
    points_of(-1.0..1.0)
}

/// Two to four values for all coordinates.
pub fn few_values() -> impl Strategy<Value = Points> {
    let value = prop_oneof![prop::sample::select(ALPHABET.as_slice()), -1.0..1.0];
    let choice = uniform2(uniform4(uniform3(any::<prop::sample::Index>())));
    (prop::collection::vec(value, 2..5), choice).prop_map(|(values, choice)| {
        choice.map(|now| now.map(|point| point.map(|i| values[i.index(values.len())])))
    })
}

/// Coincident points, zero-length edges, flat faces, parallel edges, coplanar motion, rest.
pub fn degenerate(points: impl Strategy<Value = Points>) -> impl Strategy<Value = Points> {
    (points, prop::collection::vec(change(), 1..4)).prop_map(|(mut points, changes)| {
        changes
            .into_iter()
            .for_each(|change| Change::apply(change, &mut points));
        points
    })
}

/// Points a few steps away from others.
pub fn nearly(points: impl Strategy<Value = Points>) -> impl Strategy<Value = Points> {
    (points, nudges()).prop_map(|(points, nudges)| nudge(points, &nudges))
}

/// Contact at a quarter of the step and of the domain, without rounding.
pub fn exact_contacts<K: Primitives>(
    integers: impl Strategy<Value = Points>,
) -> impl Strategy<Value = Points> {
    (integers, quarters()).prop_map(|(points, place)| touching::<K>(points, place))
}

/// Touching without crossing at a quarter of the step, without rounding.
pub fn exact_grazes<K: Primitives>(integers: impl Strategy<Value = Points>) -> impl Strategy<Value = Points> {
    let velocity = [-4..=4i8, -4..=4i8].prop_map(|factors| factors.map(f64::from));
    (integers, quarters(), velocity)
        .prop_map(|(points, place, velocity)| grazing::<K>(points, place, velocity))
}

/// Contact anywhere, up to rounding.
pub fn rounded_contacts<K: Primitives>() -> impl Strategy<Value = Points> {
    (fractions(), parameters()).prop_map(|(points, place)| touching::<K>(points, place))
}

/// Touching without crossing, up to rounding.
pub fn rounded_grazes<K: Primitives>() -> impl Strategy<Value = Points> {
    let velocity = [-4.0..4.0, -4.0..4.0];
    (fractions(), parameters(), velocity)
        .prop_map(|(points, place, velocity)| grazing::<K>(points, place, velocity))
}

/// A contact or a graze missed by any power of two, at the limits of the filters.
pub fn narrow_misses<K: Primitives>(points: impl Strategy<Value = Points>) -> impl Strategy<Value = Points> {
    let offset = uniform3(-1.0..1.0);
    (points, offset, -70..0i32).prop_map(|(mut points, offset, exponent)| {
        for point in points.iter_mut().flat_map(|now| &mut now[..K::FIRST]) {
            *point = combine([1.0, scaled(1.0, exponent)], [*point, offset]);
        }
        points
    })
}

/// Motion in one plane across an axis, with contact at some time.
pub fn planar_contacts<K: Primitives>() -> impl Strategy<Value = Points> {
    (fractions(), 0..3usize, parameters()).prop_map(|(mut points, axis, place)| {
        Change::Flatten(axis).apply(&mut points);
        touching::<K>(points, place)
    })
}

/// A separate unit on each axis, from 2⁻¹⁰⁰⁰ to 2¹⁰⁰⁰.
pub fn stretched(points: impl Strategy<Value = Points>) -> impl Strategy<Value = Points> {
    (points, uniform3(exponent())).prop_map(|(points, exponents)| {
        points.map(|now| now.map(|point| [0, 1, 2].map(|axis: usize| scaled(point[axis], exponents[axis]))))
    })
}

/// A separate unit for each point at each end of the step, from 2⁻¹⁰⁰⁰ to 2¹⁰⁰⁰.
pub fn scattered(points: impl Strategy<Value = Points>) -> impl Strategy<Value = Points> {
    (points, uniform8(exponent())).prop_map(|(points, exponents)| {
        [0, 1].map(|time: usize| {
            [0, 1, 2, 3].map(|i: usize| points[time][i].map(|x| scaled(x, exponents[4 * time + i])))
        })
    })
}

fn exponent() -> impl Strategy<Value = i32> + Clone {
    prop_oneof![-1000..=1000, -210..=210, Just(0), Just(200)]
}

/// Multiples of the smallest subnormal number.
pub fn subnormal(points: impl Strategy<Value = Points>) -> impl Strategy<Value = Points> {
    points.prop_map(|points| points.map(|now| now.map(|point| point.map(|x| scaled(x, -1074)))))
}

/// Single coordinates of extreme magnitude among ordinary ones.
pub fn extremes() -> impl Strategy<Value = Points> {
    let bits = any::<u64>()
        .prop_map(f64::from_bits)
        .prop_filter("finite", |x| x.is_finite());
    let coordinate = prop_oneof![
        4 => (-2..=2i8).prop_map(f64::from),
        3 => prop::sample::select(ALPHABET.as_slice()),
        1 => bits,
    ];
    points_of(coordinate.boxed())
}

/// A mixture of all families.
pub fn mixed<K: Primitives>() -> impl Strategy<Value = Points> {
    prop_oneof![
        20 => small_integers(2),
        20 => degenerate(small_integers(2)),
        20 => exact_contacts::<K>(integers()),
        10 => exact_grazes::<K>(integers()),
        10 => degenerate(fractions()),
        5 => planar_contacts::<K>(),
        5 => rounded_contacts::<K>(),
        5 => nearly(exact_contacts::<K>(integers())),
        5 => subnormal(exact_contacts::<K>(small_integers(8))),
        5 => stretched(exact_grazes::<K>(small_integers(8))),
        1 => few_values(),
        1 => scattered(degenerate(fractions())),
        1 => extremes(),
    ]
}
