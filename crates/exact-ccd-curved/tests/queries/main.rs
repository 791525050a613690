//! Searches against closed forms, samples and straight queries.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

mod closed_forms;
mod extremes;
mod sampled;
mod straight;

use exact_ccd::{Kind, Point, Separation};
use exact_ccd_curved::{Polynomial, SearchOptions};

fn within(d: f64) -> Separation {
    Separation::new(d).unwrap()
}

fn at_rest(point: Point) -> Polynomial<1> {
    Polynomial::new([point])
}

/// Contact proved, and its time to within `time`.
fn timed(time: f64) -> SearchOptions {
    SearchOptions::default().with_time_tolerance(time)
}

/// The distance proved, to within `epsilon`.
fn close(epsilon: f64) -> SearchOptions {
    SearchOptions::default().with_distance_tolerance(within(epsilon))
}

/// The points of a query at one time, by their index.
fn points<K: Kind>(mut at: impl FnMut(usize) -> Point) -> K::Points {
    let mut points = K::Points::default();
    for (index, point) in points.as_mut().iter_mut().enumerate() {
        *point = at(index);
    }
    points
}
