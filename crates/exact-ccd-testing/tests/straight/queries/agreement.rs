//! The filters agree with the exact path, bit for bit, and both agree with the definition.

use std::cell::RefCell;

use exact_ccd::{EdgeEdge, Kind, Separation, Stage, VertexFace};
use proptest::prelude::*;

use crate::queries::each_kind::for_each_kind;
use crate::queries::families::{Rule, cases, extreme, ordinary, rule};
use exact_ccd_testing::definition::assert_defined;
use exact_ccd_testing::families::*;
use exact_ccd_testing::kinds::query;
use exact_ccd_testing::laws::checked;
use exact_ccd_testing::primitives::{Points, Primitives};
use exact_ccd_testing::runner::for_all;

fn agrees<K: Primitives>(cases: u32, points: impl Strategy<Value = Points>) {
    for_all(cases, points, |points| {
        checked(&query::<K>(&points), Separation::ZERO);
    });
}

/// The definition is slow: it is compared on fewer cases.
fn is_defined<K: Primitives>(cases: u32, points: impl Strategy<Value = Points>) {
    for_all(cases / 200 + 4, points, |points| {
        assert_defined(&query::<K>(&points), Separation::ZERO);
    });
}

/// Tests of contact of each kind of query for each family, with the number of cases. The exact path is slow
/// on numbers of very different magnitudes.
macro_rules! agrees {
    ($($name:ident: $cases:literal, $points:expr;)*) => { $(
        mod $name {
            use super::*;

            #[test]
            fn vertex_face() {
                type K = VertexFace;
                agrees::<K>($cases, $points);
                is_defined::<K>($cases, $points);
            }

            #[test]
            fn edge_edge() {
                type K = EdgeEdge;
                agrees::<K>($cases, $points);
                is_defined::<K>($cases, $points);
            }
        }
    )* };
}

agrees! {
    on_very_small_integers: 12_000, small_integers(2);
    on_small_integers: 12_000, small_integers(8);
    on_fractions: 8_000, fractions();
    on_degenerate_integers: 12_000, degenerate(small_integers(2));
    on_degenerate_large_integers: 6_000, degenerate(large_integers());
    on_degenerate_fractions: 8_000, degenerate(fractions());
    on_exact_contacts: 10_000, exact_contacts::<K>(integers());
    on_exact_grazes: 10_000, exact_grazes::<K>(integers());
    on_rounded_contacts: 3_000, rounded_contacts::<K>();
    on_rounded_grazes: 3_000, rounded_grazes::<K>();
    on_planar_contacts: 3_000, planar_contacts::<K>();
    on_stretched_planar_contacts: 3_000, stretched(planar_contacts::<K>());
    near_planar_contacts: 3_000, nearly(planar_contacts::<K>());
    near_degenerate: 3_000, nearly(degenerate(fractions()));
    near_contact: 3_000, nearly(exact_contacts::<K>(integers()));
    near_grazing: 3_000, nearly(exact_grazes::<K>(integers()));
    on_narrow_misses: 3_000, narrow_misses::<K>(rounded_contacts::<K>());
    on_narrowly_missed_grazes: 3_000, narrow_misses::<K>(rounded_grazes::<K>());
    on_narrowly_missed_corners: 3_000, narrow_misses::<K>(exact_contacts::<K>(integers()));
    on_stretched_degenerate: 6_000, stretched(degenerate(small_integers(8)));
    on_stretched_contacts: 3_000, stretched(rounded_contacts::<K>());
    on_stretched_grazes: 6_000, stretched(exact_grazes::<K>(small_integers(8)));
    on_scattered: 500, scattered(degenerate(fractions()));
    on_subnormal: 6_000, subnormal(small_integers(8));
    on_subnormal_contacts: 3_000, subnormal(exact_contacts::<K>(small_integers(8)));
    on_few_values: 500, few_values();
    on_extremes: 200, extremes();
}

fn agrees_within<K: Kind>(
    count: u32,
    points: impl Strategy<Value = Points>,
    rule: impl Strategy<Value = Rule>,
) {
    for_all(cases(count), (points, rule), |(points, rule)| {
        checked(&query::<K>(&points), rule.separation::<K>(&points));
    });
}

fn ordinary_distances<K: Kind>() {
    agrees_within::<K>(100_000, ordinary(), rule());
}

fn extreme_distances<K: Kind>() {
    agrees_within::<K>(2_000, extreme(), rule());
}

fn contact<K: Kind>() {
    agrees_within::<K>(6_000, ordinary(), Just(Rule::Fixed(0.0)));
    agrees_within::<K>(400, extreme(), Just(Rule::Fixed(0.0)));
}

/// Checks some queries against the definition; both decisions must occur.
fn are_defined<K: Kind>(
    count: u32,
    points: impl Strategy<Value = Points>,
    rule: impl Strategy<Value = Rule>,
) {
    let counts = RefCell::new([0; 2]);
    for_all(count, (points, rule), |(points, rule)| {
        let touches = assert_defined(&query::<K>(&points), rule.separation::<K>(&points));
        counts.borrow_mut()[usize::from(touches)] += 1;
    });
    let least = count / 100;
    assert!(counts.borrow().iter().all(|&count| count > least), "{counts:?}");
}

fn defined<K: Kind>() {
    are_defined::<K>(250, ordinary(), rule());
    are_defined::<K>(12, extreme(), rule());
    are_defined::<K>(400, ordinary(), Just(Rule::Fixed(0.0)));
}

for_each_kind! {
    within_ordinary_distances => ordinary_distances;
    within_extreme_distances => extreme_distances;
    in_contact => contact;
    with_the_definition => defined;
}

/// The stages at which some queries are decided, for each kind.
fn stages<K: Kind>(points: impl Strategy<Value = Points>, rule: impl Strategy<Value = Rule>) -> Vec<Stage> {
    let stages = RefCell::new(Vec::new());
    for_all(4_000, (points, rule), |(points, rule)| {
        let stage = query::<K>(&points).decide(rule.separation::<K>(&points)).1;
        stages.borrow_mut().push(stage);
    });
    stages.into_inner()
}

/// The agreement above covers all stages.
fn every_stage_settles_some<K: Primitives>() {
    let contact = stages::<K>(mixed::<K>(), Just(Rule::Fixed(0.0)));
    let within = stages::<K>(ordinary(), rule());
    for stage in Stage::ALL {
        let (of_contact, of_distance) = match stage {
            Stage::Roots | Stage::Coincident | Stage::Planar => (true, false),
            Stage::Start | Stage::Advancement | Stage::Crossing => (false, true),
            _ => (true, true),
        };
        assert!(!of_contact || contact.contains(stage), "{stage:?} in contact");
        assert!(
            !of_distance || within.contains(stage),
            "{stage:?} within a distance"
        );
    }
}

#[test]
fn every_stage_settles_some_queries() {
    every_stage_settles_some::<VertexFace>();
    every_stage_settles_some::<EdgeEdge>();
}
