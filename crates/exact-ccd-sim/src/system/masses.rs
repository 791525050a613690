//! The free vertices of a system, their mass and their stiffness.

use nalgebra::Matrix3;

use super::System;
use crate::energies::term::Projection;
use crate::prescribed::{Axes, Coordinates};

impl System {
    /// Returns true if a vertex has mass, and at least one coordinate that no script holds at all times.
    #[must_use]
    pub fn is_free(&self, vertex: usize) -> bool {
        self.masses[vertex] > 0.0 && !self.scripts[vertex].are_held()
    }

    /// Returns true if a vertex has mass, or an affine body carries it.
    #[must_use]
    pub fn has_mass(&self, vertex: u32) -> bool {
        self.masses[vertex as usize] > 0.0 || self.carriers.of(vertex).is_some()
    }

    /// The coordinates of each vertex that are not free at this time, in s: coordinates that scripts hold,
    /// and all coordinates of a vertex without mass.
    pub(crate) fn held(&self, time: f64) -> Vec<Axes> {
        let held = |(scripts, &mass): (&Coordinates, &f64)| {
            if mass > 0.0 { scripts.held(time) } else { [true; 3] }
        };
        self.scripts.iter().zip(&self.masses).map(held).collect()
    }

    /// The mass of all free vertices, in kg. If no vertex is free, the mass of all vertices; if no vertex has
    /// mass, 1 kg.
    pub(crate) fn free_mass(&self) -> f64 {
        self.counted_masses().iter().sum()
    }

    /// The mean mass of the vertices that [`System::free_mass`] sums, in kg.
    pub(crate) fn mean_mass(&self) -> f64 {
        self.free_mass() / self.counted_masses().len() as f64
    }

    /// The mean stiffness at rest of the vertices that [`System::free_mass`] counts, in N/m: for each of
    /// them, the least eigenvalue of its block of the elastic Hessian, while all others rest. So shells and
    /// rods have their stiffness in bending, and a spring has none. It is 0 for the nodes of
    /// affine bodies, whose energy keeps them rigid and is no material, and for an elastic Hessian that is
    /// not finite.
    pub(crate) fn mean_stiffness(&self) -> f64 {
        let mut blocks = vec![Matrix3::zeros(); self.start.len()];
        for element in &self.elastic.elements {
            let hessian = element.hessian(&self.start, Projection::SemiDefinite);
            for (place, &vertex) in element.vertices().iter().enumerate() {
                blocks[vertex as usize] += hessian.fixed_view::<3, 3>(3 * place, 3 * place);
            }
        }
        for node in self
            .carriers
            .bodies()
            .iter()
            .flat_map(|body| self.carriers.nodes(body))
        {
            blocks[node as usize].fill(0.0);
        }
        let counted = self.counted_vertices();
        let stiffness = |&vertex: &usize| match blocks[vertex] {
            block if block.iter().all(|entry| entry.is_finite()) => {
                block.symmetric_eigenvalues().min().max(0.0)
            }
            _ => 0.0,
        };
        counted.iter().map(stiffness).sum::<f64>() / counted.len().max(1) as f64
    }

    /// The masses that [`System::free_mass`] sums. Not empty.
    fn counted_masses(&self) -> Vec<f64> {
        let counted: Vec<f64> = self
            .counted_vertices()
            .into_iter()
            .map(|vertex| self.masses[vertex])
            .collect();
        if counted.is_empty() { vec![1.0] } else { counted }
    }

    /// The free vertices with mass; if there are none, all vertices with mass.
    fn counted_vertices(&self) -> Vec<usize> {
        let massive = || (0..self.masses.len()).filter(|&vertex| self.masses[vertex] > 0.0);
        let free: Vec<usize> = massive().filter(|&vertex| self.is_free(vertex)).collect();
        if free.is_empty() {
            massive().collect()
        } else {
            free
        }
    }
}
