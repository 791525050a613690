//! The numbers at the marks of an axis, all written in the same way.

/// Prefixes of units with their powers of ten.
const PREFIXES: [(i32, &str); 7] = [
    (-9, "n"),
    (-6, "µ"),
    (-3, "m"),
    (0, ""),
    (3, "k"),
    (6, "M"),
    (9, "G"),
];

/// The least power of ten by which numbers are divided: the unit of the smallest numbers is out of range.
const LEAST: i32 = -300;

/// The unit of a linear axis: a power of a thousand, so that its numbers are below a thousand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scale {
    exponent: i32,
}

impl Scale {
    /// The scale of an axis whose numbers have at most this magnitude.
    #[must_use]
    pub fn of(most: f64) -> Self {
        let power = most.abs().log10();
        let exponent = if power.is_finite() {
            (3 * (power / 3.0).floor() as i32).max(LEAST)
        } else {
            0
        };
        Self { exponent }
    }

    /// A unit with its prefix, such as `kJ`; or with a power of ten where there is none.
    #[must_use]
    pub fn unit(&self, unit: &str) -> String {
        let prefix = PREFIXES.iter().find(|(exponent, _)| *exponent == self.exponent);
        match prefix {
            Some((_, prefix)) => format!("{prefix}{unit}"),
            None => format!("10{} {unit}", superscript(self.exponent)),
        }
    }

    /// A number in this unit, with at most three decimal places.
    #[must_use]
    pub fn number(&self, number: f64) -> String {
        let scaled = number / 10f64.powi(self.exponent);
        // The sum makes 0 of −0.
        ((1e3 * scaled).round() / 1e3 + 0.0).to_string()
    }
}

/// A mark of a logarithmic axis: a power of ten, or a multiple of one.
#[must_use]
pub fn power(mark: &f64) -> String {
    let text = format!("{mark:.2e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let digits = digits.trim_end_matches('0').trim_end_matches('.');
    let power = format!("10{}", superscript(exponent.parse().unwrap_or(0)));
    if digits == "1" {
        power
    } else {
        format!("{digits}·{power}")
    }
}

/// An exponent in raised digits.
fn superscript(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |letter: char| match letter.to_digit(10) {
        Some(digit) => DIGITS[digit as usize],
        None => '⁻',
    };
    exponent.to_string().chars().map(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::{Scale, power};

    #[test]
    fn all_numbers_of_a_linear_axis_have_one_unit() {
        let texts = |most: f64, marks: &[f64]| {
            let scale = Scale::of(most);
            let numbers: Vec<String> = marks.iter().map(|&mark| scale.number(mark)).collect();
            format!("{} / {}", numbers.join(" "), scale.unit("J"))
        };
        assert_eq!(texts(2.9e5, &[0.0, 5e4, 1e5, 2.5e5]), "0 50 100 250 / kJ");
        assert_eq!(texts(0.9, &[-0.0, 2.7e-17, 0.2, 0.8]), "0 0 200 800 / mJ");
        assert_eq!(texts(999.0, &[0.5, 900.0]), "0.5 900 / J");
        assert_eq!(texts(-7e13, &[-5e13]), "-50 / 10¹² J");
        assert_eq!(texts(3e-300, &[1e-300]), "1 / 10⁻³⁰⁰ J");
        assert_eq!(texts(1e-320, &[0.0]), "0 / 10⁻³⁰⁰ J");
        assert_eq!(texts(0.0, &[0.0, 1.0]), "0 1 / J");
    }

    #[test]
    fn marks_of_a_logarithmic_axis_are_powers_of_ten() {
        let marks = [1.0, 1e-3, 2e-3, 0.30000000000000004, 10f64.powf(-4.0), 1e300].map(|mark| power(&mark));
        assert_eq!(marks, ["10⁰", "10⁻³", "2·10⁻³", "3·10⁻¹", "10⁻⁴", "10³⁰⁰"]);
    }
}
