//! The ranges of axes and the format of their numbers.

use std::ops::Range;

use plotters::coord::combinators::{BindKeyPoints, IntoLogRange, LogCoord, WithKeyPoints};

/// Values beyond a power of ten by at most this, in powers of ten, get no further decade.
const SLACK: f64 = 0.15;

/// The largest number of decades of an axis, so that its labels fit.
const MOST_DECADES: i32 = 40;

/// The largest magnitude of a number on an axis.
pub const GREATEST: f64 = 1e300;

/// The ends of a logarithmic axis for the values that are positive, normal and at most [`GREATEST`].
///
/// The ends are the powers of ten around the values. Where values are only slightly beyond a power
/// of ten, the end is the extreme value itself. The ends are at least one decade and at most forty decades
/// apart: the lowest decades are left out.
#[must_use]
pub fn decades(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let positive = values.filter(|value| value.is_normal() && (0.0..=GREATEST).contains(value));
    let (least, most) = positive.fold((f64::INFINITY, 0.0_f64), |(least, most), value| {
        (least.min(value), most.max(value))
    });
    if least > most {
        return (0.1, 1.0);
    }
    let (low, high) = (least.log10(), most.log10());
    let power = |exponent: f64| 10f64.powi(exponent as i32);
    let first = if low.ceil() - low < SLACK {
        least
    } else {
        power(low.floor()).min(least)
    };
    let last = if high - high.floor() < SLACK {
        most
    } else {
        power(high.ceil()).max(most)
    };
    let last = last.max(10.0 * first);
    (first.max(last / 10f64.powi(MOST_DECADES)), last)
}

/// The space between the curves and the frame at each end of an axis, as a fraction of the axis.
const MARGIN: f64 = 0.03;

/// A linear axis for numbers between two finite ones, with a margin at both ends: no curve is drawn on the
/// frame.
#[must_use]
pub fn linear(first: f64, last: f64) -> Range<f64> {
    let margin = MARGIN * last - MARGIN * first;
    first - margin..last + margin
}

/// A logarithmic axis for numbers between two positive ones, with a margin at both ends. It has marks at the
/// powers of ten and, over less than two decades, also at twice and five times these.
#[must_use]
pub fn logarithmic(first: f64, last: f64) -> WithKeyPoints<LogCoord<f64>> {
    let steps: &[f64] = if last / first < 100.0 {
        &[1.0, 2.0, 5.0]
    } else {
        &[1.0]
    };
    let exponents = first.log10().floor() as i32..=last.log10().ceil() as i32;
    let marks = exponents.flat_map(|exponent| {
        let power = 10f64.powi(exponent);
        steps.iter().map(move |step| step * power)
    });
    // Computed powers of ten may be inexact.
    let around = first * (1.0 - 1e-9)..=last * (1.0 + 1e-9);
    let marks: Vec<f64> = marks.filter(|mark| around.contains(mark)).collect();
    let margin = (last / first).powf(MARGIN);
    (first / margin..last * margin).log_scale().with_key_points(marks)
}

/// A time, given in s, in ns, µs, ms or s.
#[must_use]
pub fn seconds(time: &f64) -> String {
    // A computed power of ten may be slightly too small.
    match *time * (1.0 + 1e-9) {
        ..1e-6 => format!("{:.0} ns", 1e9 * time),
        1e-6..1e-3 => format!("{:.0} µs", 1e6 * time),
        1e-3..1.0 => format!("{:.0} ms", 1e3 * time),
        _ => format!("{time:.0} s"),
    }
}

#[cfg(test)]
mod tests {
    use plotters::coord::ranged1d::{BoldPoints, Ranged};

    use super::{decades, linear, logarithmic, seconds};

    #[test]
    fn axes_have_marks_at_least_at_powers_of_ten() {
        let marks = |first: f64, last: f64| logarithmic(first, last).key_points(BoldPoints(20));
        assert_eq!(marks(1e-3, 1.0), [1e-3, 1e-2, 1e-1, 1.0]);
        assert_eq!(marks(0.012, 0.1), [0.02, 0.05, 0.1]);
        for (first, last) in [(1e-9, 1e-8), (1.2e-3, 0.013), (1e-40, 1.0), (9.0, 90.0)] {
            assert!(marks(first, last).len() > 1, "{first} {last}");
        }
    }

    #[test]
    fn axes_contain_all_values_in_few_decades() {
        for values in [
            [3.0, 3.0],
            [1.0, 1.0],
            [0.99, 20.0],
            [9.0, 11.0],
            [1e4, 1.05e7],
            [1e-300, 9e-280],
            [1e290, 1e300],
        ] {
            let (first, last) = decades(values.into_iter());
            let [least, most] = values;
            assert!(first <= least && most <= last, "{values:?}");
            let decades = (last / first).log10();
            assert!(
                decades < (most / least).log10() + 2.0 && decades > 0.99,
                "{values:?}"
            );
        }
        let nothing = [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-320, 1e308];
        assert_eq!(decades(nothing.into_iter()), (0.1, 1.0));
        assert_eq!(decades([1e-300, 1.0].into_iter()), (1e-40, 1.0));
    }

    /// The ends of an axis are beyond all its values.
    #[test]
    fn curves_are_not_on_the_frame() {
        for (first, last) in [(0.0, 1.0), (-1e300, 1e300), (3.0, 4.0), (0.0, 1e-300)] {
            let axis = linear(first, last);
            assert!(
                axis.start < first && last < axis.end && axis.end.is_finite(),
                "{axis:?}"
            );
        }
        for (first, last) in [(1e-3, 1.0), (0.012, 0.12), (1e-40, 1.0), (1e290, 1e300)] {
            let axis = logarithmic(first, last).range();
            assert!(
                axis.start < first && last < axis.end && axis.end.is_finite(),
                "{axis:?}"
            );
        }
    }

    #[test]
    fn times_are_short() {
        let times = [1e-8, 1e-6, 10f64.powf(-3.0), 0.5, 100.0].map(|x| seconds(&x));
        assert_eq!(times, ["10 ns", "1 µs", "1 ms", "500 ms", "100 s"]);
    }
}
