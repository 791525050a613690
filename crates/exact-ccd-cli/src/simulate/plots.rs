//! Plots of the energies and of the minimal distance over time.

use exact_ccd_compare::plot::plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use exact_ccd_compare::plot::plotters::prelude::*;
use exact_ccd_compare::plot::plotters::series::LineSeries;
use exact_ccd_compare::plot::{
    Area, Axis, Drawn, Frame, GREATEST, Scale, color, decades, linear, logarithmic, power, svg, write,
};

use super::folder::OutputFolder;
use super::layout::{DISTANCE, ENERGIES};
use super::statistics::Row;
use crate::failure::Failure;
use crate::output::write_file;

const SIZE: (u32, u32) = (1000, 640);

/// The width of the legend.
const LEGEND: i32 = 170;

/// A line of a plot: a name, and pairs of a time and a value. Values may be missing.
struct Line {
    name: &'static str,
    points: Vec<(f64, Option<f64>)>,
}

impl Line {
    /// The line through the values of rows.
    fn new(name: &'static str, rows: &[Row], value: impl Fn(&Row) -> Option<f64>) -> Self {
        // The table may have been edited, so that any number is possible.
        let is_drawn = |x: &f64| x.abs() <= GREATEST;
        let rows = rows.iter().filter(|row| is_drawn(&row.time));
        let points = rows.map(|row| (row.time, value(row).filter(is_drawn)));
        Self {
            name,
            points: points.collect(),
        }
    }
}

/// Plots the statistics in a folder of a scene with this name. `contact_distance` is d̂, in m.
pub(super) fn draw(folder: &OutputFolder, scene: &str, contact_distance: f64) -> Result<(), Failure> {
    let rows = folder.statistics()?;
    let write = |name: &str, drawing: String| {
        write_file(&folder.file(name), |writer| {
            std::io::Write::write_all(writer, drawing.as_bytes())
        })
    };
    write(ENERGIES, energies(scene, &rows))?;
    write(DISTANCE, minimal_distance(scene, &rows, contact_distance))
}

/// The plot of all energies that are not zero, in J. The energy of gravity is relative to its least value.
fn energies(scene: &str, rows: &[Row]) -> String {
    let lowest = rows
        .iter()
        .fold(f64::INFINITY, |least, row| least.min(row.gravity));
    let line = |name, energy: &dyn Fn(&Row) -> f64| Line::new(name, rows, |row| Some(energy(row)));
    let sum = |row: &Row| row.kinetic + row.elastic + row.barrier + row.gravity - lowest;
    let lines = [
        line("sum", &sum),
        line("kinetic", &|row| row.kinetic),
        line("elastic", &|row| row.elastic),
        line("gravity", &|row| row.gravity - lowest),
        line("barrier", &|row| row.barrier),
        line("friction", &|row| row.friction),
    ];
    let is_there = |line: &Line| line.points.iter().any(|(_, energy)| *energy != Some(0.0));
    let lines: Vec<Line> = lines.into_iter().filter(is_there).collect();
    let (least, most) = range(&lines);
    let scale = Scale::of(most.max(-least));
    let axis = Axis {
        title: &format!("energy / {}", scale.unit("J")),
        label: &|energy: &f64| scale.number(*energy),
    };
    let title = format!("{scene}: energies");
    svg(SIZE, |area| {
        draw_lines(&lines, &title, axis, linear(least, most), area)
    })
}

/// The plot of the minimal distance in m, where there are contacts, and of the contact distance.
fn minimal_distance(scene: &str, rows: &[Row], contact_distance: f64) -> String {
    let lines = [
        Line::new("minimal distance", rows, |row| row.minimal_distance),
        Line::new("contact distance", rows, |_| Some(contact_distance)),
    ];
    let (first, last) = decades(values(&lines));
    let axis = Axis {
        title: "distance / m",
        label: &power,
    };
    let title = format!("{scene}: minimal distance");
    svg(SIZE, |area| {
        draw_lines(&lines, &title, axis, logarithmic(first, last), area)
    })
}

fn values(lines: &[Line]) -> impl Iterator<Item = f64> {
    lines
        .iter()
        .flat_map(|line| line.points.iter().filter_map(|(_, value)| *value))
}

/// The range of 0 and all values.
fn range(lines: &[Line]) -> (f64, f64) {
    let (least, most) = values(lines).fold((0.0_f64, 0.0_f64), |(least, most), value| {
        (least.min(value), most.max(value))
    });
    if least < most { (least, most) } else { (0.0, 1.0) }
}

fn draw_lines<'a, Y>(
    lines: &[Line],
    title: &str,
    y: Axis<'_, f64>,
    range: impl AsRangedCoord<CoordDescType = Y, Value = f64>,
    area: &Area<'a>,
) -> Drawn<'a>
where
    Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let times = lines
        .iter()
        .flat_map(|line| line.points.iter().map(|(time, _)| *time));
    let end = Some(times.fold(0.0, f64::max))
        .filter(|&end| end > 0.0)
        .unwrap_or(1.0);
    let scale = Scale::of(end);
    let frame = Frame {
        title,
        x: Axis {
            title: &format!("time / {}", scale.unit("s")),
            label: &|time: &f64| scale.number(*time),
        },
        y,
        legend: LEGEND,
    };
    let mut chart = frame.draw(area, linear(0.0, end), range)?;
    for (index, line) in lines.iter().enumerate() {
        let style = color(index).stroke_width(2);
        for piece in line.points.split(|(_, value)| value.is_none()) {
            let points: Vec<(f64, f64)> = piece
                .iter()
                .filter_map(|(time, value)| Some((*time, (*value)?)))
                .collect();
            if let &[point] = points.as_slice() {
                chart.draw_series([Circle::new(point, 2, style.filled())])?;
            } else {
                chart.draw_series(LineSeries::new(points, style))?;
            }
        }
        let (x, y) = (SIZE.0 as i32 - LEGEND + 8, 30 + 24 * index as i32);
        area.draw(&PathElement::new([(x, y), (x + 16, y)], style))?;
        write(area, line.name, (x + 22, y - 8))?;
    }
    Ok(())
}
