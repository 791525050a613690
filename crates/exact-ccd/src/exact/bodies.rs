//! The points of two rigid bodies, each with a chain of motions.

use super::displacement::Displacement;
use super::dyadic::{in_unit, unit_of};
use super::frame::Frame;
use super::points::MovingPoints;
use super::polynomial::{Polynomial, cross};
use super::turn::Turn;
use crate::tables::{Point, Tables};

impl MovingPoints {
    /// The points of two bodies, each in the coordinates of its own body, with the motions of both bodies.
    /// The motions of a body apply from the last to the first, like the joints of a chain.
    pub(crate) fn of_bodies<K: Tables>(points: &[Point; 4], chains: [&[Turn<'_>]; 2]) -> Self {
        let places = chains.iter().flat_map(|chain| chain.iter());
        let places = places.flat_map(|turn| turn.places);
        let unit = unit_of(points.iter().chain(places).flatten().copied());
        // A motion of both bodies changes nothing.
        let [first, second] = chains;
        let shared = first.iter().zip(second).take_while(|(one, other)| one == other);
        let shared = shared.count();
        let whole = Displacement::of_chain(second, unit);
        let [first, second] = chains.map(|chain| Displacement::of_chain(&chain[shared..], unit));
        let relative = first.seen_from(second);

        let local = points.map(|point| point.map(|x| Polynomial::constant(in_unit(x, unit))));
        let count = K::SPAN[0].1;
        // Without an edge, its line does not matter: zeros cost nothing.
        let end = &local[if count > 1 { 1 } else { 0 }];
        let direction = [0, 1, 2].map(|axis: usize| &end[axis] - &local[0][axis]);
        let moment = cross(&local[0], end);
        let frame = Frame::new(count, &relative, [&moment, &direction], whole);
        let mut moving = local;
        for point in &mut moving[..count] {
            *point = relative.point(point);
        }
        Self::in_frame(moving, unit, frame)
    }
}

#[cfg(test)]
mod tests;
