//! Cases whose answers can be worked out by hand.

mod degenerate;
mod extreme_numbers;
mod impact;
mod thresholds;
mod touching;

use exact_ccd::{Kind, Query, Separation};

use crate::queries::named_cases::{FACE, touches_within, vertex_against};

fn within(d: f64) -> Separation {
    Separation::new(d).unwrap()
}

/// Within d in these intervals, whose ends are all f64.
#[track_caller]
fn is_within<K: Kind>(query: &Query<K>, d: f64, expected: &[[f64; 2]]) {
    touches_within(query, within(d), expected);
}
