//! The Dirichlet targets of scripted vertices in one time step.

use std::sync::Arc;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use crate::script::Script;
use crate::solver::Spring;
use crate::system::System;

/// The scripted vertices that move in this time step, with their targets.
///
/// The vertices are set to their targets at once, if the line search accepts that step. Otherwise they
/// become unknowns, and springs of increasing stiffness draw them towards their targets, as in section 4.4
/// of *Incremental Potential Contact*, until the step is accepted.
#[derive(Clone, Debug)]
pub(crate) struct Dirichlet {
    targets: Vec<(u32, Point)>,
    mode: Mode,
    /// The stiffness of the springs, in kg.
    stiffness: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    /// The next step sets the vertices to their targets.
    Prescribed,
    /// Springs act on the vertices.
    Springs,
    /// The vertices stay: they are at their targets, or the springs have reached their greatest stiffness.
    Fixed,
}

/// The initial and the greatest stiffness of the springs, in mean masses of a vertex.
const STIFFNESS: [f64; 2] = [1e3, 1e9];

/// The factor by which the stiffness increases when the targets cannot be reached.
const STIFFENING: f64 = 10.0;

impl Dirichlet {
    /// The targets of a system's scripts at a time (in s), for vertices that are at `points` before the step.
    pub(crate) fn new(system: &System, points: &[Point], time: f64) -> Self {
        let target = |(vertex, script): (usize, &Option<Arc<Script>>)| {
            let target = script.as_ref()?.position(system.start[vertex], time);
            (target != points[vertex]).then_some((vertex as u32, target))
        };
        let targets: Vec<(u32, Point)> = system.scripts.iter().enumerate().filter_map(target).collect();
        let mode = if targets.is_empty() {
            Mode::Fixed
        } else {
            Mode::Prescribed
        };
        Self {
            targets,
            mode,
            stiffness: 0.0,
        }
    }

    /// True if the next step sets the vertices to their targets.
    pub(crate) fn is_prescribed(&self) -> bool {
        self.mode == Mode::Prescribed
    }

    /// True if springs act on the vertices, which are unknowns then.
    pub(crate) fn has_springs(&self) -> bool {
        self.mode == Mode::Springs
    }

    /// The moving vertices with their targets.
    pub(crate) fn targets(&self) -> &[(u32, Point)] {
        &self.targets
    }

    /// The springs that act now.
    pub(crate) fn springs(&self) -> Vec<Spring> {
        let spring = |&(vertex, target): &(u32, Point)| Spring {
            vertex,
            target,
            stiffness: self.stiffness,
        };
        if self.has_springs() {
            self.targets.iter().map(spring).collect()
        } else {
            Vec::new()
        }
    }

    /// Ends the motion: the vertices are at their targets.
    pub(crate) fn reached(&mut self) {
        self.mode = Mode::Fixed;
    }

    /// Replaces a rejected step to the targets by springs, or stiffens the springs. Beyond the greatest
    /// stiffness, the vertices stay where they are.
    pub(crate) fn stiffen(&mut self, system: &System) {
        let mass = system.mean_mass();
        let [first, last] = STIFFNESS.map(|masses| masses * mass);
        let stiffer = STIFFENING * self.stiffness;
        self.mode = if stiffer > last {
            Mode::Fixed
        } else {
            Mode::Springs
        };
        self.stiffness = stiffer.max(first);
    }

    /// Makes the next step set the vertices to their targets again, after Newton has converged with springs.
    pub(crate) fn prescribe(&mut self) {
        self.mode = Mode::Prescribed;
    }

    /// The greatest distance of a vertex from its target, in m.
    pub(crate) fn lag(&self, points: &[Point]) -> f64 {
        self.targets.iter().fold(0.0, |lag, &(vertex, target)| {
            lag.max((Vector3::from(points[vertex as usize]) - Vector3::from(target)).norm())
        })
    }
}
