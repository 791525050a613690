//! The distances at which primitives touch, of a query.

use exact_ccd::{Kind, Query, Separation};

use super::random::Random;
use crate::alphabet::ALPHABET;
use crate::changes::scaled;

/// A distance that the primitives have at a time, rounded down or up, or its neighbour; a tiny one; or any.
pub(super) fn distance<K: Kind>(query: &Query<K>, random: &mut Random) -> Separation {
    let chosen = match random.below(8) {
        0 => scaled(1.0, -(random.below(974) as i32) - 100),
        1 => ALPHABET[random.below(ALPHABET.len())].abs(),
        _ => {
            let reached = query
                .distance_at(random.below(9) as f64 / 8.0)
                .map_or(0.0, |bounds| bounds.lower);
            match random.below(4) {
                0 => reached.next_down(),
                1 => reached.next_up(),
                _ => reached,
            }
        }
    };
    Separation::new(chosen.clamp(0.0, f64::MAX)).unwrap_or(Separation::ZERO)
}
