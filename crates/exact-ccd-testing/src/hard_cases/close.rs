//! Families of queries in contact, exactly or but for a few units in the last place: all arithmetic on small
//! integers is exact.

use exact_ccd::Kind;

use super::Family;
use super::hard::Hard;
use super::random::Random;
use crate::alphabet::ALPHABET;
use crate::changes::{Change, nudge, scaled};
use crate::contacts::{grazing, touching};
use crate::primitives::{Points, Primitives, combine};

/// The families of a kind of query, by name.
pub(crate) fn families<K: Hard>() -> [(&'static str, Family); 17] {
    [
        ("contact", contact::<K>),
        ("contact, products round", contact_of_large_integers::<K>),
        ("contact at corners", contact_at_corners::<K>),
        ("contact at corners, neighbours", |random| {
            neighbour(contact_at_corners::<K>, random)
        }),
        ("contact up to rounding", rounded_contact::<K>),
        ("narrow miss", narrow_miss::<K>),
        ("tangent", tangent::<K>),
        ("tangent, neighbours", |random| neighbour(tangent::<K>, random)),
        ("tangent, an exponent for each axis", stretched_tangent::<K>),
        ("flat extremum", flat_extremum::<K>),
        ("flat extremum, neighbours", |random| {
            neighbour(flat_extremum::<K>, random)
        }),
        ("coplanar at all times", coplanar::<K>),
        ("parallel", parallel::<K>),
        ("parallel, neighbours", |random| neighbour(parallel::<K>, random)),
        ("degenerate", degenerate),
        ("degenerate, neighbours", |random| neighbour(degenerate, random)),
        ("special numbers", special_numbers),
    ]
}

/// Some coordinates moved by a few units in the last place.
fn neighbour(family: Family, random: &mut Random) -> Points {
    let points = family(random);
    let nudges = [0; 3].map(|_| {
        let place = [random.below(2), random.below(4), random.below(3)];
        (place, random.integer(2) as i8)
    });
    nudge(points, &nudges)
}

fn contact<K: Hard>(random: &mut Random) -> Points {
    let points = random.points(|random| random.integer(8));
    touching::<K::Four>(points, K::in_place(random.place()))
}

fn contact_of_large_integers<K: Hard>(random: &mut Random) -> Points {
    let points = random.points(|random| random.integer(1 << 30));
    touching::<K::Four>(points, K::in_place(random.place()))
}

/// At the start or at the end of the step, and at corners of the domain.
fn contact_at_corners<K: Hard>(random: &mut Random) -> Points {
    let points = random.points(|random| random.integer(4));
    let corners = K::Four::DOMAIN;
    let [u, v] = corners[random.below(corners.len())];
    touching::<K::Four>(points, K::in_place([random.below(2) as f64, u, v]))
}

fn rounded_contact<K: Hard>(random: &mut Random) -> Points {
    let points = random.fractions();
    let place = [0; 3].map(|_| 0.5 * random.fraction() + 0.5);
    touching::<K::Four>(points, K::in_place(place))
}

/// A contact missed by any power of two, from far above to far below the rounding errors.
fn narrow_miss<K: Hard>(random: &mut Random) -> Points {
    let mut points = contact::<K>(random);
    let (offset, size) = ([0; 3].map(|_| random.fraction()), -(random.below(120) as i32));
    for point in points.iter_mut().flat_map(|now| &mut now[..K::Four::FIRST]) {
        *point = combine([1.0, scaled(1.0, size)], [*point, offset]);
    }
    points
}

/// Contact with a relative velocity in the common plane: a double root of the cubic.
fn tangent<K: Hard>(random: &mut Random) -> Points {
    let points = random.points(|random| random.integer(4));
    let place = K::in_place(random.place());
    grazing::<K::Four>(points, place, [random.integer(2), random.integer(2)])
}

fn stretched_tangent<K: Hard>(random: &mut Random) -> Points {
    let exponents = [0; 3].map(|_| random.below(2000) as i32 - 1000);
    let points = tangent::<K>(random);
    points.map(|now| now.map(|point| [0, 1, 2].map(|axis: usize| scaled(point[axis], exponents[axis]))))
}

/// The three vectors w, e₁, e₂ between the primitives, along three directions: their lengths vanish at times
/// in eighths, which are the roots of the cubic, double or triple if they are the same.
fn flat_extremum<K: Hard>(random: &mut Random) -> Points {
    let all = random.below(9) as f64;
    let times = [0; 3].map(|_| {
        if random.below(2) == 0 {
            all
        } else {
            random.below(9) as f64
        }
    });
    let directions = [0; 3].map(|axis| {
        let mut direction = [0; 3].map(|_| random.integer(1));
        direction[axis] += 2.0;
        direction
    });
    let origin = [0; 3].map(|_| random.integer(2));
    let [[i, j], [k, last]] = K::SPANNING;
    [0.0, 8.0].map(|now| {
        let along = |which: usize| directions[which].map(|x| x * (now - times[which]));
        let mut points = [origin; 4];
        // e₁ = xⱼ − xᵢ, e₂ = x_last − x_k, and w from one primitive to the other.
        points[j] = combine([1.0, 1.0], [points[i], along(0)]);
        if k != i {
            points[k] = combine([1.0, 1.0], [origin, along(2)]);
        } else {
            points[0] = combine([1.0, 1.0], [origin, along(2)]);
        }
        points[last] = combine([1.0, 1.0], [points[k], along(1)]);
        points
    })
}

/// In a plane across an axis at each end of the step, with contact.
fn coplanar<K: Hard>(random: &mut Random) -> Points {
    let mut points = random.points(|random| random.integer(4));
    Change::Flatten(random.below(3)).apply(&mut points);
    touching::<K::Four>(points, K::in_place(random.place()))
}

/// e₂ is a multiple of e₁ at one end or at both; then moved into contact.
fn parallel<K: Hard>(random: &mut Random) -> Points {
    let mut points = random.points(|random| random.integer(4));
    let [[i, j], [k, last]] = K::SPANNING;
    let factor = random.integer(2);
    let both = random.below(2) == 0;
    for now in points.iter_mut().take(if both { 2 } else { 1 }) {
        now[last] = combine([factor, -factor, 1.0], [now[j], now[i], now[k]]);
    }
    touching::<K::Four>(points, K::in_place(random.place()))
}

/// Points that coincide, rest, or are collinear or coplanar.
fn degenerate(random: &mut Random) -> Points {
    let mut points = random.points(|random| random.integer(2));
    for _ in 0..=random.below(3) {
        let change = match random.below(8) {
            0 | 1 => Change::Rest(random.below(4)),
            2 => Change::Drift(random.below(4)),
            3 => Change::Flatten(random.below(3)),
            _ => Change::Combine {
                points: random.order(),
                factors: [random.integer(2) as i8, random.integer(1) as i8],
                ends: [[true, true], [true, false], [false, true]][random.below(3)],
            },
        };
        change.apply(&mut points);
    }
    points
}

/// Two to four values for all coordinates.
fn special_numbers(random: &mut Random) -> Points {
    let values = [0; 4].map(|_| ALPHABET[random.below(ALPHABET.len())]);
    let count = 2 + random.below(3);
    random.points(|random| values[random.below(count)])
}
