//! A runner of checks on many values.

use std::fmt::Debug;

use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};

/// Panics with the smallest value found on which the check panics. The values are the same in every
/// run. The fuzz targets generate others.
pub fn for_all<T: Debug>(cases: u32, values: impl Strategy<Value = T>, check: impl Fn(T)) {
    let config = ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::with_cases(cases)
    };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let result = TestRunner::new_with_rng(config, rng).run(&values, |value| {
        check(value);
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
}
