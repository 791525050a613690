//! A format of few numbers in all floating-point environments: the code that rounds outward runs on all of
//! them.

use core::ops::{Add, Sub};

use super::{Format, difference_below, sum_above};

/// The binary digits of a significand.
const DIGITS: u32 = 5;

/// The exponent of the least normal number, and of the largest one.
const EXPONENTS: [i32; 2] = [-6, 7];

/// A direction of rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Direction {
    Nearest,
    Up,
    Down,
    Zero,
}

/// The arithmetic of a thread.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Environment {
    direction: Direction,
    /// True if subnormal operands and results are zero.
    is_flushed: bool,
}

/// A number of the format.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Small {
    value: f64,
    /// None for a constant, which takes the environment of the other operand.
    environment: Option<Environment>,
}

impl Environment {
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        use Direction::{Down, Nearest, Up, Zero};
        [Nearest, Up, Down, Zero].into_iter().flat_map(|direction| {
            [false, true].map(|is_flushed| Self {
                direction,
                is_flushed,
            })
        })
    }

    /// All finite numbers.
    pub(crate) fn numbers(self) -> impl Iterator<Item = Small> {
        let values = core::iter::successors(Some(-largest()), |&x| Some(above(x)).filter(|x| x.is_finite()));
        values.map(move |value| Small {
            value,
            environment: Some(self),
        })
    }

    fn flushed(self, x: f64) -> f64 {
        if self.is_flushed && x.abs() < least_normal() {
            0.0
        } else {
            x
        }
    }

    /// A real number, rounded.
    fn rounded(self, x: f64) -> f64 {
        let (low, high) = neighbours(x);
        let is_low = match self.direction {
            Direction::Up => low == x,
            Direction::Down => true,
            Direction::Zero => x > 0.0 || low == x,
            // To even: of two neighbours, one is a multiple of twice their distance.
            Direction::Nearest => {
                let (below, above) = (x - low, high - x);
                below < above || (below == above && (low / (high - low)) % 2.0 == 0.0)
            }
        };
        let rounded = if is_low { low } else { high };
        self.flushed(match self.direction {
            // A number beyond the largest one, towards zero, is the largest one.
            Direction::Zero => rounded.clamp(-largest(), largest()),
            Direction::Nearest if rounded.abs() > largest() => rounded * f64::INFINITY,
            Direction::Up if rounded < -largest() => -largest(),
            Direction::Down if rounded > largest() => largest(),
            _ if rounded.abs() > largest() => rounded * f64::INFINITY,
            _ => rounded,
        })
    }
}

fn least_normal() -> f64 {
    f64::from(EXPONENTS[0]).exp2()
}

fn largest() -> f64 {
    f64::from(EXPONENTS[1] + 1).exp2() - unit(f64::from(EXPONENTS[1]).exp2())
}

/// The unit in the last place.
fn unit(x: f64) -> f64 {
    let exponent = if x.abs() < least_normal() {
        EXPONENTS[0]
    } else {
        x.abs().log2().floor() as i32
    };
    f64::from(exponent + 1 - DIGITS as i32).exp2()
}

/// The largest number not above a real one, and the least one not below it, as if exponents were not limited.
fn neighbours(x: f64) -> (f64, f64) {
    let unit = unit(x);
    ((x / unit).floor() * unit, (x / unit).ceil() * unit)
}

/// The next larger number.
fn above(x: f64) -> f64 {
    if x == f64::NEG_INFINITY {
        return -largest();
    }
    // Below a power of two, seen from zero, the unit is half as large.
    let next = x + unit(if x < 0.0 { x + 0.25 * unit(x) } else { x });
    if next > largest() { f64::INFINITY } else { next }
}

impl Small {
    pub(crate) fn value(self) -> f64 {
        self.value
    }

    /// The least number that is not below a real one.
    pub(crate) fn least_above(x: f64) -> f64 {
        neighbours(x).1
    }

    fn combined(self, other: Self, operation: impl Fn(f64, f64) -> f64) -> Self {
        let environment = self
            .environment
            .or(other.environment)
            .expect("one is no constant");
        let exact = operation(environment.flushed(self.value), environment.flushed(other.value));
        Self {
            value: if exact.is_finite() {
                environment.rounded(exact)
            } else {
                exact
            },
            environment: Some(environment),
        }
    }
}

impl Add for Small {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.combined(other, |a, b| a + b)
    }
}

impl Sub for Small {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.combined(other, |a, b| a - b)
    }
}

impl Format for Small {
    // 2⁻⁴.
    const FLUSHED: Self = Self {
        value: 0.0625,
        environment: None,
    };

    fn is_zero(self) -> bool {
        self.value == 0.0
    }

    fn halved(self) -> Self {
        self.combined(self, |x, _| 0.5 * x)
    }

    fn next_up(self) -> Self {
        let value = if self.value == f64::INFINITY {
            self.value
        } else {
            above(self.value)
        };
        Self { value, ..self }
    }

    fn next_down(self) -> Self {
        let value = if self.value == f64::NEG_INFINITY {
            self.value
        } else {
            -above(-self.value)
        };
        Self { value, ..self }
    }
}

#[test]
fn the_format_has_its_numbers() {
    assert_eq!(Small::FLUSHED.value, 4.0 * least_normal());
    assert_eq!(<f64 as Format>::FLUSHED, 4.0 * f64::MIN_POSITIVE);
    for environment in Environment::all() {
        let numbers: Vec<f64> = environment.numbers().map(Small::value).collect();
        // 16 subnormal ones with 0, 16 for each exponent, and the negative ones.
        assert_eq!(numbers.len(), 2 * (16 + 16 * 14) - 1);
        assert!(numbers.is_sorted_by(|a, b| a < b));
        assert!(numbers.iter().all(|&x| neighbours(x) == (x, x)));
        assert!(numbers.iter().all(|&x| numbers.contains(&-x)));
    }
}

#[test]
fn sums_and_differences_of_all_small_numbers_are_outward() {
    for environment in Environment::all() {
        for a in environment.numbers() {
            for b in environment.numbers() {
                assert!(sum_above(a, b).value >= a.value + b.value, "{a:?} {b:?}");
                assert!(difference_below(a, b).value <= a.value - b.value, "{a:?} {b:?}");
            }
        }
    }
}
