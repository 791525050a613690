//! The measurements as a drawing: two panels, both axes of each logarithmic.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::series::{DashedLineSeries, LineSeries};

use crate::curve::{Cost, Curve};

const SIZE: (u32, u32) = (1200, 560);

/// Room for the names above the panels.
const LEGEND: u32 = 50;

/// One for each question, and all eyes can tell them apart.
const COLORS: [RGBColor; 3] = [RGBColor(0, 0, 0), RGBColor(0, 114, 178), RGBColor(213, 94, 0)];

type Drawn<B> = Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// An SVG file.
pub(crate) fn svg(curves: &[Curve]) -> String {
    let mut drawing = String::new();
    draw(curves, SVGBackend::with_string(&mut drawing, SIZE)).expect("a string takes all that is drawn");
    drawing
}

fn draw<'a>(curves: &[Curve], backend: SVGBackend<'a>) -> Drawn<SVGBackend<'a>> {
    let root = backend.into_drawing_area();
    root.fill(&WHITE)?;
    let (top, panels) = root.split_vertically(LEGEND);
    draw_legend(curves, &top)?;
    let (left, right) = panels.split_horizontally(SIZE.0 / 2);
    draw_panel(curves, Cost::Seconds, &left)?;
    draw_panel(curves, Cost::Mebibytes, &right)?;
    root.present()
}

fn draw_panel<'a>(curves: &[Curve], cost: Cost, area: &Area<'a>) -> Drawn<SVGBackend<'a>> {
    let places: Vec<(f64, f64)> = curves.iter().flat_map(|curve| curve.places(cost)).collect();
    let (first, last) = decades(places.iter().map(|place| place.0));
    let (least, most) = decades(places.iter().map(|place| place.1));
    let (title, label): (_, fn(&f64) -> String) = match cost {
        Cost::Seconds => ("time", duration),
        Cost::Mebibytes => ("peak memory above that of the mesh", amount),
    };
    let mut chart = ChartBuilder::on(area)
        .margin(15)
        .margin_right(30)
        .x_label_area_size(55)
        .y_label_area_size(85)
        .build_cartesian_2d((first..last).log_scale(), (least..most).log_scale())?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.12))
        .label_style(("sans-serif", 16))
        .axis_desc_style(("sans-serif", 18))
        .x_label_formatter(&power_of_ten)
        .y_label_formatter(&label)
        .x_desc("candidates")
        .y_desc(title)
        .draw()?;
    // Through the largest of the first curve, as far down as the panel goes.
    if let Some((x, y)) = curves.first().and_then(|curve| curve.places(cost).last()) {
        let start = first.max(x * least / y);
        let line = [(start, y * start / x), (x, y)];
        chart.draw_series(DashedLineSeries::new(line, 6, 4, BLACK.mix(0.5).stroke_width(1)))?;
    }
    for (curve, color) in curves.iter().zip(COLORS) {
        chart.draw_series(LineSeries::new(curve.places(cost), color.stroke_width(2)))?;
        chart.draw_series(
            curve
                .places(cost)
                .map(|place| Circle::new(place, 4, color.filled())),
        )?;
    }
    Ok(())
}

fn draw_legend<'a>(curves: &[Curve], area: &Area<'a>) -> Drawn<SVGBackend<'a>> {
    let place = |index: usize| (100 + 240 * index as i32, 30);
    for (index, (curve, color)) in curves.iter().zip(COLORS).enumerate() {
        let (x, y) = place(index);
        area.draw(&PathElement::new([(x, y), (x + 28, y)], color.stroke_width(2)))?;
        area.draw(&Circle::new((x + 14, y), 4, color.filled()))?;
        draw_name(area, curve.question.title(), (x + 38, y - 8))?;
    }
    let (x, y) = place(curves.len());
    for dash in [0, 10, 20] {
        let ends = [(x + dash, y), (x + dash + 6, y)];
        area.draw(&PathElement::new(ends, BLACK.mix(0.5).stroke_width(1)))?;
    }
    draw_name(area, "in proportion to the candidates", (x + 38, y - 8))
}

fn draw_name<'a>(area: &Area<'a>, name: &'static str, place: (i32, i32)) -> Drawn<SVGBackend<'a>> {
    area.draw(&Text::new(name, place, ("sans-serif", 16)))
}

/// Whole powers of ten around all values; a little beyond one does not count as another decade.
fn decades(values: impl Iterator<Item = f64>) -> (f64, f64) {
    const SLACK: f64 = 0.15;
    let (least, most) = values.fold((f64::INFINITY, 0.0_f64), |(least, most), value| {
        (least.min(value), most.max(value))
    });
    if least > most {
        return (1.0, 10.0);
    }
    let (least, most) = (least.log10(), most.log10());
    let end = |power: f64, nearest: f64, beyond: f64| {
        10f64.powf(if (power - nearest).abs() < SLACK {
            power
        } else {
            beyond
        })
    };
    let low = end(least, least.round(), least.floor()).min(10f64.powf(least.round().max(least.floor())));
    (
        low,
        end(most, most.round(), most.ceil()).max(10f64.powf(most.floor())),
    )
}

fn power_of_ten(value: &f64) -> String {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let power = value.log10().round();
    digits
        .get(power as usize)
        .map_or_else(|| format!("{value:e}"), |digit| format!("10{digit}"))
}

fn duration(seconds: &f64) -> String {
    match *seconds {
        ..1e-3 => format!("{:.0} µs", 1e6 * seconds),
        1e-3..0.9999 => format!("{:.0} ms", 1e3 * seconds),
        _ => format!("{seconds:.0} s"),
    }
}

fn amount(mebibytes: &f64) -> String {
    format!("{mebibytes} MiB")
}
