//! The output of `exact-ccd round`.

use std::fmt;

use exact_ccd::Point;
use exact_ccd_methods::parity::Displacement;
use serde::Serialize;

use super::histogram::Histogram;
use crate::shortest::shortest;

/// The displacements and the rounding errors of the coordinates.
pub(super) struct Report {
    displacements: Displacements,
    pub(super) errors: Histogram,
}

/// The displacements of the coordinates.
enum Displacements {
    Shared(Point),
    /// The largest along each axis.
    PerQuery(Point),
}

impl Report {
    /// A report of no points yet, with one displacement for all.
    pub(super) fn shared(displacement: Displacement) -> Self {
        Self {
            displacements: Displacements::Shared(displacement.along_axes()),
            errors: Histogram::default(),
        }
    }

    /// A report of no points yet, with a displacement for each query.
    pub(super) fn per_query() -> Self {
        Self {
            displacements: Displacements::PerQuery([0.0; 3]),
            errors: Histogram::default(),
        }
    }

    /// Adds points that were moved by this displacement and rounded.
    pub(super) fn add(&mut self, displacement: Displacement, points: &[Point]) {
        if let Displacements::PerQuery(largest) = &mut self.displacements {
            let moved = displacement.along_axes();
            *largest = [0, 1, 2].map(|axis: usize| largest[axis].max(moved[axis]));
        }
        for &point in points {
            for error in displacement.error(point) {
                self.errors.add(error);
            }
        }
    }
}

/// The report in the shape of the JSON object.
#[derive(Serialize)]
struct JsonReport {
    /// That of all points, or the largest of those of the queries.
    displacement: Point,
    per_query: bool,
    coordinates: usize,
    largest_error: f64,
    errors: Vec<Decade>,
}

/// The number of errors from 10ᵏ up to below 10ᵏ⁺¹; k is null for the number of zeros.
#[derive(Serialize)]
struct Decade {
    decade: Option<i32>,
    count: usize,
}

impl Report {
    pub(super) fn to_json(&self) -> String {
        let (per_query, displacement) = match self.displacements {
            Displacements::Shared(displacement) => (false, displacement),
            Displacements::PerQuery(largest) => (true, largest),
        };
        let errors = self
            .errors
            .counts()
            .map(|(decade, count)| Decade { decade, count });
        let report = JsonReport {
            displacement,
            per_query,
            coordinates: self.errors.total(),
            largest_error: self.errors.largest(),
            errors: errors.collect(),
        };
        serde_json::to_string(&report).expect("numbers only")
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, displacement) = match self.displacements {
            Displacements::Shared(displacement) => ("displacement", displacement),
            Displacements::PerQuery(largest) => ("largest displacements", largest),
        };
        let [x, y, z] = displacement.map(shortest);
        writeln!(f, "{name} along x, y, z: {x}, {y}, {z}")?;
        let (count, largest) = (self.errors.total(), shortest(self.errors.largest()));
        write!(
            f,
            "rounding errors |x + e - fl(x + e)| of {count} coordinates, at most {largest}:{}",
            self.errors
        )
    }
}
