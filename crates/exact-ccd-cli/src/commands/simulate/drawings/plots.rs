//! Plots of the energies and of the minimal distance over time.

use exact_ccd_compare::plot::plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use exact_ccd_compare::plot::plotters::prelude::*;
use exact_ccd_compare::plot::plotters::series::LineSeries;
use exact_ccd_compare::plot::{
    Area, Axis, Drawn, Frame, GREATEST, Scale, color, decades, linear, logarithmic, power, svg, write,
};
use exact_ccd_sim::Energies;
use exact_ccd_view::Curve;

use crate::commands::simulate::folder::OutputFolder;
use crate::commands::simulate::folder::layout::{DISTANCE, ENERGIES};
use crate::commands::simulate::folder::statistics::Row;
use crate::files::outputs::write_file;
use crate::messages::failure::Failure;
use crate::view::curves;

const SIZE: (u32, u32) = (1000, 640);

/// The width of the legend.
const LEGEND: i32 = 170;

/// Returns false for numbers that are too large for a plot: a table that was edited may have any.
fn is_drawn(x: &f64) -> bool {
    x.abs() <= GREATEST
}

/// Plots the statistics in a folder of a scene with this name. `contact_distance` is d̂, in m.
pub(crate) fn draw(folder: &OutputFolder, scene: &str, contact_distance: f64) -> Result<(), Failure> {
    let mut rows = folder.statistics()?;
    rows.retain(|row| is_drawn(&row.time));
    let write = |name: &str, drawing: String| {
        write_file(&folder.file(name), |writer| {
            std::io::Write::write_all(writer, drawing.as_bytes())
        })
    };
    write(ENERGIES, energies(scene, &rows))?;
    write(DISTANCE, minimal_distance(scene, &rows, contact_distance))
}

/// The plot of the energies.
fn energies(scene: &str, rows: &[Row]) -> String {
    let energies: Vec<Energies> = rows.iter().map(Row::energies).collect();
    let curves = curves::energies(&energies);
    let (least, most) = range(&curves);
    let scale = Scale::of(most.max(-least));
    let axis = Axis {
        title: &format!("energy / {}", scale.unit("J")),
        label: &|energy: &f64| scale.number(*energy),
    };
    let title = format!("{scene}: energies");
    svg(SIZE, |area| {
        draw_lines(rows, &curves, &title, axis, linear(least, most), area)
    })
}

/// The plot of the minimal distance and of the contact distance.
fn minimal_distance(scene: &str, rows: &[Row], contact_distance: f64) -> String {
    let minimal = rows.iter().map(|row| row.minimal_distance).collect();
    let curves = curves::distances(minimal, contact_distance);
    let (first, last) = decades(values(&curves));
    let axis = Axis {
        title: "distance / m",
        label: &power,
    };
    let title = format!("{scene}: minimal distance");
    svg(SIZE, |area| {
        draw_lines(rows, &curves, &title, axis, logarithmic(first, last), area)
    })
}

fn values(curves: &[Curve]) -> impl Iterator<Item = f64> {
    let values = curves.iter().flat_map(|curve| &curve.values);
    values.flatten().copied().filter(is_drawn)
}

/// The range of 0 and all values.
fn range(curves: &[Curve]) -> (f64, f64) {
    let (least, most) = values(curves).fold((0.0_f64, 0.0_f64), |(least, most), value| {
        (least.min(value), most.max(value))
    });
    if least < most { (least, most) } else { (0.0, 1.0) }
}

fn draw_lines<'a, Y>(
    rows: &[Row],
    curves: &[Curve],
    title: &str,
    y: Axis<'_, f64>,
    range: impl AsRangedCoord<CoordDescType = Y, Value = f64>,
    area: &Area<'a>,
) -> Drawn<'a>
where
    Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    let times = rows.iter().map(|row| row.time);
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
    for (index, curve) in curves.iter().enumerate() {
        let style = color(index).stroke_width(2);
        let points = rows.iter().zip(&curve.values);
        let points: Vec<_> = points
            .map(|(row, value)| (row.time, value.filter(is_drawn)))
            .collect();
        for piece in points.split(|(_, value)| value.is_none()) {
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
        write(area, &curve.name, (x + 22, y - 8))?;
    }
    Ok(())
}
