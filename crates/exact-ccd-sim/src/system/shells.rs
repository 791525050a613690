//! Shells whose meshes do not resist twist everywhere.

use super::System;
use crate::energies::elasticity::incomplete_part;

/// The part of the inner vertices from which a shell counts as too soft in twist. Of a grid with random
/// diagonals, 1 in 16 inner vertices has four edges.
const MANY: f64 = 0.1;

impl System {
    /// The place of the first shell with many inner vertices that do not resist twist, and their part.
    pub(crate) fn shell_without_twist(&self) -> Option<(usize, f64)> {
        let kinds = self.bodies.kinds.iter().enumerate();
        let shells = kinds.filter(|(_, kind)| **kind == "shell");
        let mut parts = shells.map(|(body, _)| {
            let range = &self.bodies.ranges[body];
            let faces = self.geometry.mesh.faces().iter();
            let faces: Vec<[u32; 3]> = faces.filter(|face| range.contains(&face[0])).copied().collect();
            (body, incomplete_part(&self.start, &faces))
        });
        parts.find(|(_, part)| *part > MANY)
    }
}
