//! The bound of the error of the sine.

use crate::fixed::Fixed;

#[path = "../../src/sine.rs"]
mod source;

#[test]
fn the_sine_is_within_its_bound_of_series_in_integers() {
    let mut random = fastrand::Rng::with_seed(1);
    // Without a right angle, and with some.
    let mut worst = [0.0_f64; 2];
    for case in 0..40_000 {
        // Angles from 2⁻⁶⁰ to 2²⁰, some of them near multiples of π / 4.
        let angle = if case % 4 == 0 {
            let turns = f64::from(random.i32(-1_000_000..1_000_000));
            let angle = turns * std::f64::consts::FRAC_PI_4;
            angle + angle * f64::EPSILON * f64::from(random.i32(-4..5))
        } else {
            (random.f64() - 0.5) * 2.0_f64.powi(random.i32(-60..21))
        };
        let [sine, _] = Fixed::from(angle).sine_and_cosine();
        let (computed, bound) = source::sine(angle);
        let error = Fixed::from(computed).minus(&sine).to_f64().abs();
        assert!(error <= bound, "{angle}: off by {error}, {bound} at most");
        if angle != 0.0 {
            let place = usize::from(angle.abs() > 0.79);
            worst[place] = worst[place].max(error / bound);
        }
    }
    println!("largest shares of the bounds: {worst:?}");
    // A quarter of either bound is too small.
    assert!(worst.iter().all(|&share| share > 0.25), "{worst:?}");
}

#[test]
fn the_sine_of_large_numbers_is_between_its_limits() {
    for angle in [1_048_576.1, -1e300, f64::MAX] {
        assert_eq!(source::sine(angle), (0.0, 1.0));
    }
    assert_eq!(source::sine(0.0), (0.0, 0.0));
}
