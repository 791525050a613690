//! The order of frames by the numbers in their names.

use std::path::PathBuf;

use exact_ccd_files::{FrameOrder, Missing};

fn order(names: &[&str]) -> FrameOrder {
    FrameOrder::of(names.iter().map(PathBuf::from).collect())
}

#[test]
fn names_are_ordered_by_the_numbers_in_them() {
    let ordered = [
        "2.ply",
        "10.ply",
        "a1b2.ply",
        "a1b10.ply",
        "a02.ply",
        "a2.ply",
        "a10.ply",
        "a.ply",
        "b0.ply",
    ];
    let mut names = ordered;
    names.reverse();
    assert_eq!(order(&names).files, ordered.map(PathBuf::from));
    assert!(order(&names).is_changed && !order(&ordered).is_changed);
}

#[test]
fn names_that_differ_in_more_than_numbers_are_found() {
    let unlike = |names: &[&str]| {
        let of_row = FrameOrder::of_row(names.iter().map(PathBuf::from).collect());
        assert_eq!(of_row.unlike, order(names).unlike);
        of_row.unlike
    };
    let pair = |names: [&str; 2]| Some(names.map(PathBuf::from));
    assert_eq!(
        unlike(&["a_0.ply", "a_1.ply", "b_0.ply", "b_1.ply"]),
        pair(["a_1.ply", "b_0.ply"])
    );
    assert_eq!(unlike(&["f1-2.ply", "f1.ply"]), pair(["f1-2.ply", "f1.ply"]));
    for alike in [
        &["a1/f0.ply", "a1/f1.ply", "a2/f0.ply"][..],
        &["t0.5.ply", "t1.25.off"],
        &["f.ply"],
        &[],
    ] {
        assert_eq!(unlike(alike), None, "{alike:?}");
    }
}

#[test]
fn missing_numbers_follow_from_the_common_step() {
    let missing = |names: &[&str]| {
        let missing = order(names).missing;
        missing.iter().map(Missing::to_string).collect::<Vec<_>>()
    };
    assert_eq!(
        missing(&["f08.ply", "f10.ply", "f11.ply", "f15.ply"]),
        ["9", "12 to 14"]
    );
    assert_eq!(
        missing(&["f0.ply", "f10.ply", "f50.ply", "f70.ply"]),
        ["20 to 40 in steps of 10", "60"]
    );
    for complete in [
        &["f1.ply", "f2.ply", "f3.ply"][..],
        &["f0.ply", "f5.ply"],
        &["f1.ply"],
        &[],
    ] {
        assert!(missing(complete).is_empty(), "{complete:?}");
    }
    // Names that differ in two numbers: the time steps of a path, and the increments of each.
    assert_eq!(
        missing(&["1-0.ply", "1-1.ply", "2-0.ply", "5-0.ply", "5-3.ply"]),
        ["3 to 4", "in 5: 1 to 2"]
    );
    assert_eq!(
        missing(&["1-0.ply", "1-2.ply", "2-0.ply", "2-6.ply"]),
        ["in 2: 2 to 4 in steps of 2"]
    );
    assert!(missing(&["1-0.ply", "1-1.ply", "2-2.ply", "2-3.ply"]).is_empty());
    assert!(missing(&["1-x0.ply", "1-x1.5.ply", "2-x4.ply", "2-x8.ply"]).is_empty());
    // Names that differ in text, or not at all, have no numbers in common.
    for other in [
        ["a1.ply", "b9.ply"],
        ["a1b1.ply", "a9b9.ply"],
        ["a1.ply", "a1.ply"],
    ] {
        assert!(missing(&other).is_empty(), "{other:?}");
    }
    assert!(missing(&["f1.ply", "f99999999999999999999.ply"]).is_empty());
    assert!(missing(&["t0.25.ply", "t0.50.ply", "t1.00.ply"]).is_empty());
}

#[test]
fn numbers_are_missing_in_the_order_given_too() {
    let missing = |names: &[&str]| {
        let order = FrameOrder::of_row(names.iter().map(PathBuf::from).collect());
        (order.is_changed, order.missing.len())
    };
    assert_eq!(missing(&["1-0.ply", "1-1.ply", "2-0.ply", "5-0.ply"]), (false, 1));
    assert_eq!(missing(&["5-0.ply", "1-0.ply", "2-0.ply", "1-1.ply"]), (false, 0));
    assert_eq!(missing(&["1-3.ply", "1-0.ply", "2-0.ply", "2-1.ply"]), (false, 0));
}

#[test]
fn a_point_between_digits_is_that_of_a_decimal() {
    let ordered = ["t0.05.ply", "t0.25.ply", "t0.50.ply", "t1.00.ply", "t10.00.ply"];
    let mut names = ordered;
    names.reverse();
    let order = FrameOrder::of_row(names.map(PathBuf::from).to_vec());
    assert_eq!(order.files, ordered.map(PathBuf::from));
    assert!(order.is_changed && order.uncertain.is_none());
    // A date is not a decimal.
    let dates = ["2026.9.30.ply", "2026.11.2.ply"];
    assert_eq!(self::order(&dates).files, dates.map(PathBuf::from));
}

#[test]
fn an_order_that_depends_on_the_meaning_of_a_point_is_uncertain() {
    for [first, second] in [["t0.25.ply", "t0.5.ply"], ["v2.10.ply", "v2.9.ply"]] {
        for given in [[first, second], [second, first]] {
            let order = FrameOrder::of_row(given.map(PathBuf::from).to_vec());
            assert_eq!(order.uncertain, Some([first, second].map(PathBuf::from)));
        }
    }
    for certain in [
        ["v2.0009.ply", "v2.0010.ply"],
        ["t0.5.ply", "t1.25.ply"],
        ["f1.ply", "f1.5.ply"],
        ["f9.ply", "f10.ply"],
    ] {
        assert_eq!(order(&certain).uncertain, None, "{certain:?}");
    }
}
