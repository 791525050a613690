//! Repair of a recording: from frame to frame, the straight motion is free.

use std::sync::Arc;

use exact_ccd_mesh::vector::minus;
use exact_ccd_mesh::{FreeStepOptions, FreeSteps, Intersection, Options, Pair, Point, TriangleMesh};

use crate::change::Change;
use crate::error::RepairError;
use crate::near::near_pairs;
use crate::options::RepairOptions;
use crate::outcome::Outcome;
use crate::problem::{Problem, moved};
use crate::progress::{Phase, Progress};
use crate::repair::repair;
use crate::size::Size;
use crate::slide::slide;

/// A recording whose motion is free, as far as it could be repaired.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Recording {
    /// The positions of the frames, from the first one on: all frames, or those before `blocked`. No frame
    /// intersects, and no pair comes within the minimum distance in the straight motion from one frame to the
    /// next. This was decided exactly, for the positions as they are.
    pub frames: Vec<Vec<Point>>,
    /// The change of each of these frames.
    pub changes: Vec<Change>,
    /// The frame for which no free positions were found, if there is one. Without it, fewer frames than given
    /// are there if the caller has stopped the repair.
    pub blocked: Option<Blocked>,
}

/// A frame for which the method found no free positions, or no free motion that leads there. There may be
/// some: this is not decided.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Blocked {
    /// The frame, from 0.
    pub frame: usize,
    /// For the first frame, the edges that still pass through faces.
    pub crossings: Vec<Intersection>,
    /// The pairs that touch, or come within the minimum distance: for the first frame at rest, for another
    /// one in the last motion that was tried, in which the pinned vertices touch the others.
    pub contacts: Vec<Pair>,
}

/// The fraction of a free step that is kept.
const KEEP: f64 = 0.7;

/// The factor by which displacements fade from frame to frame, and their smoothing.
const FADING: f64 = 0.8;
const SMOOTHING: f64 = 2.0;

/// The distance beyond the minimum distance at which a pair is near, relative to the mean length of edges.
const NEAR: f64 = 0.1;

/// The factor by which a small gap of a near pair has to grow: otherwise gaps would shrink from frame to
/// frame.
const KEPT: f64 = 2.0;

/// The attempts to reach a frame without contact between pinned vertices and others: in how many steps, and
/// the part of the way that the others go in each. In shorter steps, near pairs are known better.
const ATTEMPTS: [(u32, f64); 8] = [
    (1, 1.0),
    (1, 0.5),
    (1, 0.1),
    (1, 0.0),
    (4, 0.1),
    (4, 0.0),
    (16, 0.02),
    (16, 0.0),
];

/// The number of attempts to come nearer to a frame.
const ROUNDS: usize = 4;

/// Moves vertices of all frames until no frame intersects and the straight motion between frames is free of
/// contact, within the minimum distance of the options.
///
/// The first frame is repaired by [`repair`]. Each frame that follows is reached from the repaired one
/// before: by one certified step towards the given frame, with the displacement of the frame before, smoothed
/// and faded. So the displacement changes little from frame to frame. Pinned vertices have their given
/// positions in all frames. If they touch others in each motion that is tried, the recording ends before that
/// frame, and the pairs are named: see [`Blocked`].
///
/// # Errors
/// As of [`repair`]: also for the positions of the frames that follow.
pub fn repair_recording(
    mesh: &Arc<TriangleMesh>,
    frames: &[Vec<Point>],
    options: &RepairOptions<'_>,
) -> Result<Recording, RepairError> {
    let mut recording = Recording {
        frames: Vec::with_capacity(frames.len()),
        changes: Vec::with_capacity(frames.len()),
        blocked: None,
    };
    for (frame, given) in frames.iter().enumerate() {
        let progress = Progress {
            phase: Phase::Follow,
            round: frame,
            pairs: 0,
        };
        if options.stop.is_some_and(|stop| stop(progress)) {
            break;
        }
        let reached = match recording.frames.last() {
            None => match repair(mesh, given, options)? {
                Outcome::Repaired(first) => Ok(first.positions),
                Outcome::Unrepaired(first) => Err((first.crossings, first.contacts)),
            },
            Some(before) => next(mesh, [&frames[frame - 1], given], before, options)?
                .map_err(|contacts| (Vec::new(), contacts)),
        };
        match reached {
            Ok(positions) => {
                let change = Change::new(mesh, &Size::new(mesh, given), given, &positions);
                recording.changes.push(change);
                recording.frames.push(positions);
            }
            Err((crossings, contacts)) => {
                recording.blocked = Some(Blocked {
                    frame,
                    crossings,
                    contacts,
                });
                break;
            }
        }
    }
    Ok(recording)
}

/// The positions to which the straight motion from `before` is free, near the second given frame; or the
/// pairs that touch in the last motion that was tried.
fn next(
    mesh: &Arc<TriangleMesh>,
    [last, given]: [&[Point]; 2],
    before: &[Point],
    options: &RepairOptions<'_>,
) -> Result<Result<Vec<Point>, Vec<Pair>>, RepairError> {
    let problem = Problem::new(mesh, given, options)?;
    let smoothing = problem.smoothing(SMOOTHING)?;
    let away: Vec<Point> = before.iter().zip(last).map(|(&a, &b)| minus(a, b)).collect();
    let faded = problem.unknowns.solve(&smoothing, &away, |_| [0.0; 3]);
    let target = moved(given, &faded, FADING);
    let mut way = Way {
        problem,
        before,
        target,
        options: FreeStepOptions::default()
            .with_keep(KEEP)
            .with_min_distance(options.min_distance),
    };
    let mut blocked = Vec::new();
    for (parts, follows) in ATTEMPTS {
        let mut x = before.to_vec();
        for part in 1..=parts {
            let place = f64::from(part) / f64::from(parts);
            let step = way.towards(&x, place, follows)?;
            if !step.blocked.is_empty() {
                blocked = step.blocked;
                break;
            }
            x = step.positions;
            if part == parts && (parts == 1 || way.is_free_to(&x)?) {
                return way.nearer(x).map(Ok);
            }
        }
    }
    Ok(Err(blocked))
}

/// The way from one frame to the next.
struct Way<'a> {
    problem: Problem<'a>,
    /// The repaired positions of the frame before.
    before: &'a [Point],
    /// The wanted positions.
    target: Vec<Point>,
    options: FreeStepOptions<'a>,
}

impl Way<'_> {
    /// A certified step from positions `x`. Pinned vertices go to their places at the part `place` of the
    /// way between the frames. The others go by the part `follows` of the way to their targets.
    fn towards(&mut self, x: &[Point], place: f64, follows: f64) -> Result<FreeSteps, RepairError> {
        let problem = &mut self.problem;
        let (given, before) = (problem.given, self.before);
        // At the end of the way, the bits are the given ones.
        let pinned = |vertex: usize| {
            if place >= 1.0 {
                given[vertex]
            } else {
                [0, 1, 2].map(|axis: usize| {
                    before[vertex][axis] + place * (given[vertex][axis] - before[vertex][axis])
                })
            }
        };
        let end = |(vertex, (&target, &x)): (usize, (&Point, &Point))| {
            if problem.unknowns.is_pinned(vertex) {
                minus(pinned(vertex), x)
            } else {
                minus(target, x).map(|c| follows * c)
            }
        };
        let mut displacements: Vec<Point> = self.target.iter().zip(x).enumerate().map(end).collect();
        let parts = displacements.as_flattened().iter();
        let most = parts.fold(0.0_f64, |most, part| most.max(part.abs()));
        let edge = problem.size.mean_edge;
        let distance = problem.options.min_distance.get() + NEAR * edge + 2.0 * most.min(edge);
        slide(
            problem,
            &near_pairs(problem, x, distance)?,
            KEPT,
            &mut displacements,
        );
        let mut end = moved(x, &displacements, 1.0);
        for &vertex in &problem.options.pinned {
            end[vertex as usize] = pinned(vertex as usize);
        }
        let fixed = &problem.options.pinned;
        Ok(problem.detector.free_steps(x, &end, fixed, &self.options)?)
    }

    /// Returns true if the straight motion from the frame before is free.
    fn is_free_to(&mut self, x: &[Point]) -> Result<bool, RepairError> {
        let within = Options::within(self.problem.options.min_distance);
        Ok(!self.problem.detector.collides(self.before, x, within)?)
    }

    /// Positions nearer to the target, to which the straight motion from the frame before is free, too.
    fn nearer(mut self, mut x: Vec<Point>) -> Result<Vec<Point>, RepairError> {
        for _ in 0..ROUNDS {
            let step = self.towards(&x, 1.0, 1.0)?;
            if !step.blocked.is_empty() || !self.is_free_to(&step.positions)? {
                break;
            }
            x = step.positions;
        }
        Ok(x)
    }
}
