//! The positions of vertices where their scripts began.

use std::collections::BTreeMap;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::System;

impl System {
    /// The origins of scripts at the end of a time step in which vertices start from `positions`, at the time
    /// `start`: those before, and those of the scripts that begin between two times, all in s. A vertex
    /// without an entry has its start as the origin of all its scripts.
    ///
    /// Where a script begins within the time step, the origin is the position to which the earlier script
    /// moves the vertex until then. A coordinate that is free has the position at the start of the time step.
    pub(crate) fn origins(
        &self,
        before: &BTreeMap<u32, [Point; 3]>,
        positions: &[Point],
        start: f64,
        times: [f64; 2],
    ) -> BTreeMap<u32, [Point; 3]> {
        let mut origins = before.clone();
        for (vertex, scripts) in self.scripts.iter().enumerate() {
            let begins = scripts.beginning(times);
            if begins == [None; 3] {
                continue;
            }
            let then = self.origins_of(before, vertex);
            let earlier = |time: f64| Vector3::from(scripts.position(&then, times[0], time));
            let mut now = then;
            for (origin, from) in now.iter_mut().zip(begins) {
                if let Some(from) = from {
                    let moved = earlier(from.max(start)) - earlier(start);
                    *origin = (Vector3::from(positions[vertex]) + moved).into();
                }
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
