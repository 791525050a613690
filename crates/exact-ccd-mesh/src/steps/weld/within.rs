//! Welding of vertices that are near each other.

use std::collections::HashMap;

use exact_ccd::Point;

use super::Welding;
use crate::mesh::DisjointSets;
use crate::vector::{dot, minus};

/// A cube of the grid, in one of the sets of vertices that may be welded.
type Cell = (u32, [i64; 3]);

impl Welding {
    /// Separates the vertices that are not near each other in a frame with these positions: what
    /// [`restrict`](Self::restrict) does with a tolerance of 0. Two vertices stay together if they are at
    /// most `tolerance` apart, or if a chain of such vertices connects them. Distances are rounded.
    ///
    /// The new vertex moves as the first of its vertices. So the surface changes by the distance of the
    /// others from it, and so does every answer. The tolerance should be at least 2⁻⁵⁰ of the coordinates, in
    /// magnitude; of a smaller one, vertices may be kept apart that are within it.
    ///
    /// ```
    /// use exact_ccd_mesh::Welding;
    ///
    /// let x = |x: f64| [x, 0.0, 0.0];
    /// let mut welding = Welding::default();
    /// welding.restrict_within(&[x(0.0), x(5.0), x(1e-9), x(2e-9)], 1e-9);
    /// assert_eq!(welding.first_vertices(), [0, 1]);
    /// // The last vertex comes apart.
    /// welding.restrict_within(&[x(0.0), x(5.0), x(0.0), x(1.0)], 1e-9);
    /// assert_eq!(welding.first_vertices(), [0, 1, 3]);
    /// ```
    pub fn restrict_within(&mut self, positions: &[Point], tolerance: f64) {
        self.vertex_of.resize(positions.len(), 0);
        let mut sets = DisjointSets::new(positions.len());
        // The vertices of different positions.
        let mut cells: HashMap<Cell, Vec<u32>> = HashMap::new();
        for (vertex, (&set, &position)) in (0..).zip(self.vertex_of.iter().zip(positions)) {
            let mut is_first = true;
            let cell = cell(position, tolerance);
            for near in around(cell) {
                for &other in cells.get(&(set, near)).into_iter().flatten() {
                    let place = positions[other as usize];
                    if is_within(place, position, tolerance) {
                        sets.unite(other, vertex);
                        is_first &= place != position;
                    }
                }
            }
            if is_first {
                cells.entry((set, cell)).or_default().push(vertex);
            }
        }
        let mut number_of = vec![None; positions.len()];
        self.first.clear();
        for (vertex, number) in self.vertex_of.iter_mut().enumerate() {
            *number = *number_of[sets.root(vertex as u32) as usize].get_or_insert_with(|| {
                self.first.push(vertex);
                self.first.len() as u32 - 1
            });
        }
    }
}

/// The cell of a position in a grid of twice the tolerance.
///
/// Quotients of positions within the tolerance differ by at most 1/2. Below 2⁵⁰, each is rounded by at most
/// 1/8, so that the computed ones differ by less than 1, and their cells by at most 1 along each axis.
fn cell(position: Point, tolerance: f64) -> [i64; 3] {
    let side = 2.0 * tolerance;
    // A quotient that is no number, 0 / 0, is 0 here, and those beyond the integers are the last ones.
    position.map(|x| (x / side).floor() as i64)
}

/// The cell and its neighbours.
fn around([x, y, z]: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    let beside = |x: i64| [x.saturating_sub(1), x, x.saturating_add(1)];
    let plane = move |x| beside(y).map(|y| [x, y]);
    let rows = beside(x).into_iter().flat_map(plane);
    rows.flat_map(move |[x, y]| beside(z).map(|z| [x, y, z]))
}

fn is_within(a: Point, b: Point, tolerance: f64) -> bool {
    // The quotients keep the squares from overflow and underflow.
    let apart = minus(a, b).map(|x| x / tolerance);
    a == b || dot(apart, apart) <= 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sets are those of all pairs within the tolerance, whatever the order of the vertices.
    #[test]
    fn sets_are_those_of_all_pairs() {
        let mut random = fastrand::Rng::with_seed(49);
        for _ in 0..50 {
            let scale = [1e-200, 1.0, 1e200][random.usize(0..3)];
            let point = |random: &mut fastrand::Rng| [0; 3].map(|_| scale * (random.f64() - 0.5));
            let positions: Vec<Point> = (0..120).map(|_| point(&mut random)).collect();
            let tolerance = scale * 0.3 * random.f64();
            let mut expected = DisjointSets::new(positions.len());
            for (a, &p) in positions.iter().enumerate() {
                for (b, &q) in positions.iter().enumerate().take(a) {
                    let d = minus(p, q).map(|x| x / scale);
                    if dot(d, d).sqrt() <= tolerance / scale {
                        expected.unite(a as u32, b as u32);
                    }
                }
            }
            let mut welding = Welding::default();
            welding.restrict_within(&positions, tolerance);
            for (a, b) in (0..120).flat_map(|a| (0..a).map(move |b| (a, b))) {
                let are_one = welding.vertex_of(a) == welding.vertex_of(b);
                assert_eq!(are_one, expected.root(a) == expected.root(b), "{a} {b}");
            }
        }
    }

    #[test]
    fn a_tolerance_of_0_is_the_exact_welding() {
        let x = |x: f64| [x, 0.0, -x];
        let positions = [x(0.0), x(1.0), x(-0.0), x(1.0), x(1.0 + f64::EPSILON), x(5e-324)];
        let (mut exact, mut within) = (Welding::default(), Welding::default());
        exact.restrict(&positions);
        within.restrict_within(&positions, 0.0);
        assert_eq!(exact, within);
    }
}
