//! The measurements as a drawing: two panels, both axes of each logarithmic.

use exact_ccd_compare::plot::plotters::prelude::*;
use exact_ccd_compare::plot::plotters::series::{DashedLineSeries, LineSeries};
use exact_ccd_compare::plot::{Area, Axis, Drawn, Frame, color, decades, logarithmic, power, seconds, write};

use crate::curve::{Cost, Curve};

const SIZE: (u32, u32) = (1200, 560);

/// The height of the names above the panels, in pixels.
const LEGEND: u32 = 50;

/// An SVG file.
pub(crate) fn svg(curves: &[Curve]) -> String {
    exact_ccd_compare::plot::svg(SIZE, |area| draw(curves, area))
}

fn draw<'a>(curves: &[Curve], area: &Area<'a>) -> Drawn<'a> {
    let (top, panels) = area.split_vertically(LEGEND);
    draw_legend(curves, &top)?;
    let (left, right) = panels.split_horizontally(SIZE.0 / 2);
    draw_panel(curves, Cost::Seconds, &left)?;
    draw_panel(curves, Cost::Mebibytes, &right)
}

fn draw_panel<'a>(curves: &[Curve], cost: Cost, area: &Area<'a>) -> Drawn<'a> {
    let places: Vec<(f64, f64)> = curves.iter().flat_map(|curve| curve.places(cost)).collect();
    let (first, last) = decades(places.iter().map(|place| place.0));
    let (least, most) = decades(places.iter().map(|place| place.1));
    let (title, label): (_, fn(&f64) -> String) = match cost {
        Cost::Seconds => ("time", seconds),
        Cost::Mebibytes => ("peak memory above that of the mesh", amount),
    };
    let frame = Frame {
        title: "",
        x: Axis {
            title: "triangles",
            label: &power,
        },
        y: Axis { title, label: &label },
        legend: 30,
    };
    let mut chart = frame.draw(area, logarithmic(first, last), logarithmic(least, most))?;
    // The line through the largest point of the first curve, down to the border of the panel.
    if let Some((x, y)) = curves.first().and_then(|curve| curve.places(cost).last()) {
        let start = first.max(x * least / y);
        let line = [(start, y * start / x), (x, y)];
        chart.draw_series(DashedLineSeries::new(line, 6, 4, BLACK.mix(0.5).stroke_width(1)))?;
    }
    for (index, curve) in curves.iter().enumerate() {
        let color = color(index);
        chart.draw_series(LineSeries::new(curve.places(cost), color.stroke_width(2)))?;
        chart.draw_series(
            curve
                .places(cost)
                .map(|place| Circle::new(place, 4, color.filled())),
        )?;
    }
    Ok(())
}

fn draw_legend<'a>(curves: &[Curve], area: &Area<'a>) -> Drawn<'a> {
    let place = |index: usize| (100 + 240 * index as i32, 30);
    for (index, curve) in curves.iter().enumerate() {
        let (x, y) = place(index);
        area.draw(&PathElement::new(
            [(x, y), (x + 28, y)],
            color(index).stroke_width(2),
        ))?;
        area.draw(&Circle::new((x + 14, y), 4, color(index).filled()))?;
        write(area, curve.question.title(), (x + 38, y - 8))?;
    }
    let (x, y) = place(curves.len());
    for dash in [0, 10, 20] {
        let ends = [(x + dash, y), (x + dash + 6, y)];
        area.draw(&PathElement::new(ends, BLACK.mix(0.5).stroke_width(1)))?;
    }
    write(area, "in proportion to the candidates", (x + 38, y - 8))
}

fn amount(mebibytes: &f64) -> String {
    format!("{mebibytes} MiB")
}
