//! The Dirichlet targets of scripted vertices in one time step.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use crate::anchor::Anchor;
use crate::scripted::Axes;
use crate::system::System;

/// The scripted vertices that move in this time step, with their targets.
///
/// The vertices are set to their targets at once, if the line search accepts that step. Otherwise they
/// become unknowns, and springs of increasing stiffness draw them towards their targets, as in section 4.4
/// of *Incremental Potential Contact*, until the step is accepted.
#[derive(Clone, Debug)]
pub(crate) struct Dirichlet {
    targets: Vec<Target>,
    mode: Mode,
    /// The stiffness of the springs, in kg.
    stiffness: f64,
}

/// The target of a vertex of which a held coordinate moves.
#[derive(Clone, Copy, Debug)]
struct Target {
    vertex: u32,
    /// The target of the held coordinates.
    at: Point,
    held: Axes,
}

impl Target {
    /// The vector to the target from the positions, along the held axes.
    fn offset(&self, points: &[Point]) -> Vector3<f64> {
        let point = points[self.vertex as usize];
        Vector3::from_fn(|axis, _| {
            if self.held[axis] {
                self.at[axis] - point[axis]
            } else {
                0.0
            }
        })
    }
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
    /// The targets of a system's scripts for vertices that are at `points` before the step. `held` are the
    /// coordinates that are not free in this time step, and `target` is the position of a vertex at its end.
    pub(crate) fn new(held: &[Axes], points: &[Point], target: impl Fn(usize) -> Point) -> Self {
        let moving = |(vertex, &held): (usize, &Axes)| {
            if held == [false; 3] {
                return None;
            }
            let target = Target {
                vertex: vertex as u32,
                at: target(vertex),
                held,
            };
            (target.offset(points) != Vector3::zeros()).then_some(target)
        };
        let targets: Vec<Target> = held.iter().enumerate().filter_map(moving).collect();
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

    /// The coordinates of each vertex that are not unknown now: the held ones, except those with springs.
    pub(crate) fn known(&self, held: &[Axes]) -> Vec<Axes> {
        let mut known = held.to_vec();
        if self.has_springs() {
            for target in &self.targets {
                known[target.vertex as usize] = [false; 3];
            }
        }
        known
    }

    /// Sets the held coordinates of the moving vertices to their targets.
    pub(crate) fn set(&self, points: &mut [Point]) {
        for target in &self.targets {
            for axis in (0..3).filter(|&axis| target.held[axis]) {
                points[target.vertex as usize][axis] = target.at[axis];
            }
        }
    }

    /// The displacements from these positions to the targets: zero for all coordinates without a target, and
    /// if the next step does not set the vertices to their targets.
    pub(crate) fn displacements(&self, points: &[Point]) -> Vec<Vector3<f64>> {
        let mut displacements = vec![Vector3::zeros(); points.len()];
        if self.is_prescribed() {
            for target in &self.targets {
                displacements[target.vertex as usize] = target.offset(points);
            }
        }
        displacements
    }

    /// The springs that act now.
    pub(crate) fn penalties(&self) -> Vec<Anchor> {
        let along = |is_held| if is_held { self.stiffness } else { 0.0 };
        let spring = |target: &Target| Anchor {
            vertex: target.vertex,
            target: target.at,
            stiffness: target.held.map(along).into(),
            force: Vector3::zeros(),
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
        let lags = self.targets.iter().map(|target| target.offset(points).norm());
        lags.fold(0.0, f64::max)
    }
}
