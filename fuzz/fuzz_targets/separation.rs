//! Queries of all kinds with a distance: the fast path answers as the exact one, and the distance
//! at a time agrees.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd::{EdgeEdge, Kind, Point, Query, Separation, VertexEdge, VertexFace, VertexVertex};
use exact_ccd_fuzz::coordinate;
use exact_ccd_testing::laws;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes are no query.
    let _ = check(&mut Unstructured::new(bytes));
});

fn check(bytes: &mut Unstructured) -> Result<()> {
    let rule = Rule {
        distance: coordinate(bytes)?.abs(),
        eighths: bytes.int_in_range(0..=8)?,
        is_reached: bytes.arbitrary()?,
        steps: bytes.int_in_range(-2..=2)?,
    };
    let [start, end] = points(bytes)?;
    let [a, b, c, d] = [0, 1, 2, 3].map(|i: usize| [start[i], end[i]]);
    check_kind::<VertexFace>(start, end, &rule);
    check_kind::<EdgeEdge>(start, end, &rule);
    check_kind::<VertexEdge>([a[0], c[0], d[0]], [a[1], c[1], d[1]], &rule);
    check_kind::<VertexVertex>([a[0], b[0]], [a[1], b[1]], &rule);
    Ok(())
}

/// The distance to check: a number, or the distance of the primitives at a time and some f64 away
/// from it.
struct Rule {
    distance: f64,
    eighths: u8,
    is_reached: bool,
    steps: i8,
}

fn check_kind<K: Kind>(start: K::Points, end: K::Points, rule: &Rule) {
    // Coordinates that are not finite are no query.
    let Ok(query) = Query::<K>::new(start, end) else {
        return;
    };
    let t = f64::from(rule.eighths) / 8.0;
    let bounds = query.distance_at(t).expect("the time is in the step");
    let next = if rule.steps < 0 {
        f64::next_down
    } else {
        f64::next_up
    };
    let reached = (0..rule.steps.unsigned_abs()).fold(bounds.lower, |d, _| next(d));
    let distance = if rule.is_reached { reached } else { rule.distance };
    let Ok(d) = Separation::new(distance) else {
        return;
    };
    let intervals = laws::checked(&query, d);
    assert_eq!(
        laws::contain(&intervals, t),
        bounds.upper <= d.get(),
        "{d:?}: {query:?}"
    );
    laws::assert_reversible(&query, d);
}

/// Few values, so that many coordinates are the same.
fn points(bytes: &mut Unstructured) -> Result<[[Point; 4]; 2]> {
    let mut values = [0.0; 8];
    for value in &mut values {
        *value = coordinate(bytes)?;
    }
    let mut points = [[Point::default(); 4]; 2];
    for x in points.as_flattened_mut().as_flattened_mut() {
        *x = values[bytes.int_in_range(0..=values.len() - 1)?];
    }
    Ok(points)
}
