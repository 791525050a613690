//! The bisection, compared with its two definitions.

use exact_ccd_mesh::{Tolerance, bisect};
use fastrand::Rng;

/// Parts of a step up to which it is free, some of them tiny.
fn thresholds() -> Vec<f64> {
    let mut random = Rng::with_seed(1);
    let tiny = (0..200).map(|_| 2.0_f64.powi(-random.i32(0..200)));
    let mut thresholds: Vec<f64> = tiny.collect();
    thresholds.extend((0..200).map(|_| random.f64()));
    thresholds.extend([0.0, 0.5, 1.0, 1.5, 5e-324]);
    thresholds
}

#[test]
fn an_absolute_tolerance_bounds_the_interval() {
    fn expected(tolerance: f64, is_free: impl Fn(f64) -> bool) -> f64 {
        if is_free(1.0) {
            return 1.0;
        }
        let (mut free, mut blocked) = (0.0, 1.0);
        while blocked - free > tolerance {
            let middle = free + 0.5 * (blocked - free);
            if middle <= free || middle >= blocked {
                break;
            }
            *(if is_free(middle) { &mut free } else { &mut blocked }) = middle;
        }
        free
    }
    for threshold in thresholds() {
        for tolerance in [0.5, 1e-3, 1e-17, 1e-300] {
            let is_free = |part: f64| part < threshold;
            let found = bisect(Tolerance::Absolute(tolerance), is_free);
            assert_eq!(found.to_bits(), expected(tolerance, is_free).to_bits());
            assert!(found == 1.0 || found == 0.0 || found < threshold);
        }
    }
}

#[test]
fn a_relative_tolerance_bounds_the_interval_by_its_free_part() {
    fn expected(is_free: impl Fn(f64) -> bool) -> f64 {
        if is_free(1.0) {
            return 1.0;
        }
        let (mut free, mut blocked) = (0.0, 1.0);
        for _ in 0..100 {
            if blocked - free <= 0.125 * free {
                break;
            }
            let middle = free + 0.5 * (blocked - free);
            *(if is_free(middle) { &mut free } else { &mut blocked }) = middle;
        }
        free
    }
    for threshold in thresholds() {
        let is_free = |part: f64| part < threshold;
        let found = bisect(Tolerance::Relative(0.125), is_free);
        assert_eq!(found.to_bits(), expected(is_free).to_bits());
        assert!(!(1e-20..=1.0).contains(&threshold) || found >= 0.85 * threshold);
    }
}

/// The bisection terminates for every tolerance.
#[test]
fn a_bisection_ends() {
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for tolerance in [Tolerance::Absolute(tolerance), Tolerance::Relative(tolerance)] {
            let found = bisect(tolerance, |part| part < 0.3);
            assert!((0.0..0.3).contains(&found), "{tolerance:?}: {found}");
        }
    }
}
