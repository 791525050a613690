//! A body in the coordinates of another one, prepared for many queries.

use alloc::boxed::Box;
use alloc::vec::Vec;

use super::counted::Counted;
use super::displacement::{Displacement, Turning};
use super::motion::{Motion, OF_OTHERS, OF_TURN, motions};
use super::polynomial::{MOST, Polynomial};
use crate::environment;
use crate::exact::Turn;
use crate::numbers::roundoff::LARGEST;

/// The motion of a body in the coordinates of another one, in which its point v is at (M v + c) / w, with the
/// Bernstein coefficients of M, c and w in f64, and bounds of their errors.
///
/// The quaternions are scaled by powers of two, so that their largest component is in [1/2, 1): all products
/// of quaternions are below 2¹⁰, and what underflows, 2⁻¹⁰⁷⁵, stays below 2⁻⁹⁰⁰ times [`LARGEST`], the
/// largest factor.
#[derive(Clone, Debug)]
pub(crate) struct Relative {
    /// Of each degree, from 0.
    pub(super) coefficients: Box<[Motion]>,
    /// The largest magnitude of a term of M or w.
    pub(super) turn_magnitude: f64,
    /// The largest magnitude of a term of c, on each axis.
    pub(super) shift_magnitude: [f64; 3],
    /// The motions of both bodies.
    pub(super) chains: [Vec<Turning<f64>>; 2],
    /// The largest number of roundings of a [`difference`](super::motion::difference).
    pub(super) roundings: u32,
}

impl Relative {
    /// The motion of the first body in the coordinates of the second one, each with a chain of motions;
    /// `None` if the degree or the numbers are out of range, or in another environment than the default one.
    pub(crate) fn new([first, second]: [&[Turn<'_>]; 2]) -> Option<Self> {
        if !environment::is_default() {
            return None;
        }
        // A motion of both bodies changes nothing.
        let shared = first.iter().zip(second).take_while(|(one, other)| one == other);
        let shared = shared.count();
        let own = |chain: &[Turn<'_>]| chain[shared..].iter().map(scaled).collect::<Option<Vec<_>>>();
        let [mut first, second] = [own(first)?, own(second)?];
        if first.is_empty() && second.is_empty() {
            first.push(at_rest());
        }
        let all = || first.iter().chain(&second);
        let turns: usize = all().map(|motion| motion.quaternions.len() - 1).sum();
        let shifts = all().map(|motion| motion.places.len() - 1).max();
        if 2 * turns + shifts.unwrap_or(0) >= MOST {
            return None;
        }
        let chains = [first, second];
        let [one, other] = chains.each_ref().map(|chain| {
            let counted = chain.iter().map(|motion| motion.map(Counted::exactly));
            counted.map(|motion| Displacement::of_turn(&motion))
        });
        let displacement = Displacement::between(one, other)?;
        Some(Self::of(&displacement.motion().into_bernstein(), chains))
    }

    fn of(motion: &Motion<Polynomial<Counted>>, chains: [Vec<Turning<f64>>; 2]) -> Self {
        let motions = motions(motion);
        let coefficients = motions.iter().map(|motion| Motion {
            turn: motion.turn.map(|row| row.map(|x| x.value)),
            shift: motion.shift.map(|x| x.value),
            weight: motion.weight.value,
        });
        let of_turn = || motions.iter().flat_map(|motion| motion.turn.as_flattened());
        let weights = || motions.iter().map(|motion| &motion.weight);
        let shifts = motions.iter().flat_map(|motion| &motion.shift);
        let roundings = of_turn().map(|x| x.roundings + OF_TURN);
        let roundings = roundings.chain(shifts.chain(weights()).map(|x| x.roundings + OF_OTHERS));
        let largest = |most: f64, magnitude: f64| most.max(magnitude);
        Self {
            turn_magnitude: of_turn().chain(weights()).map(|x| x.magnitude).fold(0.0, largest),
            shift_magnitude: [0, 1, 2].map(|axis: usize| {
                let shifts = motions.iter().map(|motion| motion.shift[axis].magnitude);
                shifts.fold(0.0, largest)
            }),
            chains,
            roundings: roundings.fold(0, u32::max),
            coefficients: coefficients.collect(),
        }
    }
}

/// A motion in the numbers of the filters, if they are in their range.
fn scaled(turn: &Turn<'_>) -> Option<Turning<f64>> {
    let coordinates = turn.places.as_flattened();
    if coordinates.iter().any(|x| x.abs() > LARGEST) {
        return None;
    }
    let components = turn.quaternions.as_flattened();
    let largest = components.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let (_, exponent) = libm::frexp(largest);
    // In two steps: 2⁻ᵏ itself may be no f64.
    let halves = [-exponent / 2, -exponent - -exponent / 2].map(|half| libm::ldexp(1.0, half));
    let quaternions = turn.quaternions;
    let quaternions = quaternions.map(|q| q.map(|x| x * halves[0] * halves[1]));
    let is_constant = turn.quaternions[0] == turn.quaternions[1];
    let is_resting = turn.places.iter().all(|place| *place == turn.places[0]);
    let places = turn.places.iter().copied();
    Some(Turning {
        quaternions: quaternions
            .into_iter()
            .take(if is_constant { 1 } else { 2 })
            .collect(),
        places: places
            .take(if is_resting { 1 } else { turn.places.len() })
            .collect(),
    })
}

/// No motion.
fn at_rest() -> Turning<f64> {
    Turning {
        quaternions: [[1.0, 0.0, 0.0, 0.0]].into_iter().collect(),
        places: [[0.0; 3]].into_iter().collect(),
    }
}
