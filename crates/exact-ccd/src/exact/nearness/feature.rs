//! Pairs of features: the distance of two vertices, of a vertex and the line of an edge, of two
//! lines or a vertex and a plane, each where its closest points lie inside the features.

use alloc::vec::Vec;
use core::cmp::Ordering;

use dashu_int::IBig;

use crate::exact::instant::Instant;
use crate::exact::intervals::{Event, Passage};
use crate::exact::narrowing::Narrowing;
use crate::exact::polynomial::Polynomial;
use crate::exact::roots::roots_of;
use crate::tables::{Difference, Side};

/// Two features, one of each primitive.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pair {
    /// Two vertices, and the parameters (u, v) of the primitives there.
    Vertices(Difference, [f64; 2]),
    /// A vertex of one primitive and an edge of the other.
    VertexEdge(&'static Side),
    /// A vertex and a face, or two edges: their inner points.
    Inner,
}

/// The squared distance of two features as a quotient of polynomials in t.
///
/// Where the length is not 0 and all guards are at least 0, the quotient is the squared distance of
/// two points of the primitives. At each time, this holds for a pair of features whose points are the
/// closest of the primitives.
#[derive(Clone, Debug)]
pub(super) struct Feature {
    pub(super) pair: Pair,
    /// λ, a common factor of the components of the edge, or of the normal. Numerator and denominator are
    /// those of the vector divided by λ; the denominator is its square.
    length: Polynomial,
    numerator: Polynomial,
    denominator: Polynomial,
    /// The closest points of the lines or planes lie inside the features exactly if none of these
    /// is negative.
    pub(super) guards: Vec<Polynomial>,
    excess: Polynomial,
}

impl Feature {
    pub(super) fn new(
        pair: Pair,
        length: Polynomial,
        [numerator, denominator]: [Polynomial; 2],
        guards: Vec<Polynomial>,
        squared_separation: &Polynomial,
    ) -> Self {
        let excess = &numerator - &(squared_separation * &denominator);
        Self {
            pair,
            length,
            numerator,
            denominator,
            guards,
            excess,
        }
    }

    /// Returns true if the excess vanishes at a time inside the step at which the feature exists, but not at
    /// all times. An end of the step may count too: callers decide both ends apart.
    pub(super) fn crosses(&self) -> bool {
        let mut roots = self.roots().into_iter();
        roots.any(|root| self.exists(&Narrowing::new(root)))
    }

    /// The times of the step at which the excess vanishes, in increasing order. There are none if it is zero
    /// at all times, or if a guard has a coefficient below 0 and none above: the feature exists at no time
    /// inside the step then. It may exist at an end, which callers decide apart.
    pub(super) fn roots(&self) -> Vec<Instant> {
        let is_negative =
            |guard: &Polynomial| !guard.is_zero() && guard.coefficients().iter().all(|c| *c <= IBig::ZERO);
        let may_cross = !self.excess.is_zero() && !self.guards.iter().any(is_negative);
        let roots = may_cross.then(|| roots_of(&self.excess));
        roots.unwrap_or_default()
    }

    /// A root of the excess at which the feature exists, with the bracket that this needs.
    ///
    /// The bracket has no other root of the excess. If the feature exists for a while around it, the distance
    /// is less than d where the excess is negative.
    pub(super) fn existing(&self, root: Instant) -> Option<Event> {
        let instant = Narrowing::new(root);
        let existence = self.existence(&instant);
        let time = instant.into_instant();
        let start = existence
            .is_gt()
            .then(|| time.sign_before(&self.excess.reduced()));
        let passage = match start.flatten() {
            Some(Ordering::Less) => Passage::Exit,
            Some(Ordering::Greater) => Passage::Entry,
            _ => Passage::Unknown,
        };
        existence.is_ge().then_some(Event { time, passage })
    }

    /// Numerator and denominator of the squared distance.
    pub(super) fn squared_distance(&self) -> [&Polynomial; 2] {
        [&self.numerator, &self.denominator]
    }

    /// The numerator less d² times the denominator.
    #[cfg(test)]
    pub(super) fn excess(&self) -> &Polynomial {
        &self.excess
    }

    /// Returns true if the quotient is the squared distance of two points of the primitives.
    pub(super) fn exists(&self, instant: &Narrowing) -> bool {
        self.existence(instant).is_ge()
    }

    /// Less if the feature does not exist, greater if it exists for a while around this time.
    ///
    /// A guard that is easily proved to be negative spares the other signs.
    fn existence(&self, instant: &Narrowing) -> Ordering {
        let mut least = Ordering::Greater;
        let mut unknown = Vec::new();
        for guard in &self.guards {
            match instant.plain_sign(guard) {
                Some(Ordering::Less) => return Ordering::Less,
                Some(sign) => least = least.min(sign),
                None => unknown.push(guard),
            }
        }
        if instant.sign(&self.length).is_eq() {
            return Ordering::Less;
        }
        for guard in unknown {
            match instant.sign(guard) {
                Ordering::Less => return Ordering::Less,
                sign => least = least.min(sign),
            }
        }
        least
    }

    /// Returns true if two points of these features are at most d apart.
    pub(super) fn is_within(&self, instant: &Narrowing) -> bool {
        instant.sign(&self.excess).is_le() && self.exists(instant)
    }

    /// Compares the distances of two pairs of features that exist.
    pub(super) fn compare(&self, other: &Self, instant: &Narrowing) -> Ordering {
        instant.sign(&(&(&self.numerator * &other.denominator) - &(&other.numerator * &self.denominator)))
    }
}
