//! A table as drawings.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::series::{DashedLineSeries, LineSeries};

use super::table::{Row, Table};

const SIZE: (u32, u32) = (1000, 640);

/// Room for the names beside the drawing.
const LEGEND: i32 = 150;

type Drawn<B> = Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;

/// An SVG file: for each method, which share of the queries takes longer than a time. Both axes are logarithmic.
pub(super) fn tails(table: &Table) -> String {
    drawn(|backend| draw_tails(table, backend))
}

/// An SVG file: for each method, its mean time and which share of its answers is wrong.
pub(super) fn accuracy(table: &Table) -> String {
    drawn(|backend| draw_accuracy(table, backend))
}

fn drawn(draw: impl FnOnce(SVGBackend<'_>) -> Drawn<SVGBackend<'_>>) -> String {
    let mut drawing = String::new();
    draw(SVGBackend::with_string(&mut drawing, SIZE)).expect("a string takes all that is drawn");
    drawing
}

/// Colours that can be told apart, the first for the first row.
fn color(index: usize) -> RGBColor {
    const COLORS: [(u8, u8, u8); 7] = [
        (0, 0, 0),
        (0, 114, 178),
        (213, 94, 0),
        (0, 158, 115),
        (204, 121, 167),
        (150, 120, 0),
        (86, 180, 233),
    ];
    let (r, g, b) = COLORS[index % COLORS.len()];
    RGBColor(r, g, b)
}

/// Whether the colours are used again: for dashed lines and open symbols.
fn is_second_round(index: usize) -> bool {
    index >= 7
}

/// A triangle around a point that the drawing gives; those of plotters are never open.
fn triangle<B: DrawingBackend>(index: usize) -> DynElement<'static, B, (i32, i32)> {
    let corners = vec![(0, -7), (6, 4), (-6, 4), (0, -7)];
    if is_second_round(index) {
        PathElement::new(corners, symbol_style(index)).into_dyn()
    } else {
        Polygon::new(corners, symbol_style(index)).into_dyn()
    }
}

fn symbol_style(index: usize) -> ShapeStyle {
    if is_second_round(index) {
        color(index).stroke_width(2)
    } else {
        color(index).filled()
    }
}

fn title(table: &Table) -> String {
    let kind = if table.kind == "vf" {
        "vertex-face"
    } else {
        "edge-edge"
    };
    format!("{}, {kind}", table.data_set)
}

/// The least and the largest of all times, as far as there are any, in whole powers of ten.
fn decades(times: impl Iterator<Item = f64>) -> (f64, f64) {
    let (least, largest) = times
        .filter(|time| *time > 0.0)
        .fold((f64::INFINITY, 0.0_f64), |(least, largest), time| {
            (least.min(time), largest.max(time))
        });
    if least > largest {
        return (0.1, 1.0);
    }
    let power = |exponent: f64| 10f64.powf(exponent);
    (
        power(least.log10().floor()),
        power((largest.log10() + 1e-9).ceil().max(least.log10().floor() + 1.0)),
    )
}

/// A power of ten in microseconds, in the unit that suits it.
fn duration(time: &f64) -> String {
    match *time {
        ..1.0 => format!("{:.0} ns", 1e3 * time),
        1.0..1e3 => format!("{time:.0} µs"),
        1e3..1e6 => format!("{:.0} ms", 1e-3 * time),
        _ => format!("{:.0} s", 1e-6 * time),
    }
}

fn draw_tails<B: DrawingBackend>(table: &Table, backend: B) -> Drawn<B> {
    let root = backend.into_drawing_area();
    root.fill(&WHITE)?;
    let times = table
        .rows
        .iter()
        .flat_map(|row| row.distribution.iter().map(|(time, _)| *time));
    let (first, last) = decades(times);
    let least_share = 1e-4;
    let mut chart = ChartBuilder::on(&root)
        .caption(title(table), ("sans-serif", 24))
        .margin(15)
        .margin_right(LEGEND)
        .x_label_area_size(55)
        .y_label_area_size(75)
        .build_cartesian_2d((first..last).log_scale(), (least_share..1.0).log_scale())?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.12))
        .label_style(("sans-serif", 16))
        .axis_desc_style(("sans-serif", 18))
        .x_label_formatter(&duration)
        .y_label_formatter(&|share| format!("{share}"))
        .x_desc("time")
        .y_desc("share of the queries that take longer")
        .draw()?;
    for (index, row) in table.rows.iter().enumerate() {
        let line = exceedance(row, first, least_share);
        let style = color(index).stroke_width(2);
        if is_second_round(index) {
            chart.draw_series(DashedLineSeries::new(line, 6, 4, style))?;
        } else {
            chart.draw_series(LineSeries::new(line, style))?;
        }
    }
    draw_lines_legend(&root, table)?;
    root.present()
}

/// Steps of less than this, in powers of ten, are narrower than the line.
const VISIBLE: f64 = 0.005;

/// The stairs of the share of queries that take longer, from all of them on.
fn exceedance(row: &Row, first: f64, least_share: f64) -> Vec<(f64, f64)> {
    let mut longer: f64 = 1.0;
    let mut line = vec![(first, 1.0)];
    for (index, &(time, weight)) in row.distribution.iter().enumerate() {
        let (corner, above) = (time.max(first), longer.max(least_share));
        longer -= weight;
        let below = longer.max(least_share);
        let (drawn_time, drawn_share) = line[line.len() - 1];
        let is_visible = (corner / drawn_time).log10() > VISIBLE || (drawn_share / below).log10() > VISIBLE;
        if is_visible || index + 1 == row.distribution.len() {
            line.extend([(corner, above), (corner, below)]);
        }
    }
    line
}

fn draw_accuracy<B: DrawingBackend>(table: &Table, backend: B) -> Drawn<B> {
    let root = backend.into_drawing_area();
    root.fill(&WHITE)?;
    let (first, last) = decades(table.rows.iter().filter_map(|row| row.mean));
    let rates: Vec<[f64; 2]> = table.rows.iter().map(error_rates).collect();
    let top = rates
        .as_flattened()
        .iter()
        .fold(1.0_f64, |top, rate| top.max(1.1 * rate));
    let mut chart = ChartBuilder::on(&root)
        .caption(title(table), ("sans-serif", 24))
        .margin(15)
        .margin_right(LEGEND)
        .x_label_area_size(55)
        .y_label_area_size(75)
        .build_cartesian_2d((first..last).log_scale(), -0.03 * top..top)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.12))
        .label_style(("sans-serif", 16))
        .axis_desc_style(("sans-serif", 18))
        .x_label_formatter(&duration)
        .y_label_formatter(&|rate| format!("{rate:.0} %"))
        .x_desc("mean time")
        .y_desc("wrong: ▲ of the free are said to collide, ● of the colliding are missed")
        .draw()?;
    for (index, (row, [invented, missed])) in table.rows.iter().zip(rates).enumerate() {
        let Some(mean) = row.mean else { continue };
        chart.draw_series([EmptyElement::at((mean, invented)) + triangle(index)])?;
        chart.draw_series([Circle::new((mean, missed), 5, symbol_style(index))])?;
    }
    draw_symbols_legend(&root, table)?;
    root.present()
}

/// In per cent: of the queries that do not collide, those said to; of those that collide, those said not to.
fn error_rates(row: &Row) -> [f64; 2] {
    let rate = |wrong: usize, of: usize| 100.0 * wrong as f64 / of.max(1) as f64;
    [
        rate(row.false_positives, row.answered.free),
        rate(row.false_negatives, row.answered.colliding),
    ]
}

/// Where the name of a row is written.
fn place(index: usize) -> (i32, i32) {
    (SIZE.0 as i32 - LEGEND + 8, 70 + 24 * index as i32)
}

/// The names on the right, each with a piece of its line.
fn draw_lines_legend<B: DrawingBackend>(root: &DrawingArea<B, Shift>, table: &Table) -> Drawn<B> {
    for (index, row) in table.rows.iter().enumerate() {
        let (x, y) = place(index);
        let pieces: &[[i32; 2]] = if is_second_round(index) {
            &[[0, 6], [10, 16], [20, 24]]
        } else {
            &[[0, 24]]
        };
        for [from, to] in pieces {
            let ends = [(x + from, y), (x + to, y)];
            root.draw(&PathElement::new(ends, color(index).stroke_width(2)))?;
        }
        draw_name(root, row, (x + 32, y - 8))?;
    }
    Ok(())
}

/// The names on the right, each with its symbols.
fn draw_symbols_legend<B: DrawingBackend>(root: &DrawingArea<B, Shift>, table: &Table) -> Drawn<B> {
    for (index, row) in table.rows.iter().enumerate() {
        let (x, y) = place(index);
        root.draw(&(EmptyElement::at((x + 4, y)) + triangle(index)))?;
        root.draw(&Circle::new((x + 20, y), 5, symbol_style(index)))?;
        draw_name(root, row, (x + 32, y - 8))?;
    }
    Ok(())
}

fn draw_name<B: DrawingBackend>(root: &DrawingArea<B, Shift>, row: &Row, place: (i32, i32)) -> Drawn<B> {
    root.draw(&Text::new(row.method.clone(), place, ("sans-serif", 16)))
}
