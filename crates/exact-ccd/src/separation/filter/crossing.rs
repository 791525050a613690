//! The first time within d between two adjacent f64, where D decreases through d.

use super::bounds::PreciseCorners;
use super::closest::{Closest, dot};
use super::corners::Scaled;
use crate::filter::{DoubleDouble, Number};
use crate::kind::Kind;
use crate::query::{Point, Query};
use crate::time::ContactTime;

/// The first time within d, or none, when D > d is known up to the time `free`; `None` if that is not certain.
///
/// Newton's method guesses an f64 t, and two proofs make it certain: along the direction of the closest points at t, all
/// corners are beyond d at `free` and at t, hence at all times between, for they move at constant speed; and at the
/// next f64 after t, some points of the primitives are less than d apart.
pub(super) fn first_after<K: Kind>(
    query: &Query<K>,
    scaled: &Scaled,
    free: f64,
) -> Option<Option<ContactTime>> {
    if !scaled.d_is_exact {
        return None;
    }
    let corners = PreciseCorners::new(query, scaled);
    let floor = newton::<K>(scaled, &corners, free)?;
    let now = corners.at(floor);
    let direction = now.direction(Closest::guess::<K>(&now.rounded()));
    if !(now.are_beyond(direction) && corners.at(free).are_beyond(direction)) {
        return None;
    }
    if floor == 1.0 {
        return Some(None);
    }
    let next = corners.at(floor.next_up());
    next.are_within(Closest::guess::<K>(&next.rounded()))
        .then(|| Some(ContactTime::just_above(floor)))
}

/// A guess of the largest f64 in [`free`, 1] before D first reaches d.
fn newton<K: Kind>(scaled: &Scaled, corners: &PreciseCorners, free: f64) -> Option<f64> {
    const STEPS: usize = 10;
    let [start, end] = &scaled.at;
    let velocities: [Point; 4] =
        [0, 1, 2, 3].map(|i: usize| [0, 1, 2].map(|axis: usize| end[i][axis] - start[i][axis]));
    let mut floor = free;
    for _ in 0..STEPS {
        let now = corners.at(floor);
        let rounded = now.rounded();
        let closest = Closest::guess::<K>(&rounded);
        // (|F|² − d²)′ = 2 F · F′.
        let slope = 2.0 * dot(closest.point(&rounded), closest.point(&velocities));
        let step = -now.excess(closest).value() / slope;
        if slope.is_nan() || slope >= 0.0 {
            return None;
        }
        let next = down(floor, step).clamp(free, 1.0);
        if next == floor {
            return Some(floor);
        }
        floor = next;
    }
    None
}

/// a + b, rounded down.
fn down(a: f64, b: f64) -> f64 {
    let sum = a + b;
    let exact = DoubleDouble::difference(a, -b);
    let error = exact - DoubleDouble::difference(sum, 0.0);
    if error.value() < 0.0 { sum.next_down() } else { sum }
}
