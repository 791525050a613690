//! Statements of the integers of fixed width and of motion in a plane, compared with the definition.

use core::array::from_fn;
use core::cmp::Ordering;

use dashu_ratio::RBig;

use super::coincident::coincidence;
use super::coplanarity::Coplanarity;
use super::gap::Touching;
use super::hull::Hull;
use super::planar::Planar;
use super::position::{self, Position};
use crate::exact::FirstContact;
use crate::fixed;
use crate::numbers::cubic::Root;
use crate::tables::{EdgeEdge, Point, Points, Tables, VertexEdge, VertexFace, VertexVertex};
use crate::values::Intervals;

/// Times at which the sign of the cubic is compared: multiples of 2⁻¹⁰, where it often vanishes, a time after
/// one of them, and others.
const TIMES: [f64; 9] = [
    0.0,
    0.125,
    0.25,
    1.0 / 3.0,
    0.5,
    0.5001,
    0.6,
    0.75,
    1023.0 / 1024.0,
];

/// Small integers: many contacts are degenerate, parallel or tangent. In three of four queries the axes have
/// units of their own. One half has a coordinate that is a little beside an integer, at most 2⁻²⁰: where the
/// difference has many digits, integers of 64 bits do not suffice. `flat` is the number of axes on which a
/// coordinate is the same for all points.
fn queries<K: Tables>(count: usize, flat: usize) -> impl Iterator<Item = Points<f64>> {
    let mut random = fastrand::Rng::with_seed(2);
    (0..count).map(move |index| {
        let first = random.usize(0..3);
        let is_flat: [bool; 3] = from_fn(|axis| (axis + first) % 3 < flat);
        let units = [(); 3].map(|()| match index % 4 {
            0 => 1.0,
            _ => libm::ldexp(1.0, random.i32(-90..90)),
        });
        let mut points = [(); 2].map(|()| {
            let mut points = [[0.0; 3]; 4];
            points[..K::COUNT].fill_with(|| -> Point {
                from_fn(|axis| {
                    if is_flat[axis] {
                        1.0
                    } else {
                        f64::from(random.i32(-3..=3))
                    }
                })
            });
            points
        });
        if index % 2 == 0 {
            let points = &mut points[random.usize(0..2)];
            let point = random.usize(0..K::COUNT);
            let axis = random.usize(0..3);
            if !is_flat[axis] {
                points[point][axis] += libm::ldexp(1.0, -random.i32(20..80));
            }
        }
        for point in points.as_flattened_mut() {
            *point = from_fn(|axis| point[axis] * units[axis]);
        }
        points.map(|now| K::LAYOUT.map(|i| now[i]))
    })
}

/// Bodies thrown through a point, x₁ = c − k (x₀ − c): but for roundings, the cubic has a triple root. It is
/// early for a large k. With k = 1, it often has a double one, and with c = 0 and k = 2, a triple one.
fn thrown<K: Tables>(count: usize) -> impl Iterator<Item = Points<f64>> {
    let mut random = fastrand::Rng::with_seed(3);
    (0..count).map(move |index| {
        let mut point = || -> Point { from_fn(|_| 2.0 * random.f64() - 1.0) };
        let (center, middle) = (point(), point());
        let k = libm::exp2(8.0 * point()[0] + 8.0);
        let mut start = [[0.0; 3]; 4];
        start[..K::COUNT].fill_with(|| {
            let offset = point();
            from_fn(|axis| middle[axis] + 0.1 * offset[axis])
        });
        let mut end = start;
        for (x0, x1) in start.iter_mut().zip(&mut end) {
            let direction = *x0;
            for axis in 0..3 {
                let x = direction[axis];
                [x0[axis], x1[axis]] = match index % 4 {
                    0 => [center[axis] + x, center[axis] - x],
                    1 => [x, -2.0 * x],
                    2 => [center[axis] + x, center[axis] - k * x],
                    _ => [center[axis] + x, center[axis] - (0.1 + center[0].abs()) * x],
                };
            }
        }
        [start, end].map(|now| K::LAYOUT.map(|i| now[i]))
    })
}

/// Mirror images of few points, thrown through the origin with roundings: many coordinates are equal, or
/// opposite, and many roots of the cubic are the times at which their differences vanish.
fn mirrored<K: Tables>(count: usize) -> impl Iterator<Item = Points<f64>> {
    let mut random = fastrand::Rng::with_seed(4);
    (0..count).map(move |index| {
        let magnitudes: Point = from_fn(|_| random.f64());
        let k = if index % 4 == 0 { 2.0 } else { 8.0 * random.f64() };
        let mut start = [[0.0; 3]; 4];
        start[..K::COUNT]
            .fill_with(|| from_fn(|_| f64::from(random.i32(-1..=1)) * magnitudes[random.usize(..3)]));
        let mut end = start;
        for x in &mut end {
            *x = x.map(|x| x + (-k * x - x));
        }
        [start, end].map(|now| K::LAYOUT.map(|i| now[i]))
    })
}

/// The sign of the coplanarity cubic at a time, in rational numbers.
fn sign_at<K: Tables>(points: &Points<f64>, t: f64) -> Ordering {
    let rational = |x: f64| RBig::try_from(x).expect("a finite number");
    let [w, a, b]: [[RBig; 3]; 3] = K::SPAN.map(|(i, j)| {
        from_fn(|axis| {
            let [start, end] =
                [0, 1].map(|end: usize| rational(points[end][i][axis]) - rational(points[end][j][axis]));
            &start + rational(t) * (end - &start)
        })
    });
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    let volume = &w[0] * minor(1, 2) + &w[1] * minor(2, 0) + &w[2] * minor(0, 1);
    volume.cmp(&RBig::ZERO)
}

/// All times of contact by the definition.
fn intervals<K: Tables>(points: &Points<f64>) -> Intervals {
    FirstContact::<K>::of(points).map_or_else(Intervals::default, |contact| contact.intervals())
}

/// Decisions, first times, all times and signs in integers of fixed width.
fn integers<K: Tables>() -> [usize; 5] {
    let mut known = [0; 5];
    let small = queries::<K>(1500, 0).chain(queries::<K>(500, 1));
    for points in small.chain(thrown::<K>(800)).chain(mirrored::<K>(800)) {
        let points = &points;
        let truth = FirstContact::<K>::of(points);
        if let Some(moment) = fixed::first_moment::<K>(points) {
            assert_eq!(moment.is_some(), truth.is_some(), "{points:?}");
            known[usize::from(moment.is_some())] += 1;
        }
        if let Some(time) = fixed::first::<K>(points) {
            assert_eq!(Some(time), truth.as_ref().map(FirstContact::time), "{points:?}");
            known[2] += 1;
        }
        if let Some(moments) = fixed::moments::<K>(points) {
            assert_eq!(moments, intervals::<K>(points), "{points:?}");
            known[4] += usize::from(moments.count() != Some(0));
        }
        for t in TIMES {
            if let Some(signs) = fixed::signs_until::<K>(points, t) {
                let [at_start, .., at_end] = signs;
                assert_eq!(at_start, sign_at::<K>(points, 0.0), "{points:?}");
                assert_eq!(at_end, sign_at::<K>(points, t), "{points:?} {t}");
                if at_start.is_ne() && signs.iter().all(|&sign| sign == at_start || sign.is_eq()) {
                    assert_eq!(at_start, sign_at::<K>(points, 0.75 * t), "{points:?} {t}");
                    known[3] += 1;
                }
            }
        }
    }
    known
}

#[test]
fn integers_of_fixed_width_have_the_answers_of_the_definition() {
    for known in [integers::<VertexFace>(), integers::<EdgeEdge>()] {
        assert!(known.iter().all(|&count| count > 20), "{known:?}");
    }
    // Few of these are in contact.
    integers::<VertexEdge>();
    integers::<VertexVertex>();
}

/// Most queries of mirror images whose cubic is not zero are decided, with all times.
#[test]
fn mirror_images_that_pass_through_a_point_are_decided_by_integers_of_fixed_width() {
    let mut counts = [0; 2];
    for points in mirrored::<EdgeEdge>(4000) {
        let is_coplanar = TIMES.iter().all(|&t| sign_at::<EdgeEdge>(&points, t).is_eq());
        if !is_coplanar {
            counts[usize::from(fixed::moments::<EdgeEdge>(&points).is_some())] += 1;
        }
    }
    let [unknown, known] = counts;
    assert!(known > 1000 && unknown * 8 < known, "{counts:?}");
}

/// The intervals of contact in a plane across an axis, and the first contact.
fn planes<K: Tables>() {
    let mut known = [0; 2];
    for points in queries::<K>(2000, 1) {
        let points = &points;
        let planar = Planar::new(points).expect("an axis is flat");
        if let Some(stretches) = planar.stretches::<K>() {
            assert_eq!(
                !stretches.is_empty(),
                FirstContact::<K>::of(points).is_some(),
                "{points:?}"
            );
            known[0] += 1;
        }
        if let Some(found) = planar.intervals::<K>() {
            assert_eq!(found, intervals::<K>(points), "{points:?}");
            known[1] += usize::from(found.count() != Some(0));
        }
    }
    assert!(known.iter().all(|&count| count > 20), "{known:?}");
}

#[test]
fn motion_in_a_plane_has_the_intervals_of_the_definition() {
    planes::<VertexFace>();
    planes::<EdgeEdge>();
}

/// Points of a query in one place or with one trajectory, or all of them on a line.
fn coincidences<K: Tables>() {
    let mut random = fastrand::Rng::with_seed(3);
    let mut known = [0; 2];
    for mut points in (0..3).flat_map(|flat| queries::<K>(2000, flat)) {
        for _ in 0..random.usize(0..3) {
            let [from, to] = [(); 2].map(|()| random.usize(0..4));
            let ends = random.usize(0..3);
            for (end, now) in points.iter_mut().enumerate() {
                if ends == 2 || ends == end {
                    now[to] = now[from];
                }
            }
        }
        let points = &points;
        if Hull::new::<K>(points).is_beyond_axis(Touching) {
            continue;
        }
        let Some(found) = coincidence::<K>(points, &Coplanarity::new::<K>(points).cubic) else {
            continue;
        };
        let exact = intervals::<K>(points);
        assert_ne!(exact.count(), Some(0), "{points:?}");
        if let Some(first) = found.first {
            assert_eq!(
                Some(first),
                exact.iter().next().map(|one| one.start),
                "{points:?}"
            );
            known[0] += 1;
        }
        if let Some(found) = found.intervals() {
            assert_eq!(found, exact, "{points:?}");
            known[1] += 1;
        }
    }
    assert!(known.iter().all(|&count| count > 20), "{known:?}");
}

#[test]
fn coincidences_have_the_times_of_the_definition() {
    coincidences::<VertexFace>();
    coincidences::<EdgeEdge>();
}

/// Points at rest in a plane across an axis.
fn positions<K: Tables>() {
    let mut known = [0; 2];
    for moving in queries::<K>(4000, 1) {
        let points = &[moving[0]; 2];
        if let Some(found) = position::at::<K>(points, &Root::exactly(0.5, Ordering::Less)) {
            let touches = FirstContact::<K>::of(points).is_some();
            assert_eq!(found == Position::Inside, touches, "{points:?}");
            known[usize::from(touches)] += 1;
        }
    }
    assert!(known.iter().all(|&count| count > 20), "{known:?}");
}

#[test]
fn positions_in_a_plane_are_those_of_the_definition() {
    positions::<VertexFace>();
    positions::<EdgeEdge>();
}
