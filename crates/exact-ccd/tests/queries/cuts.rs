//! The two halves of a step or of a primitive have the contacts of the whole. Exact on integers.

use exact_ccd::{ContactTime, ContactTimes, EdgeEdge, Point, VertexFace};
use proptest::prelude::*;

use crate::generators::*;
use crate::laws::query;
use crate::primitives::{Points, Primitives, combine};
use crate::runner::for_all;

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

fn times_of<K: Primitives>(points: &Points) -> ContactTimes {
    query::<K>(points).contact_times()
}

/// The finitely many times, or the first of infinitely many.
fn list(times: &ContactTimes) -> Vec<ContactTime> {
    match times {
        ContactTimes::Finite(times) => times.to_vec(),
        ContactTimes::Interval { first } => vec![*first],
    }
}

/// The image of a time under t ↦ 2 t − shift, exact for times in [1/2, 1], or without a shift.
fn doubled(time: ContactTime, shift: f64) -> [f64; 2] {
    [time.lower(), time.upper()].map(|t| 2.0 * t - shift)
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
    let (morning, afternoon) = (times_of::<K>(&[start, noon]), times_of::<K>(&[noon, end]));

    let lasts = morning.count().is_none() || afternoon.count().is_none();
    assert_eq!(whole.count().is_none(), lasts, "{points:?}");
    let (mut early, mut late) = (list(&whole), list(&whole));
    early.retain(|time| time.upper() <= 0.5);
    late.retain(|time| time.lower() >= 0.5);
    let [mut in_morning, mut in_afternoon] = [list(&morning), list(&afternoon)];
    if lasts {
        // Only the beginning of an interval is given.
        in_morning.truncate(1);
        in_afternoon.truncate(usize::from(early.is_empty()));
        late.truncate(in_afternoon.len());
    }
    assert_eq!(early.len(), in_morning.len(), "{points:?}");
    for (whole, half) in early.iter().zip(in_morning) {
        assert_eq!(doubled(*whole, 0.0), [half.lower(), half.upper()], "{points:?}");
    }
    assert_eq!(late.len(), in_afternoon.len(), "{points:?}");
    for (whole, half) in late.iter().zip(in_afternoon) {
        assert!(
            may_be(half, doubled(*whole, 1.0)),
            "{whole:?}, {half:?}: {points:?}"
        );
    }
}

/// Cuts the edge between the last two points: an edge of the face, or the second edge.
fn halves_of_a_primitive<K: Primitives>(points: &Points) {
    let left = points.map(|[a, b, c, d]| [a, b, c, middle(c, d)]);
    let right = points.map(|[a, b, c, d]| [a, b, middle(c, d), d]);
    let whole = times_of::<K>(points);
    let halves = [times_of::<K>(&left), times_of::<K>(&right)];

    assert_eq!(
        whole.count().is_none(),
        halves.iter().any(|times| times.count().is_none()),
        "{points:?}"
    );
    let mut expected: Vec<ContactTime> = halves.iter().flat_map(list).collect();
    expected.sort_by(|a, b| {
        (a.lower(), a.upper())
            .partial_cmp(&(b.lower(), b.upper()))
            .unwrap()
    });
    expected.dedup();
    if whole.count().is_none() {
        expected.truncate(1);
    }
    let mut found = list(&whole);
    found.dedup();
    assert_eq!(found, expected, "{points:?}");
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
