//! The two halves of a step or of a primitive have the contacts of the whole. Exact on integers.

use exact_ccd::{CONTACT, ContactTime, EdgeEdge, Interval, Intervals, Point, VertexFace};
use proptest::prelude::*;

use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::primitives::{Points, Primitives, combine};
use exact_ccd_testing::runner::for_all;

fn exact_points<K: Primitives>() -> impl Strategy<Value = Points> {
    prop_oneof![
        small_integers(2),
        degenerate(small_integers(2)),
        degenerate(large_integers()),
        exact_contacts::<K>(integers()),
        exact_grazes::<K>(integers()),
    ]
}

fn middle(a: Point, b: Point) -> Point {
    combine([0.5, 0.5], [a, b])
}

fn times_of<K: Primitives>(points: &Points) -> Intervals {
    query::<K>(points).intervals(CONTACT)
}

/// The part of an interval from one time to another: its ends, each between two f64, and true for a moment.
fn part(whole: &Interval, low: f64, high: f64) -> Option<([[f64; 2]; 2], bool)> {
    let is_apart = whole.start.upper() > high || whole.end.lower() < low;
    let ends = [whole.start, whole.end].map(|time| [time.lower(), time.upper()].map(|t| t.clamp(low, high)));
    let is_moment = whole.is_moment || ends.as_flattened().iter().all(|&t| t == ends[0][0]);
    (!is_apart).then_some((ends, is_moment))
}

/// Returns true if a time may be the given one.
fn may_be(time: ContactTime, [lower, upper]: [f64; 2]) -> bool {
    if lower == upper {
        time.is_exact() && time.lower() == lower
    } else if time.is_exact() {
        lower < time.lower() && time.lower() < upper
    } else {
        lower <= time.lower() && time.upper() <= upper
    }
}

fn halves_of_the_step<K: Primitives>(points: &Points) {
    let [start, end] = *points;
    let noon = [0, 1, 2, 3].map(|i: usize| middle(start[i], end[i]));
    let whole = times_of::<K>(points);
    let halves = [([start, noon], 0.0), ([noon, end], 1.0)];
    for (half, shift) in halves {
        let (low, high) = (0.5 * shift, 0.5 * (1.0 + shift));
        let parts: Vec<_> = whole.iter().filter_map(|whole| part(whole, low, high)).collect();
        let times = times_of::<K>(&half);
        assert_eq!(times.len(), parts.len(), "{points:?}");
        for (time, ([start, end], is_moment)) in times.iter().zip(parts) {
            // Exact for times in [1/2, 1], or without a shift.
            let doubled = |bounds: [f64; 2]| bounds.map(|t| 2.0 * t - shift);
            let is_part = may_be(time.start, doubled(start))
                && may_be(time.end, doubled(end))
                && time.is_moment == is_moment;
            assert!(is_part, "{whole:?}, {time:?}: {points:?}");
        }
    }
}

/// The union of intervals. Intervals that may have a time in common count as one.
fn union(mut intervals: Vec<Interval>) -> Vec<Interval> {
    intervals.sort_by_key(|interval| interval.start);
    let mut union: Vec<Interval> = Vec::new();
    for next in intervals {
        match union.last_mut() {
            Some(last) if next.start <= last.end => {
                last.end = last.end.max(next.end);
                last.is_moment &= next.is_moment;
            }
            _ => union.push(next),
        }
    }
    union
}

/// Cuts the edge between the last two points: an edge of the face, or the second edge.
fn halves_of_a_primitive<K: Primitives>(points: &Points) {
    let left = points.map(|[a, b, c, d]| [a, b, c, middle(c, d)]);
    let right = points.map(|[a, b, c, d]| [a, b, middle(c, d), d]);
    let halves = [left, right].iter().flat_map(times_of::<K>).collect();
    let whole = times_of::<K>(points).to_vec();
    assert_eq!(union(whole), union(halves), "{points:?}");
}

fn cuts<K: Primitives>(check: impl Fn(&Points)) {
    for_all(8_000, exact_points::<K>(), |points| check(&points));
}

#[test]
fn of_the_step_of_a_vertex_and_a_face() {
    cuts::<VertexFace>(halves_of_the_step::<VertexFace>);
}

#[test]
fn of_the_step_of_two_edges() {
    cuts::<EdgeEdge>(halves_of_the_step::<EdgeEdge>);
}

#[test]
fn of_a_face() {
    cuts::<VertexFace>(halves_of_a_primitive::<VertexFace>);
}

#[test]
fn of_an_edge() {
    cuts::<EdgeEdge>(halves_of_a_primitive::<EdgeEdge>);
}
