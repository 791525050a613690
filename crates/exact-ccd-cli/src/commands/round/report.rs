//! The output of `exact-ccd round`.

use std::fmt;

use exact_ccd::Point;
use exact_ccd_methods::parity::Displacement;
use serde::Serialize;

use super::histogram::Histogram;
use crate::text::numbers::shortest;

/// The displacements and the rounding errors of the coordinates, in the shape of the JSON object.
#[derive(Serialize)]
pub(super) struct Report {
    /// The displacement of all points, or along each axis the largest displacement of a query.
    displacement: Point,
    per_query: bool,
    #[serde(flatten)]
    pub(super) errors: Histogram,
}

impl Report {
    /// A report of no points yet, with one displacement for all, or else with one for each query.
    pub(super) fn new(shared: Option<Displacement>) -> Self {
        Self {
            displacement: shared.unwrap_or_default().along_axes(),
            per_query: shared.is_none(),
            errors: Histogram::default(),
        }
    }

    /// Adds points that were moved by this displacement and rounded.
    pub(super) fn add(&mut self, displacement: Displacement, points: &[Point]) {
        if self.per_query {
            let moved = displacement.along_axes();
            self.displacement = [0, 1, 2].map(|axis: usize| self.displacement[axis].max(moved[axis]));
        }
        for &point in points {
            for error in displacement.error(point) {
                self.errors.add(error);
            }
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = if self.per_query {
            "largest displacements"
        } else {
            "displacement"
        };
        let [x, y, z] = self.displacement.map(shortest);
        writeln!(f, "{name} along x, y, z: {x}, {y}, {z}")?;
        let (count, largest) = (self.errors.total(), shortest(self.errors.largest()));
        write!(
            f,
            "rounding errors |x + e - fl(x + e)| of {count} coordinates, at most {largest}:{}",
            self.errors
        )
    }
}
