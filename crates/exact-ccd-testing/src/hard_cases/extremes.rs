//! Families of queries that are as costly as possible for exact arithmetic.

use exact_ccd::Kind;

use super::Family;
use super::hard::Hard;
use super::random::Random;
use crate::changes::scaled;
use crate::contacts::{grazing, touching};
use crate::primitives::{Points, combine};

/// The families of a kind of query, by name.
pub fn families<K: Hard>() -> [(&'static str, Family); 19] {
    [
        ("an exponent for each coordinate", any_exponent),
        ("an exponent for each point and end", exponent_per_point),
        (
            "an exponent for each axis, near-double root",
            stretched_graze::<K>,
        ),
        ("the least and the largest numbers", ends_of_the_range),
        ("small integers, two extreme coordinates", two_extremes),
        ("a few special values", few_values),
        ("any exponents, shared vertex", shared_vertex::<K>),
        ("any exponents, resting primitive", resting_primitive::<K>),
        ("any exponents, contact at t = 1", touching_at_end::<K>),
        ("double root, split by the least number", split_graze::<K>),
        ("near-double root", near_graze::<K>),
        ("nearly parallel", nearly_parallel::<K>),
        ("nearly parallel, any exponents", nearly_parallel_any::<K>),
        ("coplanar across an axis, any exponents", flat_any),
        ("coplanar at a slant, any exponents", slanted_any),
        ("collinear, any exponents", collinear_any),
        ("all points equal", all_equal),
        ("all points equal at each end", equal_at_each_end),
        ("subnormal", subnormal),
    ]
}

fn any_exponent(random: &mut Random) -> Points {
    random.points(Random::any)
}

fn exponent_per_point(random: &mut Random) -> Points {
    let mut points = random.fractions();
    for point in points.as_flattened_mut() {
        let exponent = random.below(2000) as i32 - 1000;
        *point = point.map(|x| scaled(x, exponent));
    }
    points
}

fn stretched_graze<K: Hard>(random: &mut Random) -> Points {
    let exponents = [0; 3].map(|_| random.below(2000) as i32 - 1000);
    let points = near_graze::<K>(random);
    points.map(|now| now.map(|point| [0, 1, 2].map(|axis: usize| scaled(point[axis], exponents[axis]))))
}

fn ends_of_the_range(random: &mut Random) -> Points {
    random.points(Random::extreme)
}

fn two_extremes(random: &mut Random) -> Points {
    let mut points = random.small_integers();
    for _ in 0..2 {
        points.as_flattened_mut().as_flattened_mut()[random.below(24)] = random.extreme();
    }
    points
}

fn few_values(random: &mut Random) -> Points {
    let special = [0.0, -0.0, 1.0, 3.0, 1.0 + f64::EPSILON, -0.7];
    let values = [0; 4].map(|_| match random.below(3) {
        0 => special[random.below(special.len())],
        1 => random.extreme(),
        _ => random.any(),
    });
    random.points(|random| values[random.below(values.len())])
}

fn shared_vertex<K: Hard>(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    let [i, j] = [
        random.below(K::Four::FIRST),
        K::Four::FIRST + random.below(4 - K::Four::FIRST),
    ];
    points.iter_mut().for_each(|now| now[i] = now[j]);
    points
}

fn resting_primitive<K: Hard>(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    let [start, end] = &mut points;
    end[K::Four::FIRST..].copy_from_slice(&start[K::Four::FIRST..]);
    points
}

fn touching_at_end<K: Hard>(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    let [i, j] = [
        random.below(K::Four::FIRST),
        K::Four::FIRST + random.below(4 - K::Four::FIRST),
    ];
    points[1][i] = points[1][j];
    points
}

fn split_graze<K: Hard>(random: &mut Random) -> Points {
    let (place, velocity) = (random.place(), [random.integer(2), random.integer(2)]);
    // Zeros, to which the least number can be added without rounding.
    let points = random.points(|random| {
        if random.below(2) == 0 {
            0.0
        } else {
            random.integer(4)
        }
    });
    let mut points = grazing::<K::Four>(points, K::in_place(place), velocity);
    for x in points.as_flattened_mut().as_flattened_mut() {
        if *x == 0.0 && random.below(3) == 0 {
            *x = [5e-324, -5e-324][random.below(2)];
        }
    }
    points
}

fn near_graze<K: Hard>(random: &mut Random) -> Points {
    let (place, velocity) = (random.place(), [random.fraction(), random.fraction()]);
    let points = random.fractions();
    grazing::<K::Four>(points, K::in_place(place), velocity)
}

/// e₂ is a multiple of e₁ at both ends, to within a few units in the last place; then moved into contact.
fn nearly_parallel<K: Hard>(random: &mut Random) -> Points {
    let points = random.fractions();
    let points = parallel::<K>(points, random);
    let place = random.place();
    touching::<K::Four>(points, K::in_place(place))
}

/// The same with any exponents, where the least numbers vanish beside the largest, and without contact.
fn nearly_parallel_any<K: Hard>(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    for x in points.as_flattened_mut().as_flattened_mut() {
        *x = scaled(*x, -60);
    }
    parallel::<K>(points, random)
}

/// The last point becomes that at which e₂ is a multiple of e₁, the same at both ends, but for a unit in the
/// last place.
fn parallel<K: Hard>(mut points: Points, random: &mut Random) -> Points {
    let [[i, j], [k, last]] = K::SPANNING;
    let factor = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0][random.below(6)];
    for now in &mut points {
        now[last] = combine([factor, -factor, 1.0], [now[j], now[i], now[k]]);
        let axis = random.below(3);
        now[last][axis] = now[last][axis].next_up();
    }
    points
}

fn flat_any(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    let axis = random.below(3);
    let levels = [random.any(), random.any()];
    for (now, level) in points.iter_mut().zip(levels) {
        now.iter_mut().for_each(|point| point[axis] = level);
    }
    points
}

fn slanted_any(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    points
        .as_flattened_mut()
        .iter_mut()
        .for_each(|point| point[2] = point[0]);
    points
}

fn collinear_any(random: &mut Random) -> Points {
    let mut points = random.points(Random::any);
    points
        .as_flattened_mut()
        .iter_mut()
        .for_each(|point| *point = [point[0], 0.0, -point[0]]);
    points
}

fn all_equal(random: &mut Random) -> Points {
    let point = [random.any(), random.any(), random.any()];
    [[point; 4]; 2]
}

fn equal_at_each_end(random: &mut Random) -> Points {
    [
        [[random.any(), random.any(), random.any()]; 4],
        [[random.any(), random.any(), random.any()]; 4],
    ]
}

fn subnormal(random: &mut Random) -> Points {
    random.points(|random| random.integer(8) * 5e-324)
}
