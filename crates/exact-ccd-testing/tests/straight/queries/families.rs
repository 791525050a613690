//! Families of queries with a distance.

use exact_ccd::{EdgeEdge, Kind, Separation};

use proptest::prelude::*;

use exact_ccd_testing::alphabet::ALPHABET;
use exact_ccd_testing::families::{
    degenerate, exact_contacts, few_values, fractions, grazing, integers, nearly, quarters, rounded_contacts,
    scattered, small_integers, stretched, subnormal,
};
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::primitives::Points;

/// A rule for the distance of a query.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Rule {
    /// This distance.
    Fixed(f64),
    /// The distance of the primitives at this time, rounded down or up, and some f64 away from it.
    Reached { t: f64, up: bool, steps: i8 },
    /// This fraction of the distance at t = 0.
    FractionOfStart(f64),
}

impl Rule {
    pub(crate) fn separation<K: Kind>(self, points: &Points) -> Separation {
        let bounds = |t| query::<K>(points).distance_at(t).unwrap();
        let d = match self {
            Self::Fixed(d) => d,
            Self::Reached { t, up, steps } => {
                let bounds = bounds(t);
                let d = if up { bounds.upper } else { bounds.lower };
                let next = if steps < 0 { f64::next_down } else { f64::next_up };
                (0..steps.unsigned_abs()).fold(d, |d, _| next(d))
            }
            Self::FractionOfStart(fraction) => bounds(0.0).lower * fraction,
        };
        Separation::new(d.clamp(0.0, f64::MAX)).unwrap()
    }
}

/// Distances that the primitives have at some time, and other distances.
pub(crate) fn rule() -> impl Strategy<Value = Rule> + Clone {
    let t = prop_oneof![prop::sample::select(vec![0.0, 0.25, 0.5, 0.75, 1.0]), 0.0..1.0,];
    let reached = (t, any::<bool>(), -2..=2i8).prop_map(|(t, up, steps)| Rule::Reached { t, up, steps });
    let fixed = prop_oneof![
        3 => prop::sample::select(vec![0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0]),
        1 => prop::sample::select(ALPHABET.as_slice()).prop_map(f64::abs),
        1 => 0.0..1.0,
    ];
    prop_oneof![
        3 => reached,
        3 => fixed.prop_map(Rule::Fixed),
        2 => (0.0..1.0).prop_map(Rule::FractionOfStart),
    ]
}

/// Points of ordinary magnitude, degenerate ones among them.
pub(crate) fn ordinary() -> impl Strategy<Value = Points> {
    let grazing = (small_integers(4), quarters())
        .prop_map(|(points, place)| grazing::<EdgeEdge>(points, place, [1.0, -1.0]));
    prop_oneof![
        4 => small_integers(2),
        3 => small_integers(6),
        4 => degenerate(small_integers(2)),
        2 => exact_contacts::<EdgeEdge>(integers()),
        2 => grazing,
        2 => degenerate(fractions()),
        2 => fractions(),
        1 => nearly(degenerate(small_integers(2))),
        1 => rounded_contacts::<EdgeEdge>(),
    ]
}

/// Points of any magnitude.
pub(crate) fn extreme() -> impl Strategy<Value = Points> {
    prop_oneof![
        4 => subnormal(small_integers(8)),
        2 => stretched(degenerate(small_integers(4))),
        1 => scattered(degenerate(small_integers(4))),
        1 => few_values(),
    ]
}

/// Fewer cases where arithmetic is checked.
pub(crate) const fn cases(release: u32) -> u32 {
    if cfg!(debug_assertions) {
        release / 16 + 1
    } else {
        release
    }
}
