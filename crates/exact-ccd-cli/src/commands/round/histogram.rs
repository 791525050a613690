//! The histogram of rounding errors by magnitude.

use std::collections::BTreeMap;
use std::fmt;

use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

/// The length of the longest bar.
const WIDTH: usize = 50;

/// Rounding errors, counted by decades.
#[derive(Default)]
pub(super) struct Histogram {
    /// The counts of zeros, as `None`, and of errors from 10ᵏ up to below 10ᵏ⁺¹, as `Some(k)`. No count is 0.
    counts: BTreeMap<Option<i32>, usize>,
    largest: f64,
}

impl Histogram {
    pub(super) fn add(&mut self, error: f64) {
        debug_assert!(error >= 0.0, "{error}");
        *self.counts.entry(decade(error)).or_default() += 1;
        self.largest = self.largest.max(error);
    }

    /// The counts: first the number of zeros, as `None`, then one for each decade in order.
    pub(super) fn counts(&self) -> impl Iterator<Item = (Option<i32>, usize)> {
        self.counts.iter().map(|(&decade, &count)| (decade, count))
    }

    pub(super) fn total(&self) -> usize {
        self.counts.values().sum()
    }

    /// The largest count.
    pub(super) fn highest(&self) -> usize {
        self.counts.values().copied().max().unwrap_or(0)
    }

    /// The largest error.
    pub(super) fn largest(&self) -> f64 {
        self.largest
    }
}

/// The number of errors from 10ᵏ up to below 10ᵏ⁺¹, as JSON; k is null for the number of zeros.
#[derive(Serialize)]
struct Decade {
    decade: Option<i32>,
    count: usize,
}

impl Serialize for Histogram {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let decades = self.counts().map(|(decade, count)| Decade { decade, count });
        let mut object = serializer.serialize_struct("Histogram", 3)?;
        object.serialize_field("coordinates", &self.total())?;
        object.serialize_field("largest_error", &self.largest)?;
        object.serialize_field("errors", &decades.collect::<Vec<_>>())?;
        object.end()
    }
}

/// The k with 10ᵏ ≤ error < 10ᵏ⁺¹, or `None` for 0.
fn decade(error: f64) -> Option<i32> {
    // At powers of ten, logarithms differ from machine to machine; decimals do not.
    let text = format!("{error:e}");
    let (_, exponent) = text.split_once('e')?;
    exponent.parse().ok().filter(|_| error > 0.0)
}

/// A line with a bar for each decade.
impl fmt::Display for Histogram {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let label = |decade: Option<i32>| decade.map_or("0".to_owned(), |k| format!("1e{k} to 1e{}", k + 1));
        let highest = self.highest();
        let label_width = self.counts().map(|(decade, _)| label(decade).len()).max();
        let (label_width, count_width) = (label_width.unwrap_or(0), highest.to_string().len());
        for (decade, count) in self.counts() {
            let (label, bar) = (label(decade), "#".repeat((count * WIDTH).div_ceil(highest)));
            write!(f, "\n{label:>label_width$}  {count:>count_width$}  {bar}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_begin_a_decade() {
        for k in -323..=308 {
            let power: f64 = format!("1e{k}").parse().unwrap();
            assert_eq!(decade(power), Some(k));
            assert_eq!(
                decade(power.next_down()),
                if k == -323 { Some(-324) } else { Some(k - 1) }
            );
        }
        assert_eq!(decade(5e-324), Some(-324));
        assert_eq!(decade(f64::MAX), Some(308));
        assert_eq!(decade(0.0), None);
    }
}
