//! Energies and the minimal distance over time, as drawings.

use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::prelude::*;
use plotters::series::LineSeries;

use super::folder::{DISTANCE, ENERGIES, OutputFolder};
use super::statistics::Row;
use crate::failure::Failure;
use crate::output::write_file;

const SIZE: (u32, u32) = (1000, 640);

/// Room for the names beside the drawing.
const LEGEND: i32 = 170;

/// Colours that can be told apart, those of `exact-ccd bench`.
const COLORS: [RGBColor; 6] = [
    RGBColor(0, 0, 0),
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(150, 120, 0),
];

/// A line of a plot: a name, and values at times, which may be missing.
struct Line {
    name: &'static str,
    points: Vec<(f64, Option<f64>)>,
}

/// Draws the rows of the statistics in a folder. `contact_distance` is d̂, in m.
pub(super) fn draw(folder: &OutputFolder, contact_distance: f64) -> Result<(), Failure> {
    let rows = folder.statistics()?;
    let write = |name: &str, drawing: String| {
        write_file(&folder.file(name), |writer| {
            std::io::Write::write_all(writer, drawing.as_bytes())
        })
    };
    write(ENERGIES, energies(&rows))?;
    write(DISTANCE, minimal_distance(&rows, contact_distance))
}

/// The energies that there are, in J. That of gravity is above its least: where it is zero is arbitrary.
fn energies(rows: &[Row]) -> String {
    let lowest = rows
        .iter()
        .fold(f64::INFINITY, |least, row| least.min(row.gravity));
    let line = |name, energy: &dyn Fn(&Row) -> f64| Line {
        name,
        points: rows.iter().map(|row| (row.time, Some(energy(row)))).collect(),
    };
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
    plot(&lines, "energy / J", false)
}

/// The minimal distance, in m, where anything is within the contact distance, and that distance.
fn minimal_distance(rows: &[Row], contact_distance: f64) -> String {
    let points =
        |value: &dyn Fn(&Row) -> Option<f64>| rows.iter().map(|row| (row.time, value(row))).collect();
    let lines = [
        Line {
            name: "minimal distance",
            points: points(&|row| row.minimal_distance),
        },
        Line {
            name: "contact distance",
            points: points(&|_| Some(contact_distance)),
        },
    ];
    plot(&lines, "distance / m", true)
}

type Drawn<B> = Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;

fn plot(lines: &[Line], unit: &str, is_logarithmic: bool) -> String {
    let mut drawing = String::new();
    let backend = SVGBackend::with_string(&mut drawing, SIZE);
    let drawn = if is_logarithmic {
        let (first, last) = decades(lines);
        draw_lines(lines, unit, (first..last).log_scale(), backend)
    } else {
        let (first, last) = range(lines);
        draw_lines(lines, unit, first..last, backend)
    };
    drawn.expect("a string takes all that is drawn");
    drawing
}

fn values(lines: &[Line]) -> impl Iterator<Item = f64> {
    lines
        .iter()
        .flat_map(|line| line.points.iter().filter_map(|(_, value)| *value))
}

/// From 0, or from what is below it, to a little more than all values.
fn range(lines: &[Line]) -> (f64, f64) {
    let (least, most) = values(lines).fold((0.0_f64, 0.0_f64), |(least, most), value| {
        (least.min(value), most.max(value))
    });
    if least < most {
        (1.05 * least, 1.05 * most)
    } else {
        (0.0, 1.0)
    }
}

/// The powers of ten around all values.
fn decades(lines: &[Line]) -> (f64, f64) {
    let (least, most) = values(lines)
        .filter(|value| *value > 0.0)
        .fold((f64::INFINITY, 0.0_f64), |(least, most), value| {
            (least.min(value), most.max(value))
        });
    if least > most {
        return (0.1, 1.0);
    }
    let first = least.log10().floor();
    (
        10f64.powf(first),
        10f64.powf(most.log10().ceil().max(first + 1.0)),
    )
}

/// A number on an axis, with three digits at most.
fn label(number: &f64) -> String {
    let rounded: f64 = format!("{number:.2e}").parse().unwrap_or(*number);
    if rounded == 0.0 || (1e-3..1e5).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

fn draw_lines<Y, B>(
    lines: &[Line],
    unit: &str,
    range: impl AsRangedCoord<CoordDescType = Y, Value = f64>,
    backend: B,
) -> Drawn<B>
where
    Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
    B: DrawingBackend,
{
    let root = backend.into_drawing_area();
    root.fill(&WHITE)?;
    let times = lines
        .iter()
        .flat_map(|line| line.points.iter().map(|(time, _)| *time));
    let end = Some(times.fold(0.0, f64::max))
        .filter(|&end| end > 0.0)
        .unwrap_or(1.0);
    let mut chart = ChartBuilder::on(&root)
        .margin(15)
        .margin_right(LEGEND)
        .x_label_area_size(55)
        .y_label_area_size(95)
        .build_cartesian_2d(0.0..end, range)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.12))
        .label_style(("sans-serif", 16))
        .axis_desc_style(("sans-serif", 18))
        .x_label_formatter(&label)
        .y_label_formatter(&label)
        .x_desc("time / s")
        .y_desc(unit)
        .draw()?;
    for (index, line) in lines.iter().enumerate() {
        let style = COLORS[index % COLORS.len()].stroke_width(2);
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
        root.draw(&PathElement::new([(x, y), (x + 16, y)], style))?;
        root.draw(&Text::new(line.name, (x + 22, y - 8), ("sans-serif", 16)))?;
    }
    root.present()
}

#[cfg(test)]
mod tests {
    use super::label;

    #[test]
    fn labels_are_short() {
        let labels = [0.0, 0.30000000000000004, 1500.0, -2.5e7, 1e-4].map(|x| label(&x));
        assert_eq!(labels, ["0", "0.3", "1500", "-2.5e7", "1e-4"]);
    }
}
