//! The free vertices of a system, and their mass.

use super::System;
use crate::scripted::{Axes, Coordinates};

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

    /// The masses that [`System::free_mass`] sums. Not empty.
    fn counted_masses(&self) -> Vec<f64> {
        let masses = |is_counted: &dyn Fn(usize) -> bool| -> Vec<f64> {
            let masses = self.masses.iter().copied().enumerate();
            let counted = masses.filter(|&(vertex, mass)| mass > 0.0 && is_counted(vertex));
            counted.map(|(_, mass)| mass).collect()
        };
        let free = masses(&|vertex| self.is_free(vertex));
        let counted = if free.is_empty() { masses(&|_| true) } else { free };
        if counted.is_empty() { vec![1.0] } else { counted }
    }
}
