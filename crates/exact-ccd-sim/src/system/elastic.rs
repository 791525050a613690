//! The elastic parts of a system.

use std::sync::Arc;

use crate::energies::elasticity::Chain;
use crate::energies::spring::Spring;
use crate::energies::term::Energy;

/// The elastic parts of a system, springs included.
#[derive(Clone, Debug, Default)]
pub(crate) struct Elastic {
    /// All energies but twist.
    pub(crate) elements: Vec<Arc<dyn Energy>>,
    /// The parts of rods that resist twist.
    pub(crate) chains: Vec<Chain>,
    /// The vertices of the parts of rods without a shear modulus.
    pub(super) untwisted: Vec<Vec<u32>>,
    pub(super) tetrahedra: Vec<[u32; 4]>,
    pub(super) springs: Vec<Spring>,
    /// Σ E V over all elements, in J: the scale of the rounding errors of elastic energies.
    pub(crate) rigidity: f64,
}

impl Elastic {
    /// Adds an element with its E V, in J.
    pub(super) fn add(&mut self, element: Arc<dyn Energy>, rigidity: f64) {
        self.elements.push(element);
        self.rigidity += rigidity;
    }
}
