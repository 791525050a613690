//! The positions of vertices where their scripts began.

use std::collections::BTreeMap;

use exact_ccd_mesh::Point;

use super::System;

impl System {
    /// The origins of scripts at the end of a time step in which vertices start from `positions`: those
    /// before, and those of the scripts that begin between two times, in s. A vertex without an entry has
    /// its start as the origin of all its scripts.
    pub(crate) fn origins(
        &self,
        before: &BTreeMap<u32, [Point; 3]>,
        positions: &[Point],
        times: [f64; 2],
    ) -> BTreeMap<u32, [Point; 3]> {
        let mut origins = before.clone();
        for (vertex, scripts) in self.scripts.iter().enumerate() {
            let begins = scripts.beginning(times);
            let then = self.origins_of(before, vertex);
            let mut now = then;
            for axis in (0..3).filter(|&axis| begins[axis]) {
                now[axis] = positions[vertex];
            }
            if now != then {
                origins.insert(vertex as u32, now);
            }
        }
        origins
    }

    /// For each axis, the position of a vertex where its script began.
    pub(crate) fn origins_of(&self, origins: &BTreeMap<u32, [Point; 3]>, vertex: usize) -> [Point; 3] {
        let start = [self.start[vertex]; 3];
        origins.get(&(vertex as u32)).copied().unwrap_or(start)
    }
}
