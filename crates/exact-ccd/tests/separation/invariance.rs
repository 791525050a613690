//! The answers do not depend on the order of points, the axes, the unit, or the direction of time.

use exact_ccd::ContactTime;
use exact_ccd::separation::{Separation, TimeInterval};
use proptest::prelude::*;

use crate::families::{cases, ordinary, rule};
use crate::kinds::{FromFour, for_each_kind};
use crate::laws::bits;
use crate::primitives::Points;
use crate::runner::for_all;

#[derive(Clone, Copy, Debug)]
struct Symmetry {
    renaming: usize,
    axes: [usize; 3],
    mirrored: [bool; 3],
    exponent: i32,
}

fn symmetry() -> impl Strategy<Value = Symmetry> {
    let axes = Just([0, 1, 2]).prop_shuffle();
    let exponent = prop_oneof![Just(0), -3..=3, -900..=900];
    (0..4usize, axes, any::<[bool; 3]>(), exponent).prop_map(|(renaming, axes, mirrored, exponent)| {
        Symmetry {
            renaming,
            axes,
            mirrored,
            exponent,
        }
    })
}

impl Symmetry {
    /// The image of points and a distance; the unit is unchanged if a number would be rounded.
    fn apply<K: FromFour>(&self, points: &Points, d: Separation) -> (Points, Separation) {
        let power = 2f64.powi(self.exponent);
        let is_exact = |x: f64| (x * power).is_finite() && x * power / power == x;
        let coordinates = points.as_flattened().as_flattened();
        let all_exact = is_exact(d.get()) && coordinates.iter().all(|&x| is_exact(x));
        let power = if all_exact { power } else { 1.0 };
        let order = K::RENAMINGS[self.renaming % K::RENAMINGS.len()];
        let points = points.map(|now| {
            order.map(|point| {
                self.axes.map(|axis| {
                    let sign = if self.mirrored[axis] { -1.0 } else { 1.0 };
                    now[point][axis] * power * sign
                })
            })
        });
        (points, Separation::new(d.get() * power).unwrap())
    }
}

fn symmetric<K: FromFour>() {
    for_all(
        cases(20_000),
        (ordinary(), rule(), symmetry()),
        |(points, rule, symmetry)| {
            let d = rule.separation::<K>(&points);
            let (image, image_d) = symmetry.apply::<K>(&points, d);
            let (query, other) = (K::query(&points), K::query(&image));
            let (times, others) = (query.intervals_within(d), other.intervals_within(image_d));
            assert_eq!(
                bits(&times),
                bits(&others),
                "{d:?}: {query:?}, {image_d:?}: {other:?}"
            );
            assert_eq!(
                query.first_within(d),
                other.first_within(image_d),
                "{d:?}: {query:?}"
            );
        },
    );
}

/// True if the numbers may be t and 1 − t.
fn may_add_up_to_one(a: ContactTime, b: ContactTime) -> bool {
    let compare = |a: f64, b: f64| {
        let (smaller, larger) = if a < b { (a, b) } else { (b, a) };
        // 1 − x is exact for x ≥ 1/2.
        if larger < 0.5 {
            std::cmp::Ordering::Less
        } else {
            smaller.total_cmp(&(1.0 - larger))
        }
    };
    let (lower, upper) = (compare(a.lower(), b.lower()), compare(a.upper(), b.upper()));
    if a.is_exact() && b.is_exact() {
        lower.is_eq()
    } else {
        lower.is_lt() && upper.is_gt()
    }
}

fn reversible<K: FromFour>() {
    for_all(cases(20_000), (ordinary(), rule()), |(points, rule)| {
        let d = rule.separation::<K>(&points);
        let [start, end] = points;
        let (forth, back) = (K::query(&points), K::query(&[end, start]));
        let (times, reversed) = (forth.intervals_within(d), back.intervals_within(d));
        assert_eq!(times.len(), reversed.len(), "{d:?}: {forth:?}");
        for (TimeInterval { start, end }, mirrored) in times.iter().zip(reversed.iter().rev()) {
            assert!(may_add_up_to_one(*start, mirrored.end), "{d:?}: {forth:?}");
            assert!(may_add_up_to_one(*end, mirrored.start), "{d:?}: {forth:?}");
        }
    });
}

for_each_kind! {
    names_axes_and_the_unit_do_not_matter => symmetric;
    time_can_run_backwards => reversible;
}
