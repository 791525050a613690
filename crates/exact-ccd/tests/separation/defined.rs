//! The answers are those of the definition, computed by other means.

use std::cell::RefCell;

use crate::check::{Defined, assert_contact, assert_within};
use crate::families::{extreme, ordinary, rule};
use crate::kinds::{FromFour, for_each_kind};
use crate::runner::for_all;

fn ordinary_distances<K: FromFour + Defined>() {
    let counts = RefCell::new([0; 2]);
    for_all(250, (ordinary(), rule()), |(points, rule)| {
        let is_within = assert_within(&K::query(&points), rule.separation::<K>(&points));
        counts.borrow_mut()[usize::from(is_within)] += 1;
    });
    assert!(counts.borrow().iter().all(|&count| count > 20), "{counts:?}");
}

fn extreme_distances<K: FromFour + Defined>() {
    for_all(12, (extreme(), rule()), |(points, rule)| {
        assert_within(&K::query(&points), rule.separation::<K>(&points));
    });
}

/// Two vertices, or a vertex and an edge, have no other test of contact by families.
fn contact<K: FromFour + Defined>() {
    let counts = RefCell::new([0; 2]);
    for_all(400, ordinary(), |points| {
        counts.borrow_mut()[usize::from(assert_contact(&K::query(&points)))] += 1;
    });
    assert!(counts.borrow().iter().all(|&count| count > 5), "{counts:?}");
}

for_each_kind! {
    of_ordinary_points => ordinary_distances;
    of_extreme_points => extreme_distances;
    of_points_in_contact => contact;
}
