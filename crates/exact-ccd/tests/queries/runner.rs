//! Runs a check on many random values.

use std::fmt::Debug;

use proptest::prelude::*;
use proptest::test_runner::TestRunner;

/// Panics with the smallest value found on which the check panics. Leaves no files behind: a failure that is worth
/// keeping becomes a test with a name.
pub(crate) fn for_all<T: Debug>(cases: u32, values: impl Strategy<Value = T>, check: impl Fn(T)) {
    let config = ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::with_cases(cases)
    };
    let result = TestRunner::new(config).run(&values, |value| {
        check(value);
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{error}"));
}
