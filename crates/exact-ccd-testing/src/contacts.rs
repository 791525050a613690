//! Queries with contact at a given time and place: exact if the arithmetic is exact, otherwise
//! approximate.

use crate::primitives::{Points, Primitives, at, combine};

/// Some points, moved into contact at (t, u, v).
pub fn touching<K: Primitives>(mut points: Points, [t, u, v]: [f64; 3]) -> Points {
    let [u, v] = K::in_domain(u, v);
    let gap = combine(K::weights(u, v), at(&points, t));
    for point in points.iter_mut().flat_map(|now| &mut now[..K::FIRST]) {
        *point = combine([1.0, -1.0], [*point, gap]);
    }
    points
}

/// Some points, moved into contact at (t, u, v) with a relative velocity in the common plane, given
/// in terms of its spanning vectors: a double root of the coplanarity.
pub fn grazing<K: Primitives>(points: Points, [t, u, v]: [f64; 3], [a, b]: [f64; 2]) -> Points {
    let mut points = touching::<K>(points, [t, u, v]);
    let [u, v] = K::in_domain(u, v);
    let weights = K::weights(u, v);
    let along = |start: [f64; 4], end: [f64; 4]| {
        combine([0, 1, 2, 3].map(|i: usize| end[i] - start[i]), at(&points, t))
    };
    let (of_u, of_v) = (
        along(K::weights(0.0, v), K::weights(1.0, v)),
        along(K::weights(u, 0.0), K::weights(u, 1.0)),
    );
    let [start, end] = points.map(|now| combine(weights, now));
    let change = combine([a, b, -1.0, 1.0], [of_u, of_v, end, start]);
    for (time, now) in points.iter_mut().enumerate() {
        for point in &mut now[..K::FIRST] {
            *point = combine([1.0, time as f64 - t], [*point, change]);
        }
    }
    points
}
