//! The bounds of motion on curves, by the numbers of [`proof`](crate::filter::proof).

use alloc::vec::Vec;
use core::ops::Div;

use fastrand::Rng;

use super::corners::{Corners, halved};
use super::counted::Counted;
use super::displacement::{Displacement, Turning};
use super::motion::{Motion, difference, motions};
use super::piece::{ALONG, across, of_area, of_mean, of_volume, weighted};
use super::polynomial::{Coefficient, MOST, binomials};
use super::relative::Relative;
use super::volume::{COEFFICIENTS, weighted_volumes};
use crate::exact::Turn;
use crate::filter::proof::{Symbol, power};
use crate::numbers::roundoff::UNIT;
use crate::numbers::vector::{cross, dot};
use crate::tables::{EdgeEdge, Point};

/// The numbers of motions of both bodies, and the degree of their places.
const SHAPES: [([usize; 2], usize); 6] = [
    ([1, 0], 1),
    ([0, 1], 1),
    ([1, 1], 1),
    ([1, 0], 3),
    ([2, 1], 1),
    ([2, 2], 0),
];

/// Quaternions and places.
type Given = (Vec<[f64; 4]>, Vec<Point>);

/// Motions whose largest component of a quaternion is 3/4: they are not scaled.
fn given(random: &mut Rng, count: usize, degree: usize) -> Vec<Given> {
    let mut number = || random.f64() - 0.5;
    let mut motion = || {
        let [[_, x, y, z], end] = [(); 2].map(|()| [(); 4].map(|()| number()));
        (
            alloc::vec![[0.75, x, y, z], end],
            (0..=degree).map(|_| [(); 3].map(|()| number())).collect(),
        )
    };
    (0..count).map(|_| motion()).collect()
}

fn relative<T: Coefficient + Div<f64, Output = T>>(
    chains: &[Vec<Given>; 2],
    of: [fn(f64) -> T; 2],
) -> Vec<Motion<T>> {
    let [first, second] = chains.each_ref().map(|chain| {
        let motion = |(quaternions, places): &Given| Turning {
            quaternions: quaternions.iter().map(|q| q.map(of[0])).collect(),
            places: places.iter().map(|p| p.map(of[1])).collect(),
        };
        chain
            .iter()
            .map(motion)
            .map(|motion| Displacement::of_turn(&motion))
    });
    let displacement = Displacement::between(first, second);
    motions(&displacement.expect("a motion").motion().into_bernstein())
}

fn numbers<T: Copy>(motion: &Motion<T>) -> impl Iterator<Item = T> {
    let turn = motion.turn.into_iter().flatten();
    turn.chain(motion.shift).chain([motion.weight])
}

/// A motion counts what its symbols record.
#[test]
fn coefficients() {
    let mut random = Rng::with_seed(1);
    for (lengths, degree) in SHAPES {
        let chains = lengths.map(|length| given(&mut random, length, degree));
        let symbols = relative(&chains, [Symbol::exactly, Symbol::input]);
        let counted = relative(&chains, [Counted::exactly; 2]);
        let turns: usize = lengths.iter().sum();
        assert_eq!(counted.len(), 2 * turns + degree + 1, "{lengths:?} {degree}");
        let mut tight = 0;
        for (symbol, number) in symbols.iter().zip(&counted) {
            for (symbol, number) in numbers(symbol).zip(numbers(number)) {
                assert_eq!(symbol.value.to_bits(), number.value.to_bits());
                assert_eq!(symbol.roundings, number.roundings);
                assert!(symbol.permanent <= number.magnitude * (1.0 + 1e-9));
                tight += usize::from(symbol.permanent >= number.magnitude * (1.0 - 1e-9));
                // Nothing underflows by more than 2⁻¹⁰⁷⁵ 2²⁰¹ 2¹⁷.
                assert!(symbol.underflow <= 2.0_f64.powi(218), "{}", symbol.underflow);
            }
        }
        assert!(tight > 0);
    }
}

/// The bounds of the corners have the constants that the roundings require, and hold for all terms.
#[test]
fn corners() {
    let mut random = Rng::with_seed(2);
    for (lengths, degree) in SHAPES {
        let chains = lengths.map(|length| given(&mut random, length, degree));
        let symbols = relative(&chains, [Symbol::exactly, Symbol::input]);
        let turns = chains.each_ref().map(|chain| {
            let turns = chain.iter().map(|(quaternions, places)| Turn {
                quaternions: [quaternions[0], quaternions[1]],
                places,
            });
            turns.collect::<Vec<_>>()
        });
        let found = Relative::new([&turns[0], &turns[1]]).expect("numbers in range");
        let points = [(); 4].map(|()| [(); 3].map(|()| random.f64() - 0.5));
        let corners = Corners::of_bodies::<EdgeEdge>(&points, &found).expect("numbers in range");
        let mut most = 0;
        for (k, motion) in symbols.iter().enumerate() {
            for (corner, (i, j)) in [(0, 2), (0, 3), (1, 2), (1, 3)].into_iter().enumerate() {
                let [v, x] = [i, j].map(|point: usize| points[point].map(Symbol::input));
                for (axis, symbol) in difference(motion, v, x).into_iter().enumerate() {
                    most = most.max(symbol.roundings);
                    assert!(symbol.permanent <= corners.magnitude[axis]);
                    let value = corners.curves.corners[corner][k][axis];
                    assert_eq!(symbol.value.to_bits(), value.to_bits());
                }
            }
        }
        assert_eq!(most, corners.roundings);
        assert_eq!(corners.error(ALONG), power(most + ALONG) * UNIT);
    }
}

#[test]
fn halves() {
    let mut random = Rng::with_seed(3);
    for points in 2..=MOST {
        let mut row = [(); MOST].map(|()| Symbol::input(random.f64() - 0.5));
        let largest = row[..points]
            .iter()
            .fold(0.0, |most: f64, x| most.max(x.permanent));
        for level in 1..=3 {
            let halves = halved(row, points);
            let all = || halves.iter().flat_map(|half| &half[..points]);
            let most = all().map(|x| x.roundings).max();
            assert_eq!(most, Some(level * (points as u32 - 1)));
            assert!(all().all(|x| x.permanent <= largest * (1.0 + 1e-9)));
            // The half with more roundings.
            row = halves[usize::from(random.bool())];
            let roundings = row[..points].iter().map(|x| x.roundings).max();
            if roundings != most {
                row = halves[0];
            }
        }
    }
}

#[test]
fn products() {
    let mut random = Rng::with_seed(4);
    for n in 1..20 {
        let mut vector = || {
            [(); 3].map(|()| {
                let mut symbol = Symbol::input(random.f64() - 0.5);
                symbol.roundings = n;
                symbol
            })
        };
        let [a, b, c] = [(); 3].map(|()| vector());
        let direction = a.map(|x| Symbol::exactly(x.value));
        assert_eq!(dot(direction, b).roundings, n + ALONG);
        assert!(cross(b, c).iter().all(|x| x.roundings == of_area(n)));
        assert_eq!(dot(a, cross(b, c)).roundings, of_volume(n));
    }
}

/// The coefficients of the volume have the roundings and the magnitudes of their bound, in which half of the
/// roundings are too few.
#[test]
fn volumes() {
    let mut random = Rng::with_seed(5);
    for points in 2..=MOST {
        let n = 7;
        let curves = [(); 3].map(|()| {
            let mut number = || {
                let mut symbol = Symbol::input(random.f64() - 0.5);
                symbol.roundings = n;
                symbol
            };
            (0..points)
                .map(|_| [(); 3].map(|()| number()))
                .collect::<Vec<_>>()
        });
        let magnitude = [0, 1, 2].map(|axis: usize| {
            let all = curves.iter().flatten().map(|point| point[axis].permanent);
            all.fold(0.0, f64::max)
        });
        let [x, y, z] = magnitude;
        let found = weighted_volumes(curves.each_ref().map(Vec::as_slice), Symbol::exactly(0.0));
        let degree = 3 * (points - 1);
        let weights: [f64; COEFFICIENTS] = binomials(degree);
        for (symbol, weight) in found.iter().zip(weights).take(degree + 1) {
            assert!(symbol.permanent <= 6.0 * x * y * z * weight * (1.0 + 1e-9));
        }
        let most = found.iter().map(|symbol| symbol.roundings).max().unwrap_or(0);
        let bound = of_mean(n, points as u32);
        assert!(most <= bound && 2 * most > bound, "{points}: {most} {bound}");
    }
}

#[test]
fn gaps() {
    let [one, mut weight] = [1.0, 1.0].map(Symbol::exactly);
    weight.roundings = 1;
    let bound = weighted(one, weight);
    assert_eq!((bound.value - 1.0) / UNIT, power(3));
    assert_eq!(bound.roundings, 3);
    let direction = [1.0, 0.0, 0.0].map(Symbol::exactly);
    let limit = across(one, direction);
    assert_eq!((limit.value - 1.0) / UNIT, power(8));
    // And the sum.
    assert_eq!(limit.roundings + 1, 8);
}
