//! Vertices in one place, and motion along a line: contact proved by comparisons of coordinates,
//! without any rounding.
//!
//! A faulty recording has frames in which many vertices or all of them are equal. The coplanarity
//! cubics of its queries are zero or have a root at an end of the step, which no error bound can
//! prove.

use super::planar::is_across;
use crate::numbers::cubic::Cubic;
use crate::tables::{Difference, Point, Points, Tables};
use crate::values::{ContactTime, Impact, Interval, Intervals};

/// Contact that equal coordinates prove: the first and the last time of an interval or a moment of contact,
/// each if it is certain. If both are known, there is no other contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coincidence {
    pub(super) first: Option<ContactTime>,
    last: Option<ContactTime>,
}

impl Coincidence {
    /// There is contact at some time.
    const SOME_TIME: Self = Self {
        first: None,
        last: None,
    };

    /// There is contact at t = 0, and perhaps later.
    fn at_start() -> Self {
        Self {
            first: Some(ContactTime::exactly(0.0)),
            last: None,
        }
    }

    /// Contact lasts from one time to another, and there is no other one.
    fn lasting([first, last]: [f64; 2]) -> Self {
        Self {
            first: Some(ContactTime::exactly(first)),
            last: Some(ContactTime::exactly(last)),
        }
    }

    /// All intervals of contact, if they are certain.
    pub(super) fn intervals(self) -> Option<Intervals> {
        let (start, end) = (self.first?, self.last?);
        let is_moment = start == end;
        Some(Intervals::from_iter([Interval {
            start,
            end,
            is_moment,
        }]))
    }
}

/// The coincidence of a query with this coplanarity cubic whose bounding box contains the origin.
///
/// - *A vertex of each primitive, with the same trajectory.* F vanishes at that corner at all times.
/// - *A vertex of each primitive, in one place at t = 0 or t = 1.* F vanishes there. If all four points are
///   in one place, for example at t = 1, their differences at a time t are 1 − t times their differences at
///   t = 0, so that c(t) = (1 − t)³ c(0). If c(0) is not zero, c has no other root.
/// - *All points on a line along an axis, at both ends of the step.* The primitives are segments of
///   the line. If they are apart at t = 0 and at t = 1, they change places on it in between, as
///   otherwise the bounding box would exclude the origin. Hence they touch at some time. If at t = 0
///   some point of each is strictly before some point of the other, that remains true for a while,
///   during which the segments overlap.
pub(super) fn coincidence<K: Tables>(points: &Points<f64>, cubic: &Cubic<f64>) -> Option<Coincidence> {
    let meets = |time: usize, &(i, j): &Difference| points[time][i] == points[time][j];
    let all_meet = |time| K::CORNERS.iter().all(|corner| meets(time, corner));
    if K::CORNERS
        .iter()
        .any(|corner| meets(0, corner) && meets(1, corner))
    {
        return Some(Coincidence::lasting([0.0, 1.0]));
    }
    let ends = [(0.0, Coincidence::at_start()), (1.0, Coincidence::SOME_TIME)];
    for (end, (time, coincidence)) in ends.into_iter().enumerate() {
        if all_meet(end) && cubic.is_certain_at(1 - end) {
            return Some(Coincidence::lasting([time; 2]));
        }
        if K::CORNERS.iter().any(|corner| meets(end, corner)) {
            return Some(coincidence);
        }
    }
    let axis = line::<K>(points)?;
    let [start, _] = points;
    let [is_before, is_behind] = [
        K::CORNERS.iter().any(|&(i, j)| start[i][axis] < start[j][axis]),
        K::CORNERS.iter().any(|&(i, j)| start[i][axis] > start[j][axis]),
    ];
    Some(if is_before && is_behind {
        Coincidence::at_start()
    } else {
        Coincidence::SOME_TIME
    })
}

/// The axis of a line that contains all points, at both ends of the step.
fn line<K: Tables>(points: &Points<f64>) -> Option<usize> {
    (0..3).find(|&axis| is_across(points, (axis + 1) % 3) && is_across(points, (axis + 2) % 3))
}

/// The impact of four points that are in one place at both ends of the step, and hence always: the
/// first vertex lies on the first edge, which has length zero, and they do not move relative to each
/// other.
pub(super) fn impact<K: Tables>(points: &Points<f64>) -> Option<Impact> {
    let is_point = |points: &[Point; 4]| points.iter().all(|point| *point == points[0]);
    points.iter().all(is_point).then(|| Impact {
        time: ContactTime::exactly(0.0),
        parameters: K::SIDES[0].domain[0],
        normal: None,
    })
}
