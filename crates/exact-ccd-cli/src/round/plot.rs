//! The histogram as a drawing.

use plotters::prelude::*;

use super::histogram::Histogram;

/// Wide enough for every decade that f64 has to be seen.
const SIZE: (u32, u32) = (1000, 500);

const BAR: RGBColor = RGBColor(86, 120, 196);

/// How many powers of ten are written on the axis, at most.
const LABELS: i32 = 12;

/// An SVG file: a bar for each decade on an axis of log₁₀ ε, as in figure 5 of the paper, and to the left of them one
/// for the zeros.
pub(super) fn svg(errors: &Histogram) -> String {
    let mut drawing = String::new();
    draw(errors, SVGBackend::with_string(&mut drawing, SIZE)).expect("a string takes all that is drawn");
    drawing
}

fn draw<DB: DrawingBackend>(
    errors: &Histogram,
    backend: DB,
) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
    let decades = errors.counts().filter_map(|(decade, _)| decade);
    let (first, last) = decades.fold((i32::MAX, i32::MIN), |(first, last), k| {
        (first.min(k), last.max(k + 1))
    });
    // Without any, there is still an axis.
    let (first, last) = if first < last { (first, last) } else { (-16, -16) };

    // The unit of the axis is half a decade, so that the bar of the zeros has its label in the middle, as far from the
    // first power of ten as these are from each other.
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

    let root = backend.into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .margin(20)
        .x_label_area_size(50)
        .y_label_area_size(100)
        .build_cartesian_2d((zero - step - 1..2 * last + 1).with_key_points(ticks), 0..top)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(TRANSPARENT)
        .label_style(("sans-serif", 18))
        .axis_desc_style(("sans-serif", 20))
        .x_label_formatter(&label)
        .x_desc("log₁₀ ε of the rounding errors ε = |x + e − fl(x + e)|")
        .y_desc("coordinates")
        .draw()?;
    chart.draw_series(errors.counts().map(|(decade, count)| {
        let left = decade.map_or(zero - 1, |k| 2 * k);
        Rectangle::new([(left, 0), (left + 2, count)], BAR.filled())
    }))?;
    root.present()
}
