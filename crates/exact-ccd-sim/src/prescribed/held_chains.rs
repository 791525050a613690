//! The twist of rods between edges that are held.

use std::collections::BTreeMap;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::dirichlet::Dirichlet;
use super::paths::{Acting, Paths};
use super::vertices::Axes;
use crate::energies::elasticity::{Chain, Twist, angle_about, transported};

/// The parts of rods between two held edges, in a part of a time step. Beyond the last held edge, cross
/// sections turn freely. Without twist their energy is least: 0, for every shape.
pub(crate) struct HeldChains<'a> {
    paths: &'a Paths<'a>,
    chains: Vec<Chain>,
}

impl<'a> HeldChains<'a> {
    /// The chains between held edges, if `held` are the coordinates that are not free.
    pub(crate) fn new(paths: &'a Paths<'a>, held: &[Axes]) -> Self {
        let is_held = |vertex: u32| held[vertex as usize] == [true; 3];
        let rods = paths.system.elastic.chains.iter();
        let chains = rods.flat_map(|rod| rod.between_held(is_held)).collect();
        Self { paths, chains }
    }

    /// The twists after the motions so far. An obstructed end has turned as far as its body has moved.
    pub(crate) fn twists(&self, dirichlet: &Dirichlet<'_>) -> Vec<Twist> {
        let Paths { system, state, .. } = self.paths;
        let twist = |chain: &Chain| {
            let fraction = dirichlet.fraction(system.bodies.of(chain.ends()[0][0]) as u32);
            let before: f64 = chain
                .inner()
                .iter()
                .filter_map(|vertex| state.twists.get(vertex))
                .sum();
            Twist::new(chain, &state.positions, before + self.turned(chain, fraction))
        };
        self.chains.iter().map(twist).collect()
    }

    /// The angles of twists at positions, by their inner vertices, each with its share.
    pub(crate) fn angles(&self, twists: &[Twist], positions: &[Point]) -> BTreeMap<u32, f64> {
        let parts = self.chains.iter().zip(twists).flat_map(|(chain, twist)| {
            let angle = twist.angle(positions);
            let shares = chain.shares().map(move |share| angle * share);
            chain.inner().iter().copied().zip(shares)
        });
        parts.collect()
    }

    /// The angle by which the cross section at the last edge of a chain turns up to a fraction of the part,
    /// minus the angle at the first edge: by the earlier scripts, until others begin within the part, and by
    /// these. It is measured about the direction of the edge, relative to a frame that turns with this
    /// direction by the least rotation, and less than half a turn for each end.
    fn turned(&self, chain: &Chain, fraction: f64) -> f64 {
        let during = |acting: Acting| {
            let carried = |vertex: u32, apart: Vector3<f64>| {
                let carried = self.paths.carried(vertex as usize, apart, fraction, acting);
                carried.map(Vector3::from)
            };
            let [first, last] = chain.ends().map(|edge| turn_of(edge, &carried));
            last - first
        };
        during(Acting::Earlier) + during(Acting::Later)
    }
}

/// The turn at one edge between two times. Its first vertex carries the frame. `carried` returns the
/// positions at both times of a point that a vertex carries, from the vector to it where the script began.
fn turn_of([a, b]: [u32; 2], carried: &dyn Fn(u32, Vector3<f64>) -> [Vector3<f64>; 2]) -> f64 {
    let [from, to] = [a, b].map(|vertex| carried(vertex, Vector3::zeros()));
    // An edge without a length has no direction, and turns by 0 about it.
    let directions = [0, 1].map(|time: usize| (to[time] - from[time]).try_normalize(0.0).unwrap_or_default());
    let across = |time: usize, vector: Vector3<f64>| {
        let direction = directions[time];
        vector - direction * direction.dot(&vector)
    };
    // One of the three axes is across the edge by more than half of its length.
    let frames = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| {
        let at = carried(a, axis);
        [0, 1].map(|time: usize| across(time, at[time] - from[time]))
    });
    let widest = frames
        .into_iter()
        .max_by(|a, b| a[0].norm().total_cmp(&b[0].norm()));
    let [before, after] = widest.unwrap_or_default();
    let [s, t] = directions;
    angle_about(&t, &transported(&before, &s, &t), &after)
}
