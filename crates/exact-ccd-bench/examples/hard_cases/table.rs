//! The columns of the file.

use std::io::{self, Write};

use exact_ccd::{ContactTime, Point};
use exact_ccd_data::{TableColumn, write_table};

/// A query and its answers.
#[derive(Clone)]
pub(crate) struct Row {
    pub(crate) kind: &'static str,
    pub(crate) class: &'static str,
    /// The points at t = 0 and at t = 1.
    pub(crate) points: [Vec<Point>; 2],
    pub(crate) distance: f64,
    pub(crate) first: Option<ContactTime>,
    /// The number of maximal intervals of times.
    pub(crate) intervals: usize,
    /// The number of times, if it is finite.
    pub(crate) count: Option<usize>,
}

impl Row {
    pub(crate) fn collides(&self) -> bool {
        self.first.is_some()
    }

    fn coordinate(&self, time: usize, point: usize, axis: usize) -> Option<f64> {
        self.points[time].get(point).map(|point| point[axis])
    }
}

pub(crate) fn write(writer: impl Write + Send, rows: &[Row]) -> io::Result<()> {
    let text =
        |of: fn(&Row) -> &'static str| TableColumn::Text(rows.iter().map(|row| Some(of(row))).collect());
    let integers =
        |of: fn(&Row) -> i64| TableColumn::Integers(rows.iter().map(|row| Some(of(row))).collect());
    let reals = |of: &dyn Fn(&Row) -> Option<f64>| TableColumn::Reals(rows.iter().map(of).collect());
    let mut columns = vec![
        ("kind".to_owned(), text(|row| row.kind)),
        ("class".to_owned(), text(|row| row.class)),
        ("distance".to_owned(), reals(&|row| Some(row.distance))),
        ("collides".to_owned(), integers(|row| row.collides().into())),
        (
            "time_lower".to_owned(),
            reals(&|row| row.first.map(ContactTime::lower)),
        ),
        (
            "time_upper".to_owned(),
            reals(&|row| row.first.map(ContactTime::upper)),
        ),
        (
            "count".to_owned(),
            integers(|row| row.count.map_or(-1, |count| count as i64)),
        ),
        ("intervals".to_owned(), integers(|row| row.intervals as i64)),
    ];
    for time in 0..2 {
        for point in 0..4 {
            for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
                let name = format!("t{time}_p{point}_{name}");
                columns.push((name, reals(&|row| row.coordinate(time, point, axis))));
            }
        }
    }
    let (names, columns): (Vec<String>, Vec<TableColumn<'_>>) = columns.into_iter().unzip();
    let columns: Vec<_> = names.iter().map(String::as_str).zip(columns).collect();
    write_table(writer, &columns)
}
