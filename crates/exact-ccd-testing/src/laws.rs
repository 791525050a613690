//! Laws of the answers to every query, for contact and within a distance.

use std::cmp::Ordering;

use exact_ccd::{Collision, ContactTime, Interval, Intervals, Kind, Query, Separation};

/// All times at which the primitives touch. They are checked to be ordered intervals of the step, equal to
/// the answer of the exact path bit for bit, and consistent with the other answers, which are computed apart
/// from them, and with the primitives at single times.
pub fn checked<K: Kind>(query: &Query<K>, d: Separation) -> Intervals {
    // Times are equal if their bits are.
    let intervals = query.intervals(d);
    assert_eq!(intervals, query.exactly().intervals(d), "{d:?}: {query:?}");
    assert_sound(&intervals);

    let first = intervals.first_time();
    let decisions = [query.collides(d), query.exactly().collides(d)];
    assert_eq!(decisions, [first.is_some(); 2], "{d:?}: {query:?}");
    let times = [query.time_of_impact(d), query.exactly().time_of_impact(d)];
    assert_eq!(times, [first.map(ContactTime::lower); 2], "{d:?}: {query:?}");
    let collision = query.collision(d);
    let time = collision.as_ref().map(Collision::time);
    assert_eq!(time, first, "{d:?}: {query:?}");
    let impact = collision.map(|collision| collision.impact().time);
    assert_eq!(impact, first, "{d:?}: {query:?}");
    assert_right_at_single_times(query, d, &intervals);
    intervals
}

fn assert_sound(intervals: &Intervals) {
    // Two times that are not f64 may lie between the same two f64.
    let precedes = |a: ContactTime, b: ContactTime| a < b || (a == b && !a.is_exact());
    for &Interval {
        start,
        end,
        is_moment,
    } in intervals
    {
        assert!(start.lower().is_sign_positive(), "{intervals:?}");
        assert!(end.upper() <= 1.0, "{intervals:?}");
        let is_ordered = if is_moment {
            start == end
        } else {
            precedes(start, end)
        };
        assert!(is_ordered, "{intervals:?}");
    }
    for pair in intervals.windows(2) {
        assert!(precedes(pair[0].end, pair[1].start), "{intervals:?}");
    }
}

/// Returns true if t is in one of the intervals.
pub fn contain(intervals: &Intervals, t: f64) -> bool {
    intervals
        .iter()
        .any(|interval| interval.start.upper() <= t && t <= interval.end.lower())
}

/// Checks the intervals at the f64 around their ends, in the middle of each interval and of each gap: by the
/// distance then, and by the decision about the primitives at rest in that position, if its coordinates are
/// f64.
fn assert_right_at_single_times<K: Kind>(query: &Query<K>, d: Separation, intervals: &Intervals) {
    let ends = intervals
        .iter()
        .flat_map(|interval| [interval.start, interval.end]);
    let around = ends.flat_map(|time| [time.lower(), time.upper()]);
    let mut times: Vec<f64> = [0.0].into_iter().chain(around).chain([1.0]).collect();
    times.dedup();
    let between: Vec<f64> = times
        .windows(2)
        .filter_map(|pair| between(pair[0], pair[1]))
        .collect();
    for t in times.into_iter().chain(between) {
        let touches = contain(intervals, t);
        let distance = query.distance_at(t).unwrap();
        assert_eq!(
            distance.upper <= d.get(),
            touches,
            "at {t}, {distance:?}, {d:?}: {query:?}"
        );
        if let Some(resting) = at_rest(query, t) {
            assert_eq!(resting.collides(d), touches, "at rest at {t}, {d:?}: {query:?}");
        }
    }
}

/// A number between others in [0, 1], with as few digits as possible near the middle.
fn between(low: f64, high: f64) -> Option<f64> {
    let middle = low.midpoint(high).to_bits();
    (0..=52)
        .rev()
        .map(|digits| f64::from_bits(middle >> digits << digits))
        .find(|&x| low < x && x < high)
}

/// The primitives at rest where they are at time t, if these coordinates are f64.
fn at_rest<K: Kind>(moving: &Query<K>, t: f64) -> Option<Query<K>> {
    let [start, end] = moving.points();
    let mut now = *start;
    for (a, b) in now
        .as_mut()
        .as_flattened_mut()
        .iter_mut()
        .zip(end.as_ref().as_flattened())
    {
        *a = sum(*a, product(t, sum(*b, -*a)?)?)?;
    }
    Query::new(now, now).ok()
}

/// a + b, if it is an f64: the rounding error by Knuth's algorithm is 0, not NaN after overflow.
fn sum(a: f64, b: f64) -> Option<f64> {
    let sum = a + b;
    let of_b = sum - a;
    let error = (a - (sum - of_b)) + (b - of_b);
    (error == 0.0).then_some(sum)
}

/// a b, if it is an f64 and not tiny: then its error is a multiple of the smallest f64, and not rounded.
fn product(a: f64, b: f64) -> Option<f64> {
    let product = a * b;
    let is_exact = a.mul_add(b, -product) == 0.0 && product.abs() > 1e-200;
    (is_exact || a == 0.0 || b == 0.0).then_some(product)
}

/// Checks that two queries touch at the same times, bit for bit.
pub fn assert_same_times<K: Kind, L: Kind>(
    (one, d): (&Query<K>, Separation),
    (other, e): (&Query<L>, Separation),
) {
    let (times, others) = (one.intervals(d), other.intervals(e));
    assert_eq!(times, others, "{d:?}: {one:?}, {e:?}: {other:?}");
    let decisions = [one.collides(d), other.collides(e)];
    assert_eq!(
        decisions,
        [!times.is_empty(); 2],
        "{d:?}: {one:?}, {e:?}: {other:?}"
    );
}

/// Checks that an interval of times from s to t is from 1 − t to 1 − s when time runs backwards.
pub fn assert_reversible<K: Kind>(forth: &Query<K>, d: Separation) {
    let [start, end] = *forth.points();
    let back = Query::<K>::new(end, start).unwrap();
    let (times, reversed) = (forth.intervals(d), back.intervals(d));
    assert_eq!(times.len(), reversed.len(), "{d:?}: {forth:?}");
    for (there, mirrored) in times.iter().zip(reversed.iter().rev()) {
        let is_mirrored = there.is_moment == mirrored.is_moment
            && may_add_up_to_one(there.start, mirrored.end)
            && may_add_up_to_one(there.end, mirrored.start);
        assert!(is_mirrored, "{there:?}, backwards {mirrored:?}, {d:?}: {forth:?}");
    }
}

/// Returns true if the times may be t and 1 − t.
fn may_add_up_to_one(a: ContactTime, b: ContactTime) -> bool {
    let lower = compare_sum_with_one(a.lower(), b.lower());
    let upper = compare_sum_with_one(a.upper(), b.upper());
    if a.is_exact() && b.is_exact() {
        lower.is_eq()
    } else {
        lower.is_lt() && upper.is_gt()
    }
}

/// The comparison of a + b with 1, for numbers in [0, 1]. It is exact, because 1 − x is for x ≥ 1/2.
fn compare_sum_with_one(a: f64, b: f64) -> Ordering {
    let (smaller, larger) = if a < b { (a, b) } else { (b, a) };
    if larger < 0.5 {
        Ordering::Less
    } else {
        smaller.total_cmp(&(1.0 - larger))
    }
}
