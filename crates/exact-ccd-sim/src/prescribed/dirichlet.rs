//! The Dirichlet targets of scripted vertices in one part of a time step.

use std::collections::BTreeMap;
use std::ops::Range;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::paths::Paths;
use super::vertices::Axes;

/// The scripts of a body in one time step, which all vertices follow by one fraction, from 0 to 1: a body
/// that is moved as a whole stays rigid, also where an obstruction stops it.
#[derive(Clone, Debug)]
struct Motion {
    /// The body, by its place in the list of bodies.
    body: u32,
    /// The fraction that the vertices have reached.
    fraction: f64,
    targets: Vec<Target>,
}

/// A vertex with a held coordinate that moves.
#[derive(Clone, Copy, Debug)]
struct Target {
    vertex: usize,
    held: Axes,
    /// The vector from the scripted position at the fraction 0 to the position at the start.
    apart: Vector3<f64>,
}

impl Motion {
    /// The motion of some vertices of a body. `held` are the coordinates that are not free in this time step.
    /// `None` if no held coordinate moves.
    fn new(body: u32, vertices: impl Iterator<Item = u32>, held: &[Axes], paths: &Paths<'_>) -> Option<Self> {
        let target = |vertex: u32| {
            let vertex = vertex as usize;
            let point = Vector3::from(paths.state.positions[vertex]);
            let end = Vector3::from(paths.position(vertex, 1.0));
            let moves = (0..3).any(|axis| held[vertex][axis] && end[axis] != point[axis]);
            moves.then(|| Target {
                vertex,
                held: held[vertex],
                apart: point - Vector3::from(paths.position(vertex, 0.0)),
            })
        };
        let targets: Vec<Target> = vertices.filter_map(target).collect();
        (!targets.is_empty()).then_some(Self {
            body,
            fraction: 0.0,
            targets,
        })
    }

    /// The fraction after a part of the rest.
    fn after(&self, part: f64) -> f64 {
        if part < 1.0 {
            self.fraction + part * (1.0 - self.fraction)
        } else {
            1.0
        }
    }

    /// Sets the held coordinates of the vertices to their values at a fraction.
    fn set(&self, points: &mut [Point], paths: &Paths<'_>, fraction: f64) {
        for target in &self.targets {
            let at = Vector3::from(paths.position(target.vertex, fraction)) + target.apart * (1.0 - fraction);
            for axis in (0..3).filter(|&axis| target.held[axis]) {
                points[target.vertex][axis] = at[axis];
            }
        }
    }
}

/// The motions that scripts prescribe in one part of a time step.
pub(crate) struct Dirichlet<'a> {
    paths: &'a Paths<'a>,
    motions: Vec<Motion>,
    mode: Mode,
    /// The number of times that the motions may still be repeated.
    attempts: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    /// The next step moves the bodies.
    Prescribed,
    /// The bodies rest until Newton's method has converged.
    Waiting,
    /// The bodies rest: they are at their targets, or an obstruction stops them.
    Fixed,
}

/// The greatest number of times that obstructed motions are repeated.
const ATTEMPTS: usize = 20;

/// The least part of a motion that counts as progress.
const PROGRESS: f64 = 1e-2;

impl<'a> Dirichlet<'a> {
    /// The motions along paths. `held` are the coordinates that are not free. Carried vertices follow their
    /// nodes.
    pub(crate) fn new(paths: &'a Paths<'a>, held: &[Axes]) -> Self {
        let is_unknown = |vertex: &u32| paths.system.carriers.of(*vertex).is_none();
        let bodies = (0..).zip(paths.system.body_vertices());
        let motion = |(body, vertices): (u32, &Range<u32>)| {
            Motion::new(body, vertices.clone().filter(is_unknown), held, paths)
        };
        let motions: Vec<Motion> = bodies.filter_map(motion).collect();
        let mode = if motions.is_empty() {
            Mode::Fixed
        } else {
            Mode::Prescribed
        };
        Self {
            paths,
            motions,
            mode,
            attempts: ATTEMPTS,
        }
    }

    /// Returns true if the next step moves the bodies.
    pub(crate) fn is_prescribed(&self) -> bool {
        self.mode == Mode::Prescribed
    }

    /// Returns true if all motions have reached their ends.
    fn has_arrived(&self) -> bool {
        self.motions.iter().all(|motion| motion.fraction == 1.0)
    }

    /// The places of all motions.
    pub(crate) fn places(&self) -> Vec<usize> {
        (0..self.motions.len()).collect()
    }

    /// The times in s by which the scripts of bodies are behind at the end, by the number of the body.
    pub(crate) fn behind(&self) -> BTreeMap<u32, f64> {
        let motions = self.motions.iter();
        let behind = motions.map(|motion| (motion.body, self.paths.behind(motion.body, motion.fraction)));
        behind.filter(|(_, behind)| *behind > 0.0).collect()
    }

    /// The fraction that a body has reached: 1 for a body without a motion.
    pub(crate) fn fraction(&self, body: u32) -> f64 {
        let motion = self.motions.iter().find(|motion| motion.body == body);
        motion.map_or(1.0, |motion| motion.fraction)
    }

    /// The vertices that the motions move, increasing.
    pub(crate) fn vertices(&self) -> Vec<u32> {
        let targets = self.motions.iter().flat_map(|motion| &motion.targets);
        targets.map(|target| target.vertex as u32).collect()
    }

    /// Sets the held coordinates to their values after a part of the rest of some motions, given by their
    /// places.
    pub(crate) fn set(&self, points: &mut [Point], places: &[usize], part: f64) {
        for motion in places.iter().map(|&place| &self.motions[place]) {
            motion.set(points, self.paths, motion.after(part));
        }
    }

    /// The displacements by which the next step moves the held coordinates from these positions.
    pub(crate) fn displacements(&self, points: &[Point]) -> Vec<Vector3<f64>> {
        if self.is_prescribed() {
            self.to_targets(points)
        } else {
            vec![Vector3::zeros(); points.len()]
        }
    }

    /// Moves the fractions of some motions, by their places, by a part of the rest.
    pub(crate) fn advance(&mut self, places: &[usize], part: f64) {
        for &place in places {
            self.motions[place].fraction = self.motions[place].after(part);
        }
    }

    /// Ends a step that moved bodies by these parts of their motions: the next one moves them again, or
    /// follows after Newton's method has converged. Without progress, bodies stay, unless all surfaces
    /// were apart before: a body that begins just outside the contact distance moves up to the other one
    /// first, which it pushes only from then on.
    pub(crate) fn moved(&mut self, progress: f64, was_apart: bool) {
        self.attempts = self.attempts.saturating_sub(1);
        let is_stopped = progress < PROGRESS && !was_apart;
        self.mode = if self.has_arrived() || self.attempts == 0 || is_stopped {
            Mode::Fixed
        } else {
            Mode::Waiting
        };
    }

    /// Makes the next step move the bodies again, after Newton's method has converged. False if they stay.
    pub(crate) fn resume(&mut self) -> bool {
        let waits = self.mode == Mode::Waiting;
        if waits {
            self.mode = Mode::Prescribed;
        }
        waits
    }

    /// The greatest distance of a vertex from its target, in m.
    pub(crate) fn lag(&self, points: &[Point]) -> f64 {
        let lags = self.to_targets(points).into_iter().map(|lag| lag.norm());
        lags.fold(0.0, f64::max)
    }

    /// The displacements from these positions to the targets: zero for all coordinates without a target.
    fn to_targets(&self, points: &[Point]) -> Vec<Vector3<f64>> {
        let mut ends = points.to_vec();
        for motion in &self.motions {
            motion.set(&mut ends, self.paths, 1.0);
        }
        let pairs = ends.iter().zip(points);
        pairs
            .map(|(end, point)| Vector3::from(*end) - Vector3::from(*point))
            .collect()
    }
}
