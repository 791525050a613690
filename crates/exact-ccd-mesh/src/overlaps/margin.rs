//! The amounts by which boxes are larger than their primitives.

use exact_ccd::Separations;

use crate::broad_phase::{Format, sum_above};
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
    /// A margin of all primitives, in addition to the margin for their minimum distance.
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
pub(crate) fn half<F: Format>(distance: F) -> F {
    // Exact, but for the half of a subnormal number.
    above_subnormal(distance.halved(), distance)
}

/// At least a thickness. The sum of two such results is at least the sum of the two thicknesses, rounded up.
/// 0 for 0.
///
/// Rounding up adds less than a unit in the last place of the sum, which is at most two units in the last
/// place of the larger thickness. The result for that thickness is larger by so much.
fn summand<F: Format>(thickness: F) -> F {
    above_subnormal(thickness.next_up().next_up(), thickness)
}

/// A number that is larger by the effects of underflow, unless `of` is 0: subnormal numbers may be
/// rounded, or flushed to zero, in sums and in comparisons of boxes.
fn above_subnormal<F: Format>(margin: F, of: F) -> F {
    if of.is_zero() { of } else { margin + F::FLUSHED }
}

/// At least the sum of two margins; exact if one is 0.
fn sum<F: Format>(a: F, b: F) -> F {
    if a.is_zero() {
        b
    } else if b.is_zero() {
        a
    } else {
        sum_above(a, b)
    }
}

#[cfg(test)]
mod tests {
    use exact_ccd::{Separation, Thickness};

    use super::{Margin, half, sum, summand};
    use crate::broad_phase::small::{Environment, Small};
    use crate::mesh::TriangleMesh;
    use crate::pairs::MinDistance;

    /// The margins of a mesh of a face and a loose edge, whose last vertex belongs to neither.
    #[test]
    fn margins_of_primitives_cover_their_distances_and_little_more() {
        let mesh = TriangleMesh::with_edges(6, vec![[0, 1, 2]], &[[3, 4]]).expect("the indices are in range");
        let primitives: [&[u32]; 4] = [&[0, 1, 2], &[3, 4], &[4], &[5]];
        let thicknesses = [0.1, 0.3, 0.2, 0.5, 0.7, 0.9];
        let distances = [
            MinDistance::default(),
            MinDistance::uniform(Separation::new(0.1).expect("it is not negative")),
            MinDistance::thickness(Thickness::new(&thicknesses).expect("none is negative")),
        ];
        for (min_distance, uniform) in distances.into_iter().zip([Some(0.0), Some(0.05), None]) {
            for common in [0.0, 0.01] {
                let margin = Margin::new(min_distance.clone(), common);
                let is_tight = |margin: f64, least: f64| (least..=least * (1.0 + 1e-14)).contains(&margin);
                assert_eq!(margin.uniform().is_some(), uniform.is_some());
                assert!(
                    margin
                        .uniform()
                        .is_none_or(|m| is_tight(m, uniform.unwrap() + common))
                );
                for a in primitives {
                    for b in primitives {
                        let d = min_distance.separations().between(a, b).get();
                        assert!(
                            is_tight(margin.of(a) + margin.of(b), d + 2.0 * common),
                            "{a:?} {b:?}"
                        );
                    }
                }
                let [face, edge] = [primitives[0], primitives[1]].map(|vertices| margin.of(vertices));
                let largest = [face, face, face, edge, edge, margin.of(&[5])];
                assert_eq!(margin.largest(&mesh), largest);
            }
        }
    }

    #[test]
    fn margins_of_all_small_numbers_are_large_enough() {
        for environment in Environment::all() {
            for a in environment.numbers().filter(|a| a.value() >= 0.0) {
                assert!(2.0 * half(a).value() >= a.value(), "{a:?}");
                for b in environment.numbers().filter(|b| b.value() >= 0.0) {
                    let exact = a.value() + b.value();
                    assert!(sum(a, b).value() >= exact, "{a:?} {b:?}");
                    let together = summand(a).value() + summand(b).value();
                    assert!(together >= Small::least_above(exact), "{a:?} {b:?}");
                }
            }
        }
    }
}
