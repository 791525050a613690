//! The springs of a system.

use std::collections::BTreeMap;
use std::sync::Arc;

use nalgebra::Vector3;

use super::{SpringError, System, SystemError};
use crate::energies::spring::{Spring, SpringEnd, SpringEnergy};

/// The greatest distance of the end of a spring from its vertex, relative to the extent of the scene.
const NEAR: f64 = 1e-6;

impl System {
    /// The same system with further springs.
    ///
    /// # Errors
    /// [`SystemError::Spring`] names the first one with a number that is out of range, or with an end that is
    /// at no vertex of its body.
    pub fn with_springs(mut self, springs: Vec<Spring>) -> Result<Self, SystemError> {
        for (number, spring) in springs.iter().enumerate() {
            let energy = self.spring(spring).map_err(|source| SystemError::Spring {
                spring: number,
                source,
            })?;
            let rigidity = energy.stiffness * energy.length * energy.length;
            self.elastic.add(Arc::new(energy), rigidity);
        }
        self.elastic.springs.extend(springs);
        Ok(self)
    }

    fn spring(&self, spring: &Spring) -> Result<SpringEnergy, SpringError> {
        spring.check()?;
        // One vertex can carry both ends.
        let mut weights: BTreeMap<u32, f64> = BTreeMap::new();
        let mut fixed = Vector3::zeros();
        for (end, sign) in spring.ends.iter().zip([1.0, -1.0]) {
            match end.body {
                None => fixed -= Vector3::from(end.at) * sign,
                Some(body) => {
                    for (vertex, weight) in self.parts_of(body, end)? {
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
    fn parts_of(&self, place: usize, end: &SpringEnd) -> Result<Vec<(u32, f64)>, SpringError> {
        let body = self.bodies.designation(place);
        let Some(vertices) = self.bodies.ranges.get(place).cloned() else {
            return Err(SpringError::Body { body });
        };
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
            Some(vertex) => Err(SpringError::End {
                body,
                at: end.at,
                nearest: self.start[vertex as usize],
            }),
            None => Err(SpringError::Body { body }),
        }
    }
}
