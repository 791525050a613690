//! The times at which two primitives are within a distance d, from the definition alone, in integers.
//!
//! An independent oracle for the answers of the crate: slow, obvious, and without any code of it. Contact is
//! the distance 0. The distance D(t) of the closed primitives is the least of the distances between their
//! features (`feature.rs`). The times with D(t) ≤ d can begin and end only at 0, at 1, and at roots of the
//! polynomials of the features. All of these are isolated (`root.rs`, by Sturm's theorem) and sorted, and
//! membership is tested at each and once between neighbours.

mod check;
mod feature;
pub mod polynomial;
mod root;
mod sturm;
mod time;

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::Gcd;
use dashu_ratio::RBig;
use exact_ccd::{AnyKind, ContactTime, Interval, Intervals, Point};

pub use check::assert_defined;
use feature::Feature;
pub use feature::Vector;
use polynomial::Polynomial;
use root::Root;
use time::Time;

/// A time: the largest f64 that is not above it, and true if it is that f64.
pub type Moment = (f64, bool);

/// A time of the crate.
pub fn moment(time: ContactTime) -> Moment {
    (time.lower(), time.is_exact())
}

/// Intervals of the crate, as [`intervals`] has them.
pub fn found(intervals: &Intervals) -> Vec<([Moment; 2], bool)> {
    let ends = |found: &Interval| [moment(found.start), moment(found.end)];
    intervals
        .iter()
        .map(|found| (ends(found), found.is_moment))
        .collect()
}

/// The maximal intervals of the times at which the primitives are at most d apart: the first and last time of
/// each, and true if its length is 0.
pub fn intervals(kind: AnyKind, [start, end]: [&[Point]; 2], d: f64) -> Vec<([Moment; 2], bool)> {
    let (points, d) = in_integers([start, end], d);
    intervals_of(kind, &points, &Polynomial::new(vec![d]))
}

/// The same for points whose coordinates are polynomials, and for a distance that is one, not negative in the
/// step.
pub fn intervals_of(kind: AnyKind, points: &[Vector], d: &Polynomial) -> Vec<([Moment; 2], bool)> {
    let features: Vec<Feature> = feature::all(kind, points, d)
        .into_iter()
        .filter(Feature::is_ever_near)
        .collect();

    let mut events = vec![Root::at(Time::zero()), Root::at(Time::one())];
    for function in features.iter().flat_map(Feature::functions) {
        for root in root::isolate(function) {
            insert(&mut events, root);
        }
    }

    let mut intervals = Vec::new();
    let mut first: Option<usize> = None;
    for i in 0..events.len() {
        let is_near = features.iter().any(|feature| feature.is_near_at(&mut events[i]));
        let continues = i + 1 < events.len() && {
            let between = root::between(&mut events, i);
            features
                .iter()
                .any(|feature| feature.is_near_at(&mut Root::at(between.clone())))
        };
        assert!(
            is_near || !(continues || first.is_some()),
            "the set of times is closed"
        );
        if is_near {
            let start = *first.get_or_insert(i);
            if !continues {
                intervals.push((
                    [events[start].rounded_down(), events[i].rounded_down()],
                    start == i,
                ));
                first = None;
            }
        }
    }
    intervals
}

/// Inserts a root into a sorted list of different ones, unless it is there.
fn insert(events: &mut Vec<Root>, mut root: Root) {
    for i in 0..events.len() {
        match root.compare(&mut events[i]) {
            Ordering::Less => return events.insert(i, root),
            Ordering::Equal => return,
            Ordering::Greater => {}
        }
    }
    events.push(root);
}

/// All points, and d, as integer multiples of the largest possible unit. Contact does not change if an axis
/// is stretched, so that for d = 0 each axis has its own unit.
fn in_integers([start, end]: [&[Point]; 2], d: f64) -> (Vec<Vector>, IBig) {
    let on_axis = |axis: usize| start.iter().chain(end).map(move |point| point[axis]);
    let units = if d == 0.0 {
        [0, 1, 2].map(|axis| unit(on_axis(axis)))
    } else {
        let unit = unit((0..3).flat_map(on_axis).chain([d]));
        [unit.clone(), unit.clone(), unit]
    };
    let integer = |x: f64, axis: usize| (exactly(x) / &units[axis]).numerator().clone();
    let moving = |(a, b): (&Point, &Point)| {
        [0, 1, 2].map(|axis| {
            let [a, b] = [a, b].map(|point| integer(point[axis], axis));
            let change = &b - &a;
            Polynomial::new(vec![a, change])
        })
    };
    (start.iter().zip(end).map(moving).collect(), integer(d, 0))
}

/// The greatest common divisor of all numbers, or 1 if all are zero.
fn unit(numbers: impl Iterator<Item = f64>) -> RBig {
    let divisor = |a: RBig, b: RBig| {
        // a and b over a common denominator.
        let denominator = a.denominator() * b.denominator();
        let [a, b] = [a, b].map(|x| (x * RBig::from(denominator.clone())).numerator().clone());
        RBig::from_parts(a.gcd(b).into(), denominator)
    };
    let nonzero = numbers.filter(|x| *x != 0.0).map(exactly);
    nonzero.reduce(divisor).unwrap_or(RBig::ONE)
}

fn exactly(x: f64) -> RBig {
    RBig::try_from(x).expect("a finite number")
}
