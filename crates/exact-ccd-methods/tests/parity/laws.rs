//! Properties of the parity of every query.

use exact_ccd::{Kind, Point, Query};
use exact_ccd_methods::parity::{self, Parity, Rounded};

use crate::expected::{Rim, expected};
use crate::primitives::Points;

/// The query of these points, which are finite.
pub(crate) fn query<K: Kind<Points = [Point; 4]>>(points: &Points) -> Query<K> {
    Query::new(points[0], points[1]).unwrap()
}

/// The parity, which is checked to be the same in integers.
pub(crate) fn checked_parity<K: Kind<Points = [Point; 4]>>(rounded: &Rounded<K>) -> Parity {
    let (parity, query) = (rounded.parity(), rounded.query());
    assert_eq!(parity, parity::rational(query), "{query:?}");
    parity
}

/// Checks that the parity agrees with the definition of contact.
pub(crate) fn assert_defined<K: Rim>(rounded: &Rounded<K>) {
    let query = rounded.query();
    assert_eq!(checked_parity(rounded), expected(query), "{query:?}");
}
