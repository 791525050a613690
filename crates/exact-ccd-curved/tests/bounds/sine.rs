//! The assumption on the sine of libm.

use crate::fixed::Fixed;

#[test]
fn the_sine_is_off_by_at_most_two_units_in_the_last_place() {
    let mut random = fastrand::Rng::with_seed(1);
    let mut worst = 0.0_f64;
    for case in 0..40_000 {
        // Angles from 2⁻⁶⁰ to 2²⁰, some of them near multiples of π / 2.
        let angle = if case % 4 == 0 {
            let turns = f64::from(random.i32(-1_000_000..1_000_000));
            let angle = turns * std::f64::consts::FRAC_PI_2;
            angle + angle * f64::EPSILON * f64::from(random.i32(-4..5))
        } else {
            (random.f64() - 0.5) * 2.0_f64.powi(random.i32(-60..21))
        };
        let [sine, _] = Fixed::from(angle).sine_and_cosine();
        let computed = libm::sin(angle);
        let difference = Fixed::from(computed).minus(&sine);
        let unit = computed.abs().next_up() - computed.abs();
        // In units in the last place: the difference as an f64 to a few digits.
        let units = difference.to_f64() / unit;
        worst = worst.max(units.abs());
    }
    println!("largest error of the sine: {worst} units in the last place");
    assert!(worst > 0.4 && worst < 1.0, "{worst}");
}
