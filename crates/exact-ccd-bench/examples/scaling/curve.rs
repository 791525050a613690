//! The cost of one question on meshes of increasing size.

use crate::measurement::Measurement;
use crate::memory::mebibytes;
use crate::question::Question;

/// The number of sizes per decade.
pub(crate) const PER_DECADE: usize = 2;

/// The measurements of one question, from the smallest mesh to the largest.
pub(crate) struct Curve {
    pub(crate) question: Question,
    pub(crate) points: Vec<Measurement>,
}

/// A cost that grows with the mesh.
#[derive(Clone, Copy)]
pub(crate) enum Cost {
    Seconds,
    Mebibytes,
}

impl Cost {
    pub(crate) fn of(self, measurement: &Measurement) -> Option<f64> {
        match self {
            Self::Seconds => Some(measurement.seconds),
            Self::Mebibytes => measurement.memory.map(mebibytes),
        }
    }
}

impl Curve {
    /// The triangles and the cost of each measurement whose cost is known and can be drawn on a
    /// logarithmic scale.
    pub(crate) fn places(&self, cost: Cost) -> impl Iterator<Item = (f64, f64)> {
        let place = move |point: &Measurement| Some((point.triangles as f64, cost.of(point)?));
        self.points
            .iter()
            .filter_map(place)
            .filter(|&(_, cost)| cost > 0.0)
    }

    /// The exponent with which a cost grows with the number of triangles, in the decade before the
    /// last and in the last, as far as they have been measured.
    pub(crate) fn slopes(&self, cost: Cost) -> Vec<f64> {
        let places: Vec<_> = self.places(cost).collect();
        let decades = places.windows(PER_DECADE + 1).rev().step_by(PER_DECADE).take(2);
        let slope = |decade: &[(f64, f64)]| {
            let ((x0, y0), (x1, y1)) = (decade[0], decade[PER_DECADE]);
            (y1 / y0).ln() / (x1 / x0).ln()
        };
        let mut slopes: Vec<f64> = decades.map(slope).collect();
        slopes.reverse();
        slopes
    }
}
