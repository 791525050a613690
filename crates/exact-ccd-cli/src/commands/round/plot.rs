//! The plot of the histogram.

use exact_ccd_compare::plot::plotters::prelude::*;
use exact_ccd_compare::plot::{Area, Axis, Drawn, Frame, color};

use super::histogram::Histogram;

/// Wide enough for all decades of f64.
const SIZE: (u32, u32) = (1000, 500);

/// The largest number of labels on the axis.
const LABELS: i32 = 12;

/// An SVG file: a bar for each decade on an axis of log₁₀ ε, as in figure 5 of the paper, and to
/// the left of them one for the zeros.
pub(super) fn svg(errors: &Histogram) -> String {
    exact_ccd_compare::plot::svg(SIZE, |area| draw(errors, area))
}

fn draw<'a>(errors: &Histogram, area: &Area<'a>) -> Drawn<'a> {
    let decades = errors.counts().filter_map(|(decade, _)| decade);
    let (first, last) = decades.fold((i32::MAX, i32::MIN), |(first, last), k| {
        (first.min(k), last.max(k + 1))
    });
    // Without decades, there is still an axis.
    let (first, last) = if first < last { (first, last) } else { (-16, -16) };

    // The unit of the axis is half a decade, so that the bar of the zeros has its label in the
    // middle, as far from the first power of ten as these are from each other.
    let step = (last - first) / LABELS + 1;
    let zero = 2 * (first - step) - 1;
    let powers = (first..=last)
        .step_by(step.unsigned_abs() as usize)
        .map(|k| 2 * k);
    let ticks = std::iter::once(zero).chain(powers).collect();
    let label = |&x: &i32| {
        if x == zero {
            "ε = 0".to_owned()
        } else {
            (x / 2).to_string()
        }
    };
    let top = errors.highest() + errors.highest() / 20 + 1;

    let frame = Frame {
        title: "rounding errors ε = |x + e − fl(x + e)|",
        x: Axis {
            title: "log₁₀ ε",
            label: &label,
        },
        y: Axis {
            title: "number of coordinates",
            label: &|count: &usize| count.to_string(),
        },
        legend: 20,
    };
    let bars = (zero - step - 1..2 * last + 1).with_key_points(ticks);
    let mut chart = frame.draw(area, bars, 0..top)?;
    chart.draw_series(errors.counts().map(|(decade, count)| {
        let left = decade.map_or(zero - 1, |k| 2 * k);
        Rectangle::new([(left, 0), (left + 2, count)], color(1).filled())
    }))?;
    Ok(())
}
