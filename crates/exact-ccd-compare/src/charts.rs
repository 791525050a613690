//! The plots of a table.

use crate::plot::{Area, Axis, COLOR_COUNT, Drawn, Frame, color, decades, linear, logarithmic, svg, write};
use plotters::prelude::*;
use plotters::series::{DashedLineSeries, LineSeries};

use crate::table::{Row, Table};

const SIZE: (u32, u32) = (1000, 640);

/// The width of the names beside the drawing, in pixels.
const LEGEND: i32 = 150;

/// An SVG file: for each method, the share of the queries that take longer than a time. Both axes
/// are logarithmic.
pub(super) fn tails(table: &Table) -> String {
    svg(SIZE, |area| draw_tails(table, area))
}

/// An SVG file: for each method, its mean time and the share of its wrong answers.
pub(super) fn accuracy(table: &Table) -> String {
    svg(SIZE, |area| draw_accuracy(table, area))
}

/// Returns true if the colour is used for the second time: then lines are dashed and symbols open.
fn is_second_round(index: usize) -> bool {
    index >= COLOR_COUNT
}

/// A triangle around a point. The triangles of plotters are never open.
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
    format!("{}, {}", table.data_set, table.kind_in_words())
}

/// A time in microseconds.
fn duration(time: &f64) -> String {
    crate::plot::seconds(&(1e-6 * time))
}

/// The frame of a plot over times, with space for the names of the methods.
fn frame<'a, Y>(title: &'a str, times: &'a str, y: Axis<'a, Y>) -> Frame<'a, f64, Y> {
    let x = Axis {
        title: times,
        label: &duration,
    };
    let legend = LEGEND;
    Frame { title, x, y, legend }
}

fn draw_tails<'a>(table: &Table, area: &Area<'a>) -> Drawn<'a> {
    let times = table
        .rows
        .iter()
        .flat_map(|row| row.distribution.iter().map(|(time, _)| *time));
    let (first, last) = decades(times);
    let least_share = 1e-4;
    let share = Axis {
        title: "share of the queries that take longer",
        label: &|share: &f64| share.to_string(),
    };
    let shares = logarithmic(least_share, 1.0);
    let title = title(table);
    let mut chart = frame(&title, "time", share).draw(area, logarithmic(first, last), shares)?;
    for (index, row) in table.rows.iter().enumerate() {
        let line = exceedance(row, first, least_share);
        let style = color(index).stroke_width(2);
        if is_second_round(index) {
            chart.draw_series(DashedLineSeries::new(line, 6, 4, style))?;
        } else {
            chart.draw_series(LineSeries::new(line, style))?;
        }
    }
    draw_lines_legend(area, table)
}

/// Steps of less than this, in powers of ten, are narrower than the line.
const VISIBLE: f64 = 0.005;

/// The stairs of the share of queries that take longer, from all of them on.
fn exceedance(row: &Row, first: f64, least_share: f64) -> Vec<(f64, f64)> {
    let mut longer: f64 = 1.0;
    let mut line = vec![(first, 1.0)];
    for (index, &(time, weight)) in row.distribution.iter().enumerate() {
        // The line ends where it leaves the plot.
        if longer <= least_share {
            break;
        }
        let (corner, above) = (time.max(first), longer);
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

fn draw_accuracy<'a>(table: &Table, area: &Area<'a>) -> Drawn<'a> {
    let (first, last) = decades(table.rows.iter().filter_map(|row| row.mean));
    let rates: Vec<[f64; 2]> = table.rows.iter().map(error_rates).collect();
    let top = rates
        .as_flattened()
        .iter()
        .fold(1.0_f64, |top, &rate| top.max(rate));
    let wrong = Axis {
        title: "wrong: ▲ of the free are said to collide, ● of the colliding are missed",
        label: &|rate: &f64| format!("{rate:.0} %"),
    };
    let title = title(table);
    let mut chart =
        frame(&title, "mean time", wrong).draw(area, logarithmic(first, last), linear(0.0, top))?;
    for (index, (row, [invented, missed])) in table.rows.iter().zip(rates).enumerate() {
        let Some(mean) = row.mean else { continue };
        chart.draw_series([EmptyElement::at((mean, invented)) + triangle(index)])?;
        chart.draw_series([Circle::new((mean, missed), 5, symbol_style(index))])?;
    }
    draw_symbols_legend(area, table)
}

/// The rates of false positives and of false negatives, in per cent.
fn error_rates(row: &Row) -> [f64; 2] {
    let rate = |wrong: usize, of: usize| 100.0 * wrong as f64 / of.max(1) as f64;
    [
        rate(row.false_positives, row.answered.free),
        rate(row.false_negatives, row.answered.colliding),
    ]
}

/// The place of the name of a row.
fn place(index: usize) -> (i32, i32) {
    (SIZE.0 as i32 - LEGEND + 8, 70 + 24 * index as i32)
}

/// The names on the right, each with a piece of its line.
fn draw_lines_legend<'a>(area: &Area<'a>, table: &Table) -> Drawn<'a> {
    for (index, row) in table.rows.iter().enumerate() {
        let (x, y) = place(index);
        let pieces: &[[i32; 2]] = if is_second_round(index) {
            &[[0, 6], [10, 16], [20, 24]]
        } else {
            &[[0, 24]]
        };
        for [from, to] in pieces {
            let ends = [(x + from, y), (x + to, y)];
            area.draw(&PathElement::new(ends, color(index).stroke_width(2)))?;
        }
        write(area, &row.method, (x + 32, y - 8))?;
    }
    Ok(())
}

/// The names on the right, each with its symbols.
fn draw_symbols_legend<'a>(area: &Area<'a>, table: &Table) -> Drawn<'a> {
    for (index, row) in table.rows.iter().enumerate() {
        let (x, y) = place(index);
        area.draw(&(EmptyElement::at((x + 4, y)) + triangle(index)))?;
        area.draw(&Circle::new((x + 20, y), 5, symbol_style(index)))?;
        write(area, &row.method, (x + 32, y - 8))?;
    }
    Ok(())
}
