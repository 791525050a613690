//! Coordinates at which floating-point arithmetic fails.

const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

/// Zeros, subnormals, neighbours of 1, the ends of the range, and the magnitudes at which squares
/// and cubes underflow, lose bits or overflow.
pub const ALPHABET: [f64; 40] = [
    0.0,
    -0.0,
    5e-324,
    -5e-324,
    1e-323,
    f64::MIN_POSITIVE,
    -f64::MIN_POSITIVE,
    f64::MIN_POSITIVE - 5e-324,
    1.0,
    -1.0,
    1.0 + f64::EPSILON,
    1.0 - f64::EPSILON / 2.0,
    -1.0 - f64::EPSILON,
    0.5,
    -0.5,
    2.0,
    -2.0,
    3.0,
    0.1,
    -0.7,
    1.0 / 3.0,
    1e-16,
    power_of_two(53),
    power_of_two(53) + 2.0,
    -power_of_two(53),
    power_of_two(-1000),
    power_of_two(-600),
    -power_of_two(-537),
    power_of_two(-358),
    power_of_two(-200),
    power_of_two(199),
    power_of_two(200),
    -power_of_two(200),
    power_of_two(341),
    -power_of_two(511),
    power_of_two(1000),
    1e300,
    -1e300,
    f64::MAX,
    f64::MIN,
];
