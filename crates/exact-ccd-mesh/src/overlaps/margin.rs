//! The amounts by which boxes are larger than their primitives.

use exact_ccd::Separations;

use crate::mesh::TriangleMesh;
use crate::pairs::MinDistance;

/// The amounts by which each side of each box is moved outwards.
///
/// If two primitives are within d of each other at a time, then each coordinate of two of their
/// points differs by at most d there. Each point is in the box of its primitive at that time. So
/// boxes with margins whose sum is at least d meet at that time, and no axis separates them at both
/// ends in the same order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Margin {
    min_distance: MinDistance,
    /// A margin of all primitives, in addition to that for their minimum distance.
    common: f64,
}

impl Margin {
    pub(crate) fn new(min_distance: MinDistance, common: f64) -> Self {
        Self { min_distance, common }
    }

    /// The margin, if it is the same for all primitives.
    pub(crate) fn uniform(&self) -> Option<f64> {
        match self.min_distance.separations() {
            Separations::Uniform(d) => Some(sum(half(d.get()), self.common)),
            Separations::Thickness(_) => None,
        }
    }

    /// The margin of a primitive, given by its vertices.
    pub(crate) fn of(&self, vertices: &[u32]) -> f64 {
        match self.min_distance.separations() {
            Separations::Uniform(d) => sum(half(d.get()), self.common),
            Separations::Thickness(thickness) => sum(summand(thickness.of(vertices).get()), self.common),
        }
    }

    /// For each vertex, the largest margin of the primitives that it belongs to.
    pub(crate) fn largest(&self, mesh: &TriangleMesh) -> Vec<f64> {
        let mut largest: Vec<f64> = (0..mesh.vertex_count() as u32)
            .map(|vertex| self.of(&[vertex]))
            .collect();
        let faces = mesh.faces().iter().map(<[u32; 3]>::as_slice);
        let edges = mesh.loose_edges().iter().map(<[u32; 2]>::as_slice);
        for vertices in faces.chain(edges) {
            let margin = self.of(vertices);
            for &vertex in vertices {
                let largest = &mut largest[vertex as usize];
                *largest = largest.max(margin);
            }
        }
        largest
    }
}

/// At least half of a distance, which is not negative; 0 for 0.
pub(crate) fn half(distance: f64) -> f64 {
    // Exact, but for the half of a subnormal number.
    above_subnormal(0.5 * distance, distance)
}

/// At least a thickness, so that two of them are together at least the sum of the two thicknesses,
/// rounded up; 0 for 0.
///
/// Rounding up adds less than a unit in the last place of the sum, which is at most two units in the
/// last place of the larger summand. That one is larger by so much.
fn summand(thickness: f64) -> f64 {
    above_subnormal(thickness.next_up().next_up(), thickness)
}

/// A number that is larger by the effects of underflow, unless `of` is 0: subnormal numbers may be
/// rounded, or flushed to zero, in sums and in comparisons of boxes.
fn above_subnormal(margin: f64, of: f64) -> f64 {
    // By its bits, because a comparison may read a subnormal number as zero.
    if of.to_bits() == 0 {
        0.0
    } else {
        margin + 4.0 * f64::MIN_POSITIVE
    }
}

/// At least the sum of two margins; exact if one is 0. By their bits, and larger by more than two
/// subnormal numbers, which a sum may read as zero.
fn sum(a: f64, b: f64) -> f64 {
    if a.to_bits() == 0 {
        b
    } else if b.to_bits() == 0 {
        a
    } else {
        (a + b).next_up() + 4.0 * f64::MIN_POSITIVE
    }
}
