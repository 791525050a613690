//! The springs of a system.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::Vector3;

use super::{System, SystemError};
use crate::spring::{Spring, SpringEnd, SpringEnergy};

/// The greatest distance of the end of a spring from its vertex, relative to the extent of the scene.
const NEAR: f64 = 1e-6;

impl System {
    /// The same system with further springs.
    ///
    /// # Errors
    /// [`SystemError::Spring`] names the first one with a number that is out of range,
    /// [`SystemError::SpringEnd`] one whose end is at no vertex of its body.
    pub fn with_springs(mut self, springs: Vec<Spring>) -> Result<Self, SystemError> {
        for (number, spring) in springs.iter().enumerate() {
            spring.check().map_err(|source| SystemError::Spring {
                spring: number,
                source,
            })?;
            let energy = self.spring(number, spring)?;
            let rigidity = energy.stiffness * energy.length * energy.length;
            self.elastic.add(Arc::new(energy), rigidity);
        }
        self.elastic.springs.extend(springs);
        Ok(self)
    }

    fn spring(&self, number: usize, spring: &Spring) -> Result<SpringEnergy, SystemError> {
        // One vertex can carry both ends.
        let mut weights: BTreeMap<u32, f64> = BTreeMap::new();
        let mut fixed = Vector3::zeros();
        for (end, sign) in spring.ends.iter().zip([1.0, -1.0]) {
            match end.body {
                None => fixed -= Vector3::from(end.at) * sign,
                Some(body) => {
                    for (vertex, weight) in self.parts_of(number, body, end)? {
                        *weights.entry(vertex).or_default() += sign * weight;
                    }
                }
            }
        }
        let mut energy = SpringEnergy {
            vertices: weights.keys().copied().collect(),
            weights: weights.into_values().collect(),
            fixed,
            stiffness: spring.stiffness,
            length: 0.0,
        };
        energy.length = spring.length.unwrap_or_else(|| energy.vector(&self.start).norm());
        Ok(energy)
    }

    /// The vertices that carry an end of a spring, with their weights.
    fn parts_of(&self, spring: usize, body: usize, end: &SpringEnd) -> Result<Vec<(u32, f64)>, SystemError> {
        let missing = |nearest: Option<u32>| SystemError::SpringEnd {
            spring,
            body: self.bodies.designation(body),
            at: end.at,
            nearest: nearest.map(|vertex| self.start[vertex as usize]),
        };
        let vertices = self
            .bodies
            .ranges
            .get(body)
            .cloned()
            .ok_or_else(|| missing(None))?;
        if let Some(carried) = self
            .carriers
            .bodies()
            .iter()
            .find(|carried| carried.start == vertices.start)
        {
            return Ok(self
                .carriers
                .carrier_at(carried, &self.start, end.at)
                .parts()
                .collect());
        }
        let distance =
            |vertex: u32| (Vector3::from(self.start[vertex as usize]) - Vector3::from(end.at)).norm();
        let nearest = vertices.min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        match nearest {
            Some(vertex) if distance(vertex) <= NEAR * self.extent => Ok(vec![(vertex, 1.0)]),
            _ => Err(missing(nearest)),
        }
    }
}
