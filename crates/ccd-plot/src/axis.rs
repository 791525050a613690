//! Where axes end, and how their numbers are written.

/// How far beyond a power of ten values may be, in powers of ten, without that another decade is shown for them.
const SLACK: f64 = 0.15;

/// The ends of a logarithmic axis for all values that are positive and finite: powers of ten around them, at least one decade. The
/// last power is left out where values are only a little beyond the one before.
#[must_use]
pub fn decades(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let positive = values.filter(|value| *value > 0.0 && value.is_finite());
    let (least, most) = positive
        .map(f64::log10)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), power| {
            (least.min(power), most.max(power))
        });
    if least > most {
        return (0.1, 1.0);
    }
    let first = if least.ceil() - least < SLACK {
        least
    } else {
        least.floor()
    };
    let last = if most - most.floor() < SLACK {
        most
    } else {
        most.ceil()
    };
    (10f64.powf(first), 10f64.powf(last.max(first + 1.0)))
}

/// A number, with three digits at most.
#[must_use]
pub fn number(number: &f64) -> String {
    let rounded: f64 = format!("{number:.2e}").parse().unwrap_or(*number);
    if rounded == 0.0 || (1e-3..1e5).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// A time in s, in the unit that suits it.
#[must_use]
pub fn seconds(time: &f64) -> String {
    // A power of ten, as it is computed, may be a little less than that.
    match *time * (1.0 + 1e-9) {
        ..1e-6 => format!("{:.0} ns", 1e9 * time),
        1e-6..1e-3 => format!("{:.0} µs", 1e6 * time),
        1e-3..1.0 => format!("{:.0} ms", 1e3 * time),
        _ => format!("{time:.0} s"),
    }
}

#[cfg(test)]
mod tests {
    use super::{decades, number, seconds};

    #[test]
    fn axes_hold_all_values_in_few_decades() {
        for values in [
            vec![3.0],
            vec![1.0],
            vec![0.99, 20.0],
            vec![1e-300, 1e300],
            vec![9.0, 11.0],
            vec![1e4, 1.05e7],
        ] {
            let (first, last) = decades(values.iter().copied());
            let decades = (last / first).log10();
            let (least, most) = (values[0], values[values.len() - 1]);
            assert!(first <= least && most <= last, "{values:?}");
            assert!(decades < (most / least).log10() + 2.0, "{values:?}");
        }
        let nothing = [0.0, -1.0, f64::NAN, f64::INFINITY];
        assert_eq!(decades(nothing.into_iter()), (0.1, 1.0));
    }

    #[test]
    fn numbers_are_short() {
        let numbers = [0.0, 0.30000000000000004, 1500.0, -2.5e7, 1e-4].map(|x| number(&x));
        assert_eq!(numbers, ["0", "0.3", "1500", "-2.5e7", "1e-4"]);
        let times = [1e-8, 1e-6, 10f64.powf(-3.0), 0.5, 100.0].map(|x| seconds(&x));
        assert_eq!(times, ["10 ns", "1 µs", "1 ms", "500 ms", "100 s"]);
    }
}
