//! The answers of the fast path are those of the exact path, bit for bit.

use std::cell::RefCell;

use exact_ccd::VertexFace;
use exact_ccd::separation::SeparationStage;
use proptest::prelude::*;

use crate::families::{cases, extreme, ordinary, rule};
use crate::kinds::{FromFour, for_each_kind};
use crate::laws::checked_intervals;
use crate::primitives::Points;
use crate::runner::for_all;

fn agrees<K: FromFour>(count: u32, points: impl Strategy<Value = Points>) {
    for_all(cases(count), (points, rule()), |(points, rule)| {
        checked_intervals(&K::query(&points), rule.separation::<K>(&points));
    });
}

fn ordinary_points<K: FromFour>() {
    agrees::<K>(100_000, ordinary());
}

fn extreme_points<K: FromFour>() {
    agrees::<K>(2_000, extreme());
}

for_each_kind! {
    on_ordinary_points => ordinary_points;
    on_extreme_points => extreme_points;
}

/// Every stage must occur, so that the comparison covers all filters.
#[test]
fn every_stage_settles_some_queries() {
    let stages = RefCell::new(Vec::new());
    for_all(2_000, (ordinary(), rule()), |(points, rule)| {
        let d = rule.separation::<VertexFace>(&points);
        let (_, stage) = VertexFace::query(&points).first_within_with_stage(d);
        stages.borrow_mut().push(stage);
    });
    for stage in SeparationStage::ALL {
        assert!(stages.borrow().contains(&stage), "{stage:?}");
    }
}
