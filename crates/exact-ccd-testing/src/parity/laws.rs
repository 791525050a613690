//! Properties of the parity of every query.

use exact_ccd::{Kind, Point};
use exact_ccd_methods::parity::{self, Parity, Rounded};

use super::{Rim, expected};

/// The parity, which is checked to be the same in integers.
pub fn checked_parity<K: Kind<Points = [Point; 4]>>(rounded: &Rounded<K>) -> Parity {
    let (parity, query) = (rounded.parity(), rounded.query());
    assert_eq!(parity, parity::rational(query), "{query:?}");
    parity
}

/// Checks that the parity agrees with the definition of contact.
pub fn assert_defined<K: Rim>(rounded: &Rounded<K>) {
    let query = rounded.query();
    assert_eq!(checked_parity(rounded), expected(query), "{query:?}");
}
