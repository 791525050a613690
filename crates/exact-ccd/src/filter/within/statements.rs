//! Statements that these filters prove, compared with the definition, for separations next to the distance.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::beside_contact;
use super::crossing::Crossings;
use super::scaled::Scaled;
use super::snapshot::{Headed, Snapshot};
use super::starts_within;
use crate::exact::{self, FirstWithin};
use crate::filter::hull::Hull;
use crate::numbers::double_double::{DoubleDouble, ROUNDOFF};
use crate::numbers::vector::{cross, minus, scaled};
use crate::tables::{EdgeEdge, Point, Points, Tables, VertexEdge, VertexFace, VertexVertex};
use crate::values::{DistanceBounds, Separation, unit};

/// The accuracy that the documentation promises of parameters and normals.
const ACCURACY: f64 = 1.0 / (1_u64 << 32) as f64;

/// Times at which distances are compared.
const TIMES: [f64; 5] = [0.0, 0.1875, 0.5, 0.75, 1.0];

/// Two of three have small integers as coordinates, so that many are degenerate.
fn queries<K: Tables>(count: usize) -> impl Iterator<Item = Points<f64>> {
    let mut random = fastrand::Rng::with_seed(1);
    (0..count).map(move |index| {
        [(); 2].map(|()| {
            let mut points = [[0.0; 3]; 4];
            points[..K::COUNT].fill_with(|| {
                [(); 3].map(|()| match index % 3 {
                    0 => 2.0 * random.f64() - 1.0,
                    _ => f64::from(random.i32(-3..=3)),
                })
            });
            K::LAYOUT.map(|i| points[i])
        })
    })
}

/// Separations next to the distances at some times, and not far from them.
fn separations<K: Tables>(points: &Points<f64>) -> Vec<f64> {
    let mut all = Vec::new();
    for t in TIMES {
        let d = exact::distance_at::<K>(points, t).lower;
        all.extend([
            0.75 * d,
            d * (1.0 - 1e-12),
            d.next_down(),
            d,
            d.next_up(),
            d * (1.0 + 1e-12),
        ]);
    }
    all.retain(|&d| d > 0.0);
    all
}

/// The comparison of the distance at a time with d.
fn compare<K: Tables>(points: &Points<f64>, t: f64, d: f64) -> Ordering {
    let DistanceBounds { lower, upper } = exact::distance_at::<K>(points, t);
    if lower == upper {
        lower.total_cmp(&d)
    } else if d <= lower {
        Ordering::Greater
    } else {
        Ordering::Less
    }
}

/// Times from one to another one.
fn between(from: f64, to: f64) -> impl Iterator<Item = f64> {
    [0.0, 0.125, 0.5, 0.875, 1.0]
        .into_iter()
        .map(move |s| from + s * (to - from))
}

/// Calls a function with queries, separations, and the scaled numbers of both.
fn for_all<K: Tables>(count: usize, mut check: impl FnMut(&Points<f64>, &Hull<f64>, &Scaled, f64)) {
    for points in queries::<K>(count) {
        let hull = Hull::new::<K>(&points);
        for d in separations::<K>(&points) {
            if let Some(scaled) = Scaled::new(&hull, d) {
                check(&points, &hull, &scaled, d);
            }
        }
    }
}

/// Returns true if the impact is certain. Asserts that it is the impact of the definition then.
#[track_caller]
fn has_impact<K: Tables>(points: &Points<f64>, crossings: &Crossings, truth: &FirstWithin, d: f64) -> bool {
    let first = truth.time();
    let approach = crossings.approach::<K>(first);
    let Some(found) = approach.and_then(|approach| approach.impact::<K>(first)) else {
        return false;
    };
    let exactly = truth.impact::<K>();
    let differences = found.parameters.into_iter().zip(exactly.parameters);
    let normals = [found.normal, exactly.normal].map(|normal| normal.into_iter().flatten());
    let [found_normal, exact_normal] = normals;
    for (x, y) in differences.chain(found_normal.zip(exact_normal)) {
        assert!((x - y).abs() <= ACCURACY, "{found:?} {exactly:?} {points:?} {d}");
    }
    assert_eq!(found.normal.is_some(), exactly.normal.is_some());
    true
}

/// Stretches that are free, and times at which the primitives are within d.
fn stretches<K: Tables>() {
    let mut proved = [0; 4];
    for_all::<K>(24, |points, _, scaled, d| {
        let crossings = Crossings::new::<K>(points, scaled);
        if starts_within::<K>(scaled) {
            assert_ne!(compare::<K>(points, 0.0, d), Ordering::Greater, "{points:?} {d}");
            proved[0] += 1;
        }
        for pair in TIMES.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let free = crossings.advancement.free_after::<K>(from, to);
            for t in between(from, free).filter(|&t| t < free) {
                assert_eq!(
                    compare::<K>(points, t, d),
                    Ordering::Greater,
                    "{points:?} {d} {t}"
                );
                proved[1] += 1;
            }
            let [now, then] = [from, to].map(|t| crossings.precise.at::<K>(t));
            let [headed, arrived] = [&now, &then].map(Headed::new);
            if headed
                .zip(arrived)
                .is_some_and(|(headed, arrived)| headed.is_beyond_across(&arrived))
            {
                for t in between(from, to) {
                    assert_eq!(
                        compare::<K>(points, t, d),
                        Ordering::Greater,
                        "{points:?} {d} {t}"
                    );
                }
                proved[2] += 1;
            }
            if now.is_within() {
                assert_eq!(
                    compare::<K>(points, from, d),
                    Ordering::Less,
                    "{points:?} {d} {from}"
                );
                proved[3] += 1;
            }
        }
    });
    assert!(proved.iter().all(|&count| count > 20), "{proved:?}");
}

#[test]
fn stretches_of_time_are_free_or_within_the_separation() {
    stretches::<VertexFace>();
    stretches::<EdgeEdge>();
    stretches::<VertexEdge>();
    stretches::<VertexVertex>();
}

/// The first time, all intervals, and the closest points.
fn answers<K: Tables>() {
    let mut proved = [0; 4];
    for_all::<K>(24, |points, hull, scaled, d| {
        let separation = Separation::new(d).expect("positive and finite");
        let crossings = Crossings::new::<K>(points, scaled);
        let truth = FirstWithin::of::<K>(points, separation);
        let time = truth.as_ref().map(FirstWithin::time);
        let expects = |first| assert_eq!(first, time, "{points:?} {d}");
        if compare::<K>(points, 0.0, d) == Ordering::Greater {
            if let Some(first) = crossings.first_between::<K>([0.0, 1.0]) {
                expects(first);
                proved[0] += 1;
            }
            if let Some(first) = beside_contact::first_after::<K>(points, hull, scaled, d, 0.0) {
                expects(Some(first));
            }
        }
        let Some(truth) = truth else { return };
        let first = truth.time();
        if let Some(intervals) = crossings.intervals::<K>(first) {
            assert_eq!(intervals, truth.intervals(), "{points:?} {d}");
            proved[1] += 1;
        }
        proved[2] += usize::from(has_impact::<K>(points, &crossings, &truth, d));
        proved[3] += 1;
    });
    assert!(proved.iter().all(|&count| count > 20), "{proved:?}");
}

#[test]
fn answers_are_those_of_the_definition() {
    answers::<VertexFace>();
    answers::<EdgeEdge>();
    answers::<VertexEdge>();
    answers::<VertexVertex>();
}

fn plus(a: Point, b: Point) -> Point {
    minus(a, b.map(|x| -x))
}

/// Closest points at ends of sides or next to them, with sides of lengths down to 2⁻¹⁶ and distances down to
/// 2⁻²⁶. `place` has the points, from a point, both sides, the vector between the closest points, and their
/// parameters.
fn impacts_next_to_ends<K: Tables>(place: impl Fn([Point; 4], [f64; 2]) -> [Point; 4]) {
    let mut random = fastrand::Rng::with_seed(1);
    let mut proved = 0;
    for index in 0..4000 {
        let mut vector = || -> Point { [(); 3].map(|()| 2.0 * random.f64() - 1.0) };
        let origin = vector();
        let sides = [vector(), vector()].map(unit);
        let normal = unit(cross(sides[0], sides[1]));
        // Half of the sides are long, and half of the distances are small: a rounding of the place of an end
        // is much of a small distance.
        let mut power = |[least, most]: [i32; 2]| libm::ldexp(1.0, -random.i32(least..=most));
        let [a, b] = sides.map(|side| scaled(side, power([0, if index % 2 == 0 { 0 } else { 16 }])));
        let d = power([if index % 4 < 2 { 23 } else { 0 }, 26]);
        let u = [0.0, 0.4, 1.0][random.usize(..3)];
        let v = [0.0, 0.6, 1.0, 1.0 - u][random.usize(..4)];
        // The first primitive comes nearer by d, so that the time is about 2⁻¹⁸.
        let apart = scaled(normal, d * (1.0 + libm::ldexp(1.0, -18)));
        let start = place([origin, a, b, apart], [u, v]);
        let mut end = start;
        for point in end.iter_mut().take(K::CORNERS[0].1) {
            *point = minus(*point, scaled(normal, d));
        }
        let points = &[start, end];
        let hull = Hull::new::<K>(points);
        let separation = Separation::new(d).expect("positive and finite");
        if let (Some(numbers), Some(truth)) =
            (Scaled::new(&hull, d), FirstWithin::of::<K>(points, separation))
        {
            let crossings = Crossings::new::<K>(points, &numbers);
            proved += usize::from(has_impact::<K>(points, &crossings, &truth, d));
        }
    }
    assert!(proved > 20, "{proved}");
}

#[test]
fn impacts_next_to_ends_are_those_of_the_definition() {
    let along = |from: Point, side: Point, s: f64| plus(from, scaled(side, s));
    impacts_next_to_ends::<VertexEdge>(|[o, a, _, x], [u, _]| {
        let e0 = along(minus(o, x), a, -u);
        [o, o, e0, plus(e0, a)]
    });
    impacts_next_to_ends::<VertexFace>(|[o, a, b, x], [u, v]| {
        let v1 = along(along(minus(o, x), a, -u), b, -v.min(1.0 - u));
        [o, v1, plus(v1, a), plus(v1, b)]
    });
    impacts_next_to_ends::<EdgeEdge>(|[o, a, b, x], [u, v]| {
        let b0 = along(minus(along(o, a, u), x), b, -v);
        [o, plus(o, a), b0, plus(b0, b)]
    });
}

/// Two vertices at rest at the distance (1 + k ε) d, exactly, next to what twice the precision proves.
#[test]
fn proofs_at_a_time_need_their_slack() {
    let p = [0.25, 0.5, 0.5];
    let points = |k: f64| {
        let q = p.map(|x| -k * ROUNDOFF * x);
        [[p, p, q, q]; 2]
    };
    let with = |k: f64, check: fn(&Snapshot<DoubleDouble>) -> bool| {
        let points = &points(k);
        let numbers = Scaled::new(&Hull::new::<VertexVertex>(points), 0.75).expect("in range");
        check(
            &Crossings::new::<VertexVertex>(points, &numbers)
                .precise
                .at::<VertexVertex>(0.0),
        )
    };
    // Corners are off by 8 ε: k > 33.9 is required, and the bounds have 82.
    assert!(!with(24.0, |now| Headed::new(now).is_some()) && with(128.0, |now| Headed::new(now).is_some()));
    // F is off by 53 ε: k > 124 is required, and the bound has 155.
    assert!(!with(-100.0, Snapshot::is_within) && with(-256.0, Snapshot::is_within));
}
