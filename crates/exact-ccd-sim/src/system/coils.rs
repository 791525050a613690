//! Rods that are curved at rest and have no shear modulus.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::System;

/// The angle in rad from which a part of a rod counts as a coil: the sum of all angles between its edges.
const TURN: f64 = std::f64::consts::FRAC_PI_2;

impl System {
    /// The place of the first body that is a rod without a shear modulus, and has a part between two edges
    /// that are held at the start which turns by more than a quarter of a circle at rest. Such a part twists
    /// instead of bending where its ends move, and its cross sections turn without a torque: a coil spring
    /// has no stiffness. Parts with at most one held edge do not resist twist with a shear modulus either.
    pub(crate) fn coil_without_shear(&self) -> Option<usize> {
        // Scripts act after their beginning.
        let held = self.held(f64::MIN_POSITIVE);
        let is_held = |vertex: u32| held[vertex as usize] == [true; 3];
        let is_coil = |chain: &&Vec<u32>| {
            let edges = || chain.windows(2).enumerate();
            let mut ends = edges().filter(|(_, edge)| edge.iter().all(|&vertex| is_held(vertex)));
            let (Some((first, _)), Some((last, _))) = (ends.next(), ends.next_back()) else {
                return false;
            };
            turn(&chain[first..last + 2], &self.start) > TURN
        };
        let coil = self.elastic.untwisted.iter().find(is_coil)?;
        Some(self.bodies.of(coil[0]))
    }
}

/// The sum of the angles between the edges of a chain.
fn turn(chain: &[u32], points: &[Point]) -> f64 {
    let at = |vertex: u32| Vector3::from(points[vertex as usize]);
    let edges: Vec<Vector3<f64>> = chain.windows(2).map(|ends| at(ends[1]) - at(ends[0])).collect();
    edges.windows(2).map(|pair| pair[0].angle(&pair[1])).sum()
}
