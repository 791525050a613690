//! Repair of a recording: from frame to frame, the straight motion is free.

use std::sync::Arc;

use exact_ccd_mesh::vector::minus;
use exact_ccd_mesh::{FreeStepOptions, Intersection, Options, Pair, Point, TriangleMesh};

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

/// The parts of the way that are tried if pinned vertices touch others on all of it.
const LESS: [f64; 3] = [0.5, 0.1, 0.0];

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
    let mut problem = Problem::new(mesh, given, options)?;
    let smoothing = problem.smoothing(SMOOTHING)?;
    let away: Vec<Point> = before.iter().zip(last).map(|(&a, &b)| minus(a, b)).collect();
    let faded = problem.unknowns.solve(&smoothing, &away, |_| [0.0; 3]);
    let target = moved(given, &faded, FADING);
    let step_options = FreeStepOptions::default()
        .with_keep(KEEP)
        .with_min_distance(options.min_distance);
    let towards = |problem: &mut Problem<'_>, x: &[Point], part: f64| {
        let end = |(vertex, (&target, &x)): (usize, (&Point, &Point))| {
            let away = minus(target, x);
            if problem.unknowns.is_pinned(vertex) {
                minus(given[vertex], x)
            } else {
                away.map(|c| part * c)
            }
        };
        let mut displacements: Vec<Point> = target.iter().zip(x).enumerate().map(end).collect();
        let parts = displacements.as_flattened().iter();
        let most = parts.fold(0.0_f64, |most, part| most.max(part.abs()));
        let edge = problem.size.mean_edge;
        let distance = options.min_distance.get() + NEAR * edge + 2.0 * most.min(edge);
        slide(
            problem,
            &near_pairs(problem, x, distance)?,
            KEPT,
            &mut displacements,
        );
        let mut end = moved(x, &displacements, 1.0);
        for &vertex in &options.pinned {
            end[vertex as usize] = given[vertex as usize];
        }
        Ok::<_, RepairError>(
            problem
                .detector
                .free_steps(x, &end, &options.pinned, &step_options)?,
        )
    };
    let mut step = towards(&mut problem, before, 1.0)?;
    for part in LESS {
        if step.blocked.is_empty() {
            break;
        }
        step = towards(&mut problem, before, part)?;
    }
    if !step.blocked.is_empty() {
        return Ok(Err(step.blocked));
    }
    let mut reached = step.positions;
    for _ in 0..ROUNDS {
        let step = towards(&mut problem, &reached, 1.0)?;
        let within = Options::within(options.min_distance);
        if !step.blocked.is_empty() || problem.detector.collides(before, &step.positions, within)? {
            break;
        }
        reached = step.positions;
    }
    Ok(Ok(reached))
}
