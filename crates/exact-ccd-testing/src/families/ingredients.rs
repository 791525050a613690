//! The parts from which families are composed.

use proptest::prelude::*;

use crate::changes::Change;

pub(crate) fn change() -> impl Strategy<Value = Change> {
    let combine = (
        Just([0, 1, 2, 3]).prop_shuffle(),
        [-1..=2i8, -1..=1i8],
        prop::sample::select(vec![[true, true], [true, true], [true, false], [false, true]]),
    )
        .prop_map(|(points, factors, ends)| Change::Combine {
            points,
            factors,
            ends,
        });
    prop_oneof![
        6 => combine,
        2 => (0..4usize).prop_map(Change::Rest),
        1 => (0..4usize).prop_map(Change::Drift),
        1 => (0..3usize).prop_map(Change::Flatten),
    ]
}

pub(crate) fn nudges() -> impl Strategy<Value = Vec<([usize; 3], i8)>> {
    let place = [0..2usize, 0..4usize, 0..3usize];
    prop::collection::vec((place, -4..=4i8), 1..5)
}

/// Quarters, which are exact on small integers.
pub fn quarters() -> impl Strategy<Value = [f64; 3]> {
    [0..=4u8, 0..=4u8, 0..=4u8].prop_map(|parameters| parameters.map(|n| f64::from(n) / 4.0))
}

/// Points of the unit cube, with some preference for its boundary and for simple fractions.
pub(crate) fn parameters() -> impl Strategy<Value = [f64; 3]> {
    let parameter = || {
        prop_oneof![
            3 => 0.0..1.0,
            1 => prop::sample::select(vec![0.0, 1.0, 0.5, 1.0 / 3.0, 0.1, 1e-10, 1e-200]),
        ]
    };
    [parameter(), parameter(), parameter()]
}
