//! The positions of scripted vertices in one part of a time step.

use std::collections::BTreeMap;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::times::Times;
use crate::state::State;
use crate::system::System;

/// The paths of the vertices of a system by their scripts, from a state on.
pub(crate) struct Paths<'a> {
    pub(crate) system: &'a System,
    /// The state at the start of the part.
    pub(crate) state: &'a State,
    pub(crate) times: Times,
    /// The origins of scripts at the end of the part.
    pub(crate) origins: Origins,
}

/// For each axis, the position of a vertex where its script began. A vertex without an entry has its start as
/// the origin of all its scripts.
type Origins = BTreeMap<u32, [Point; 3]>;

impl<'a> Paths<'a> {
    /// The paths in a part of a time step that begins with a state.
    ///
    /// Where a script begins within the part, its origin is the position to which the earlier script moves
    /// the vertex until then. A coordinate that is free has the position at the start of the part.
    pub(crate) fn new(system: &'a System, state: &'a State, times: Times) -> Self {
        let mut origins = state.origins.clone();
        let [before, _] = times.moments;
        for (vertex, scripts) in system.scripts.iter().enumerate() {
            let begins = scripts.beginning(times.moments);
            if begins == [None; 3] {
                continue;
            }
            let then = origins_of(system, &state.origins, vertex);
            let earlier = |time: f64| Vector3::from(scripts.position(&then, before, time));
            let mut now = then;
            for (origin, from) in now.iter_mut().zip(begins) {
                if let Some(from) = from {
                    let moved = earlier(from.max(times.start)) - earlier(times.start);
                    *origin = (Vector3::from(state.positions[vertex]) + moved).into();
                }
            }
            if now != then {
                origins.insert(vertex as u32, now);
            }
        }
        Self {
            system,
            state,
            times,
            origins,
        }
    }

    /// The position of a vertex at a fraction of the part.
    pub(super) fn position(&self, vertex: usize, fraction: f64) -> Point {
        let origins = origins_of(self.system, &self.origins, vertex);
        let [_, moment] = self.times.moments;
        self.system.scripts[vertex].position(&origins, moment, self.time(vertex, fraction))
    }

    /// The positions of a point apart from the origin of a vertex, at the start and at the end of the time in
    /// which scripts act: the earlier ones until others begin, and these from then to the fraction.
    pub(super) fn carried(
        &self,
        vertex: usize,
        apart: Vector3<f64>,
        fraction: f64,
        acting: Acting,
    ) -> [Point; 2] {
        let scripts = &self.system.scripts[vertex];
        let beginnings = scripts.beginning(self.times.moments).into_iter().flatten();
        let [first, last] = [0.0, fraction].map(|fraction| self.time(vertex, fraction));
        let begin = beginnings.fold(first, f64::max).min(last);
        let [before, moment] = self.times.moments;
        let (origins, moment, times) = match acting {
            Acting::Earlier => (&self.state.origins, before, [first, begin]),
            Acting::Later => (&self.origins, moment, [begin, last]),
        };
        let origins = origins_of(self.system, origins, vertex);
        let origins = origins.map(|origin| (Vector3::from(origin) + apart).into());
        times.map(|time| scripts.position(&origins, moment, time))
    }

    /// The time by which the scripts of a body are behind at the end, in s, if it has moved by a fraction.
    pub(super) fn behind(&self, body: u32, fraction: f64) -> f64 {
        (1.0 - fraction) * (self.times.end - self.times.start + self.behind_before(body))
    }

    /// The time that the scripts of a vertex have reached at a fraction, in s. They begin where an
    /// obstruction held the body back.
    fn time(&self, vertex: usize, fraction: f64) -> f64 {
        let Times { start, end, .. } = self.times;
        let behind = self.behind_before(self.system.bodies.of(vertex as u32) as u32);
        end - (1.0 - fraction) * (end - (start - behind))
    }

    fn behind_before(&self, body: u32) -> f64 {
        self.state.behind.get(&body).copied().unwrap_or(0.0)
    }
}

/// The scripts that act in a part of a time step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Acting {
    /// The scripts that began before the part.
    Earlier,
    /// The scripts that began last before its end.
    Later,
}

fn origins_of(system: &System, origins: &Origins, vertex: usize) -> [Point; 3] {
    let start = [system.start[vertex]; 3];
    origins.get(&(vertex as u32)).copied().unwrap_or(start)
}
