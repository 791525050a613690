//! The change of a mesh by a repair, in numbers.

use exact_ccd_mesh::vector::{dot, minus};
use exact_ccd_mesh::{Point, TriangleMesh};

use crate::faces::{Neighbours, aspect, double_area, neighbours};
use crate::size::Size;

/// The change of a mesh in numbers. Displacements are relative to the diagonal of the box around the mesh
/// before, stretches to the lengths of edges before, areas to those before. Edges of length 0 before do not
/// count, nor do faces of area 0 before.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Change {
    /// The number of vertices whose position differs.
    pub moved: usize,
    /// The mean displacement of all vertices.
    pub mean_displacement: f64,
    /// The displacement that 95 % of the vertices do not exceed.
    pub p95_displacement: f64,
    /// The largest displacement.
    pub max_displacement: f64,
    /// The least stretch of an edge.
    pub min_stretch: f64,
    /// The stretch that 5 % of the edges do not exceed.
    pub p5_stretch: f64,
    /// The stretch that 95 % of the edges do not exceed.
    pub p95_stretch: f64,
    /// The largest stretch of an edge.
    pub max_stretch: f64,
    /// The least area of a face.
    pub min_area: f64,
    /// The area that 5 % of the faces do not exceed.
    pub p5_area: f64,
    /// The area that 95 % of the faces do not exceed.
    pub p95_area: f64,
    /// The largest area of a face.
    pub max_area: f64,
    /// The number of pairs of faces beside an edge that are turned over against each other, with an angle
    /// above 90° between their normals, and were not before. A right angle that grows by a degree is none.
    pub folds: usize,
    /// The worst aspect of a face before: the longest side divided by the height on it. 1.15 is the best.
    pub worst_aspect_before: f64,
    /// The worst aspect of a face after.
    pub worst_aspect: f64,
}

/// The stretch beyond which an edge counts as too long.
const LONG: f64 = 1.5;

/// The stretch that 95 % of the edges should not exceed.
const LONGER: f64 = 1.05;

/// The factor by which the worst aspect may grow.
const SLENDER: f64 = 2.0;

impl Change {
    /// The change of a mesh from positions to others.
    pub(crate) fn new(mesh: &TriangleMesh, size: &Size, before: &[Point], after: &[Point]) -> Self {
        // A mesh without extent is not moved.
        let unit = if size.diagonal > 0.0 { size.diagonal } else { 1.0 };
        let displacement = |(&a, &b): (&Point, &Point)| length(minus(a, b)) / unit;
        let displacements = Sorted::new(before.iter().zip(after).map(displacement));
        let of_edge = |x: &[Point], [a, b]: [u32; 2]| length(minus(x[a as usize], x[b as usize]));
        let stretch = |&edge: &[u32; 2]| of_edge(after, edge) / of_edge(before, edge);
        let stretches = Sorted::new(
            mesh.edges()
                .iter()
                .map(stretch)
                .filter(|stretch| stretch.is_finite()),
        );
        let sum: f64 = displacements.0.iter().sum();
        let faces = mesh.faces();
        let area = |&face: &[u32; 3]| double_area(face, after) / double_area(face, before);
        let areas = Sorted::new(faces.iter().map(area).filter(|area| area.is_finite()));
        let is_new_fold = |pair: &Neighbours| pair.is_new_fold(mesh, [before, after]);
        let worst = |x: &[Point]| faces.iter().map(|&face| aspect(face, x)).fold(0.0, f64::max);
        Self {
            moved: before.iter().zip(after).filter(|(a, b)| a != b).count(),
            mean_displacement: sum / before.len().max(1) as f64,
            p95_displacement: displacements.quantile(0.95),
            max_displacement: displacements.quantile(1.0),
            min_stretch: stretches.quantile(0.0),
            p5_stretch: stretches.quantile(0.05),
            p95_stretch: stretches.quantile(0.95),
            max_stretch: stretches.quantile(1.0),
            min_area: areas.quantile(0.0),
            p5_area: areas.quantile(0.05),
            p95_area: areas.quantile(0.95),
            max_area: areas.quantile(1.0),
            folds: neighbours(mesh)
                .into_iter()
                .filter(|pair| is_new_fold(pair))
                .count(),
            worst_aspect_before: worst(before),
            worst_aspect: worst(after),
        }
    }

    /// The mean displacement, once and once more for each limit of a good repair that is exceeded: no new
    /// fold, no edge beyond 1.5 times its length, 95 % of the edges within 1.05 times, and no aspect beyond
    /// twice the worst one before.
    pub(crate) fn damage(&self) -> f64 {
        let exceeded = [
            self.folds > 0,
            self.max_stretch > LONG,
            self.p95_stretch > LONGER,
            self.worst_aspect > SLENDER * self.worst_aspect_before,
        ];
        let count: f64 = exceeded.map(f64::from).iter().sum();
        (1.0 + count) * self.mean_displacement
    }
}

fn length(vector: Point) -> f64 {
    dot(vector, vector).sqrt()
}

/// Numbers in increasing order.
struct Sorted(Vec<f64>);

impl Sorted {
    fn new(values: impl Iterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.collect();
        values.sort_unstable_by(f64::total_cmp);
        Self(values)
    }

    /// The least number that a fraction of all do not exceed; 0 if there is none.
    fn quantile(&self, fraction: f64) -> f64 {
        let place = (fraction * self.0.len() as f64).ceil() as usize;
        self.0.get(place.saturating_sub(1)).copied().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_numbers_of_the_set() {
        let sorted = Sorted::new((1..=20).rev().map(f64::from));
        let quantiles = [0.0, 0.05, 0.5, 0.95, 0.951, 1.0].map(|fraction| sorted.quantile(fraction));
        assert_eq!(quantiles, [1.0, 1.0, 10.0, 19.0, 20.0, 20.0]);
        assert_eq!(Sorted::new(std::iter::empty()).quantile(0.5), 0.0);
    }
}
