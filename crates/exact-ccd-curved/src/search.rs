//! The search for the first time within a distance, by chords.

use exact_ccd::separation::Separation;

use crate::answer::{Answer, End, Proximity, Within};
use crate::crossing;
use crate::error::SearchError;
use crate::kind::CurvedKind;
use crate::options::SearchOptions;
use crate::rounding::{add_up, flushes_subnormals};
use crate::straight::Straight;
use crate::trajectory::{Chord, Trajectory};

/// The shortest chord that is cut.
const SHORTEST: f64 = f64::EPSILON / 2.0;

/// The first time at which two curved primitives are at most d apart, between certain bounds.
///
/// `trajectories` are those of the points, in the order of the kind: four for
/// [`VertexFace`](exact_ccd::VertexFace) and [`EdgeEdge`](exact_ccd::EdgeEdge), three for
/// [`VertexEdge`](exact_ccd::VertexEdge), two for [`VertexVertex`](exact_ccd::VertexVertex). They may be
/// of different types behind `&dyn Trajectory`. d = 0 is contact.
///
/// The step is cut into chords where that is needed. The chords within d + Δ, Δ being a bound of the
/// deviation of both primitives, are not certainly free; those within d + ε − Δ certainly come within
/// d + ε. For contact, chords that pass through each other by more than Δ are a proof too.
///
/// If the motion is straight and without error, this is one exact query.
///
/// # Errors
/// [`SearchError`] names a position that is not finite, a bound that is not valid, or the tolerance.
///
/// ```
/// use exact_ccd::VertexFace;
/// use exact_ccd::separation::Separation;
/// use exact_ccd_curved::{End, Polynomial, SearchOptions, Trajectory, first_within};
///
/// // A ball falls from the height 1 with the acceleration −4: it meets the floor at t = 1 / √2.
/// let ball = Polynomial::new([[1.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, -1.0]]);
/// let floor = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]].map(|corner| Polynomial::new([corner]));
/// let points: [&dyn Trajectory; 4] = [&ball, &floor[0], &floor[1], &floor[2]];
///
/// let options = SearchOptions::default().with_time_tolerance(1e-9);
/// let answer = first_within::<VertexFace, _>(&points, Separation::new(0.0)?, &options)?;
/// let by = answer.within.expect("they meet").by;
/// assert_eq!(answer.end, End::Tolerance);
/// assert!(answer.free_until <= 0.5_f64.sqrt() && 0.5_f64.sqrt() <= by && by - answer.free_until <= 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn first_within<K: CurvedKind, T: Trajectory>(
    trajectories: &K::Trajectories<T>,
    d: Separation,
    options: &SearchOptions,
) -> Result<Answer, SearchError> {
    options.check()?;
    if flushes_subnormals() {
        return Err(SearchError::FlushedSubnormals);
    }
    search::<K, _>(trajectories.as_ref(), d, options, [0.0, 1.0])
}

/// The search in an interval of times that begins at the given time: before, all is free.
pub(crate) fn search<K: CurvedKind, T: Trajectory>(
    trajectories: &[T],
    d: Separation,
    options: &SearchOptions,
    [start, end]: [f64; 2],
) -> Result<Answer, SearchError> {
    let mut answer = Answer {
        free_until: start,
        within: None,
        end: End::Free,
        chords: 0,
    };
    // The ends of the chords to come, the next one last.
    let mut ends = vec![end];
    while let Some(&end) = ends.last() {
        let start = answer.free_until;
        if let Some(within) = answer.within
            && within.by - start <= options.time_tolerance
        {
            answer.end = End::Tolerance;
            return Ok(answer);
        }
        if answer.chords >= options.chord_limit {
            answer.end = End::ChordLimit;
            return Ok(answer);
        }
        answer.chords += 1;
        let chords: Vec<Chord> = trajectories.iter().map(|x| Chord::of(x, start, end)).collect();
        let straight = Straight::<K>::new(&chords, start, end)?;
        let Some(free_until) = straight.free_until(d) else {
            answer.free_until = end;
            ends.pop();
            continue;
        };
        answer.free_until = free_until;
        if let Some(within) = proximity(&straight, d, options.distance_tolerance)
            && answer.within.is_none_or(|known| within.by < known.by)
        {
            let by = within.by.max(free_until);
            answer.within = Some(Within { by, ..within });
            // Chords after this time are not needed.
            while ends.last().is_some_and(|&end| end >= by) {
                ends.pop();
            }
            ends.push(by);
            continue;
        }
        if end - free_until <= SHORTEST {
            answer.end = End::Precision;
            return Ok(answer);
        }
        ends.push(free_until + 0.5 * (end - free_until));
    }
    if answer.within.is_some() {
        // All is free until the proved proximity, of at most d + ε.
        answer.end = End::Tolerance;
    }
    Ok(answer)
}

/// The earliest time by which the chords prove proximity.
fn proximity<K: CurvedKind>(straight: &Straight<K>, d: Separation, tolerance: Separation) -> Option<Within> {
    let contact = straight.within_by(d);
    if let Some(by) = contact {
        return Some(Within {
            by,
            proximity: Proximity::Contact,
        });
    }
    let wider = Separation::new(add_up(d.get(), tolerance.get()).next_down()).unwrap_or(d);
    if tolerance > Separation::default()
        && let Some(by) = straight.within_by(wider)
    {
        return Some(Within {
            by,
            proximity: Proximity::Near,
        });
    }
    let is_crossing = d == Separation::default() && crossing::is_certain(straight);
    is_crossing.then_some(Within {
        by: straight.end,
        proximity: Proximity::Contact,
    })
}
