//! The search for the first time within a distance, by chords.

use exact_ccd::{Options, Separation};

use crate::answer::{Answer, End, Within};
use crate::error::SearchError;
use crate::kind::CurvedKind;
use crate::options::SearchOptions;
use crate::straight::Straight;
use crate::trajectory::Trajectory;

/// The length of a chord in units of the one before it, if that was free.
const GROWTH: f64 = 2.0;

/// The least tolerance of times: above the rounding of the bounds of a time.
const RESOLUTION: f64 = 4.0 * f64::EPSILON;

/// The shortest chord that is cut.
const SHORTEST: f64 = f64::EPSILON / 2.0;

/// Certain bounds of the first time at which two curved primitives are at most d apart, for the separation d
/// of the options. d = 0 is contact.
///
/// `trajectories` are the paths of the points, in the order of the kind: four for
/// [`VertexFace`](exact_ccd::VertexFace) and [`EdgeEdge`](exact_ccd::EdgeEdge), three for
/// [`VertexEdge`](exact_ccd::VertexEdge), two for [`VertexVertex`](exact_ccd::VertexVertex). They may be of
/// different types behind `&dyn Trajectory`. The last time that counts ends the step.
///
/// The step is cut into chords where that is needed. Δ is a bound of the deviation of both primitives. A
/// chord that comes within d + Δ is not certainly free. A chord that comes within d + ε − Δ proves that the
/// primitives come within d + ε. For contact, chords that pass through each other by more than Δ are a proof
/// too.
///
/// If the motion is straight, and without error at both ends, this is one exact query.
///
/// # Errors
/// [`SearchError`] names a position that is not finite, a bound that is not valid, the tolerance, or a last
/// time that is not in [0, 1].
///
/// ```
/// use exact_ccd::{CONTACT, VertexFace};
/// use exact_ccd_curved::{End, Polynomial, SearchOptions, Trajectory, time_of_impact};
///
/// // A ball falls from the height 1 with the acceleration −4: it meets the floor at t = 1 / √2.
/// let ball = Polynomial::new([[1.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, -1.0]]);
/// let floor = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]].map(|corner| Polynomial::new([corner]));
/// let points: [&dyn Trajectory; 4] = [&ball, &floor[0], &floor[1], &floor[2]];
///
/// let options = SearchOptions::default().with_time_tolerance(1e-9);
/// let answer = time_of_impact::<VertexFace, _>(&points, CONTACT, &options)?;
/// let by = answer.within.expect("they meet").by;
/// assert_eq!(answer.end, End::Tolerance);
/// assert!(answer.free_until <= 0.5_f64.sqrt() && 0.5_f64.sqrt() <= by && by - answer.free_until <= 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn time_of_impact<K: CurvedKind, T: Trajectory>(
    trajectories: &K::Trajectories<T>,
    options: impl Into<Options>,
    search_options: &SearchOptions,
) -> Result<Answer, SearchError> {
    let Options { separation, until } = options.into();
    search_options.check(until)?;
    search::<K, _>(trajectories.as_ref(), separation, search_options, [0.0, until])
}

/// The search in an interval of times, before which all is free.
pub(crate) fn search<K: CurvedKind, T: Trajectory>(
    trajectories: &[T],
    d: Separation,
    options: &SearchOptions,
    [start, mut limit]: [f64; 2],
) -> Result<Answer, SearchError> {
    let mut answer = Answer::initial(start);
    let tolerance = options.time_tolerance.max(RESOLUTION);
    let is_reached = |answer: &Answer| {
        let within = answer.within;
        within.is_some_and(|within| within.by - answer.free_until <= tolerance)
    };
    // Times after `limit` do not matter. It is the end at first, then a time of proved proximity.
    let mut end = limit;
    loop {
        let start = answer.free_until;
        if is_reached(&answer) {
            answer.end = End::Tolerance;
            return Ok(answer);
        }
        if answer.chords >= options.chord_limit {
            answer.end = End::ChordLimit;
            return Ok(answer);
        }
        answer.chords += 1;
        let straight = Straight::<K>::of(trajectories, start, end)?;
        let Some(free_until) = straight.free_until(d) else {
            answer.free_until = end;
            if end >= limit {
                break;
            }
            end = limit.min(end + GROWTH * (end - start));
            continue;
        };
        answer.free_until = free_until;
        let within = match straight.proximity(d, options.distance_tolerance) {
            None if answer.chords < options.chord_limit => {
                answer.chords += 1;
                around::<K, _>(trajectories, free_until, end)?.proximity(d, options.distance_tolerance)
            }
            within => within,
        };
        if let Some(within) = within {
            let by = within.by.max(free_until);
            if answer.within.is_none_or(|known| by < known.by) {
                answer.within = Some(Within { by, ..within });
            }
            limit = limit.min(by);
        }
        if end - free_until <= SHORTEST && !is_reached(&answer) {
            answer.end = End::Precision;
            return Ok(answer);
        }
        end = limit.min(straight.cut(d, free_until));
    }
    // Proximity that was proved only for times after the end is left to the search there.
    answer.within = answer.within.filter(|within| within.by <= limit);
    if answer.within.is_some() {
        answer.end = End::Tolerance;
    }
    Ok(answer)
}

/// The chord from before the start to after the end of an interval: contact in the interval is not at an
/// end of the chord, where it could not be proved.
fn around<K: CurvedKind, T: Trajectory>(
    trajectories: &[T],
    start: f64,
    end: f64,
) -> Result<Straight<K>, SearchError> {
    let margin = (end - start).max(RESOLUTION);
    Straight::of(trajectories, (start - margin).max(0.0), (end + margin).min(1.0))
}
