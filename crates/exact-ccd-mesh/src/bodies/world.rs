//! Bodies in a step, in a unit of length in which squares do not overflow.

use std::borrow::Cow;

use exact_ccd::motion::{Chain, RigidMotion};
use exact_ccd::{Options, Point};

use super::Bodies;
use super::body::Body;

/// The largest coordinate, 2³⁸⁰, of numbers that are taken as they are.
const LARGEST: f64 = f64::from_bits((1023 + 380) << 52);

/// Bodies, their motions, and the distance at which they touch, as they are computed with in floating point:
/// all lengths times one power of two, 1 unless a coordinate is above 2³⁸⁰. What is below 2⁻¹⁰²² after that
/// is rounded, by far less than [`TINY`](super::approach::TINY).
pub(super) struct World<'a> {
    pub(super) bodies: Cow<'a, [Body]>,
    pub(super) motions: Cow<'a, [Chain]>,
    pub(super) separation: f64,
}

impl<'a> World<'a> {
    /// The bodies and motions in the unit in which they are given.
    pub(super) fn as_given(bodies: &'a Bodies, motions: &'a [Chain], separation: f64) -> Self {
        Self {
            bodies: Cow::Borrowed(&bodies.bodies),
            motions: Cow::Borrowed(motions),
            separation,
        }
    }

    pub(super) fn new(bodies: &'a Bodies, motions: &'a [Chain], options: Options) -> Self {
        let separation = options.separation.get();
        let places = motions.iter().flat_map(Chain::motions);
        let places = places.map(|motion| largest(motion.places()));
        let of_bodies = bodies.bodies.iter().map(|body| body.largest);
        let most = places.chain(of_bodies).fold(separation, f64::max);
        if most <= LARGEST {
            return Self::as_given(bodies, motions, separation);
        }
        // 2³⁸⁰⁻ᵏ for the power of two 2ᵏ at or below the largest.
        let factor = f64::from_bits((1023 + 380 + 1023 - (most.to_bits() >> 52)) << 52);
        let motions = motions.iter().map(|chain| scaled(chain, factor));
        Self {
            bodies: bodies.bodies.iter().map(|body| body.scaled(factor)).collect(),
            motions: motions.collect(),
            separation: factor * separation,
        }
    }
}

/// The largest magnitude of a coordinate.
pub(super) fn largest(points: &[Point]) -> f64 {
    let coordinates = points.as_flattened().iter();
    coordinates.fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// The chain with all places times a factor.
fn scaled(chain: &Chain, factor: f64) -> Chain {
    let motions = chain.motions().iter().map(|motion| {
        let places: Vec<_> = motion.places().iter().map(|p| p.map(|x| factor * x)).collect();
        RigidMotion::new(motion.quaternions(), &places)
    });
    // Finite places are no error.
    let motions = motions.collect::<Result<Vec<_>, _>>().and_then(Chain::new);
    motions.unwrap_or_else(|_| chain.clone())
}
