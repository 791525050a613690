//! Points that coincide with each other, or move along a line or together.

use super::Family;
use super::random::Random;
use crate::primitives::Points;

/// The families, by name.
pub const FAMILIES: [(&str, Family); 5] = [
    ("all points equal at t = 0", equal_at_start),
    ("all points equal at t = 1", equal_at_end),
    ("all points equal at both ends", equal_at_both_ends),
    ("a common trajectory", same_trajectory),
    ("all points on a line along an axis", on_a_line),
];

/// Points with few different coordinates.
fn small(random: &mut Random) -> Points {
    random.points(|random| random.integer(2))
}

fn equal_at_start(random: &mut Random) -> Points {
    let mut points = small(random);
    points[0] = [points[0][0]; 4];
    points
}

fn equal_at_end(random: &mut Random) -> Points {
    let [start, end] = equal_at_start(random);
    [end, start]
}

fn equal_at_both_ends(random: &mut Random) -> Points {
    small(random).map(|now| [now[0]; 4])
}

/// The first point of each primitive with the same trajectory, whatever the kind.
fn same_trajectory(random: &mut Random) -> Points {
    small(random).map(|[a, b, _, c]| [a, b, c, a])
}

fn on_a_line(random: &mut Random) -> Points {
    small(random).map(|now| now.map(|point| [now[0][0], point[1], now[0][2]]))
}
