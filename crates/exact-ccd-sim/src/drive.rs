//! Scripted vertices in one time step.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use crate::solver::Spring;
use crate::system::System;

/// The vertices that a script moves in this step, and how they get there.
///
/// They are put where they should be at once, if nothing is in the way. Otherwise springs pull them, ever stronger, as in
/// section 4.4 of *Incremental Potential Contact*, until they can be.
#[derive(Clone, Debug)]
pub(crate) struct Drive {
    targets: Vec<(u32, Point)>,
    mode: Mode,
    /// The stiffness of springs, in kg.
    stiffness: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    Put,
    Pull,
    Done,
}

/// The first stiffness of springs, and the last, in masses of a vertex.
const STIFFNESS: [f64; 2] = [1e3, 1e9];

/// How much stiffer springs get when those there are pull no nearer.
const STIFFER: f64 = 10.0;

impl Drive {
    /// The scripts of a system at a time (in s), for vertices that are at `points` now.
    pub(crate) fn new(system: &System, points: &[Point], time: f64) -> Self {
        let target = |(vertex, script): (usize, &Option<crate::script::Script>)| {
            let target = script.as_ref()?.position(system.start[vertex], time);
            (target != points[vertex]).then_some((vertex as u32, target))
        };
        let targets: Vec<(u32, Point)> = system.scripts.iter().enumerate().filter_map(target).collect();
        let mode = if targets.is_empty() { Mode::Done } else { Mode::Put };
        Self {
            targets,
            mode,
            stiffness: 0.0,
        }
    }

    /// Whether the vertices are to be put to their targets now.
    pub(crate) fn is_putting(&self) -> bool {
        self.mode == Mode::Put
    }

    /// Whether the vertices are to be pulled now: they are unknowns then.
    pub(crate) fn is_pulling(&self) -> bool {
        self.mode == Mode::Pull
    }

    /// The vertices that are to be moved.
    pub(crate) fn targets(&self) -> &[(u32, Point)] {
        &self.targets
    }

    /// The springs, if they pull.
    pub(crate) fn springs(&self) -> Vec<Spring> {
        let spring = |&(vertex, target): &(u32, Point)| Spring {
            vertex,
            target,
            stiffness: self.stiffness,
        };
        if self.is_pulling() {
            self.targets.iter().map(spring).collect()
        } else {
            Vec::new()
        }
    }

    /// The vertices have been put to their targets.
    pub(crate) fn arrived(&mut self) {
        self.mode = Mode::Done;
    }

    /// Something is in the way: pull, or pull harder. If springs are as stiff as they get, the vertices stay.
    pub(crate) fn pull(&mut self, system: &System) {
        let mass = system.mean_mass();
        let [first, last] = STIFFNESS.map(|masses| masses * mass);
        let stiffer = STIFFER * self.stiffness;
        self.mode = if stiffer > last { Mode::Done } else { Mode::Pull };
        self.stiffness = stiffer.max(first);
    }

    /// The springs pull no nearer: try to put the vertices.
    pub(crate) fn put(&mut self) {
        self.mode = Mode::Put;
    }

    /// How far the farthest vertex is from its target, in m.
    pub(crate) fn lag(&self, points: &[Point]) -> f64 {
        self.targets.iter().fold(0.0, |lag, &(vertex, target)| {
            lag.max((Vector3::from(points[vertex as usize]) - Vector3::from(target)).norm())
        })
    }
}
