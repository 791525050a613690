//! A step of a mesh whose vertices move on curves.

use exact_ccd::Options;
use exact_ccd_mesh::TriangleMesh;

use crate::answer::Answer;
use crate::interval::Interval;
use crate::step_answer::{CurvedStep, CurvedStepError, CurvedStepOptions};
use crate::trajectory::Trajectory;

/// Certain bounds of the first time at which two primitives of a mesh are at most d apart, for the
/// separation d of the options. The vertices move on curves.
///
/// The step is cut into intervals of time in which the deviations are small compared with the motion. In
/// each, every vertex moves along its chord and is as thick as its deviation and d / 2. The pairs that come
/// within the sum of their thicknesses are searched as by [`time_of_impact`](crate::time_of_impact), those
/// with the earliest chords first, until no other can be earlier. Primitives that share a vertex are left
/// out. The result does not depend on the number of threads.
///
/// # Errors
/// [`CurvedStepError`], if the trajectories are not as many as the vertices, if a position is not finite,
/// or if a bound, the tolerance or the last time that counts is not valid.
pub fn curved_step<T: Trajectory + Sync>(
    mesh: &TriangleMesh,
    trajectories: &[T],
    options: impl Into<Options>,
    step_options: &CurvedStepOptions,
) -> Result<CurvedStep, CurvedStepError> {
    let Options { separation, until } = options.into();
    step_options.search.check(until)?;
    let mut step = CurvedStep {
        pair: None,
        answer: Answer::initial(0.0),
        intervals: 0,
        candidates: 0,
    };
    let mut ends = vec![until];
    while let (Some(&end), None) = (ends.last(), step.pair) {
        let start = step.answer.free_until;
        let interval = Interval::new(mesh, trajectories, start, end)?;
        if interval.is_coarse() {
            ends.push(start + 0.5 * (end - start));
            continue;
        }
        ends.pop();
        step.intervals += 1;
        interval.advance(separation, step_options, &mut step)?;
    }
    Ok(step)
}
