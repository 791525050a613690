//! An order in which the boxes of each block, and of each node of a tree of blocks, are near each other.

use core::cmp::Ordering::Equal;

use exact_ccd::Point;
use rayon::prelude::*;

use super::aabb::Aabb;
use super::block::LANES;

/// The center of a box, and the index of the box.
type Placed = (Point, u32);

/// The least number of boxes whose parts are ordered by two threads.
const GRAIN: usize = 4096;

/// The indices of boxes, in an order in which the boxes of a block are near each other, and so are the boxes
/// of a node of the tree. A node has as many children as a block has boxes.
///
/// The boxes are divided along the longest side of the box around their centers, into halves of whole blocks
/// or nodes; so are the halves: J. L. Bentley, *Multidimensional binary search trees used for associative
/// searching*, 1975.
pub(crate) fn order(ids: Vec<u32>, center: impl Fn(u32) -> Point + Sync) -> Vec<u32> {
    let mut placed: Vec<Placed> = ids
        .into_par_iter()
        .with_min_len(GRAIN)
        .map(|id| (center(id), id))
        .collect();
    let mut node = LANES;
    while node < placed.len() {
        node *= LANES;
    }
    divide(&mut placed, node);
    placed.into_iter().map(|(_, id)| id).collect()
}

/// Divides the boxes of a node, or of some of its children, until the parts are blocks. The number of boxes
/// of a node is a power of eight; only the last node has fewer.
fn divide(placed: &mut [Placed], mut node: usize) {
    if placed.len() <= LANES {
        return;
    }
    while placed.len() <= node / LANES {
        node /= LANES;
    }
    let child = node / LANES;
    let middle = placed.len().div_ceil(child) / 2 * child;
    let axis = around(placed.iter().map(|&(center, _)| center)).longest_side();
    // There is no NaN here. This comparison takes less time than a total order of floating-point numbers.
    placed.select_nth_unstable_by(middle, |(a, _), (b, _)| {
        a[axis].partial_cmp(&b[axis]).unwrap_or(Equal)
    });
    let (first, second) = placed.split_at_mut(middle);
    if first.len() < GRAIN {
        divide(first, node);
        divide(second, node);
    } else {
        rayon::join(|| divide(first, node), || divide(second, node));
    }
}

/// The sum of the longest sides of the boxes around the points of each block in an order: small if points
/// that are near in the order are near each other.
pub(crate) fn extent(points: &[Point], order: &[u32]) -> f64 {
    let blocks = order.chunks(LANES);
    let boxes = blocks.map(|block| around(block.iter().map(|&id| points[id as usize])));
    boxes.map(|aabb| aabb.sides()[aabb.longest_side()]).sum()
}

fn around(points: impl Iterator<Item = Point>) -> Aabb {
    points.collect()
}

#[cfg(test)]
mod tests {
    use exact_ccd::Point;
    use fastrand::Rng;

    use super::{extent, order};

    #[test]
    fn blocks_of_a_grid_are_cubes() {
        let mut rng = Rng::with_seed(0);
        let mut points: Vec<Point> = (0..4096)
            .map(|i| [i % 16, i / 16 % 16, i / 256].map(f64::from))
            .collect();
        rng.shuffle(&mut points);
        let found = order((0..4096).collect(), |id| points[id as usize]);
        // 512 cubes of side 1.
        assert_eq!(extent(&points, &found), 512.0);
        assert!(extent(&points, &(0..4096).collect::<Vec<_>>()) > 5000.0);
        let mut ids = found;
        ids.sort_unstable();
        assert!(ids.into_iter().eq(0..4096));
    }

    /// The last node of a level has fewer boxes than the others, and still whole blocks but one.
    #[test]
    fn blocks_of_points_on_a_line_follow_each_other() {
        let mut rng = Rng::with_seed(0);
        for count in [9, 15, 17, 63, 65, 513, 1000, 4097, 9000_u32] {
            for axis in 0..3 {
                let mut points: Vec<u32> = (0..count).collect();
                rng.shuffle(&mut points);
                let place = |id: u32| points[id as usize];
                let found = order((0..count).collect(), |id| {
                    let mut point = [1.0; 3];
                    point[axis] = f64::from(place(id));
                    point
                });
                let mut next = 0;
                for block in found.chunks(8) {
                    let mut places: Vec<u32> = block.iter().map(|&id| place(id)).collect();
                    places.sort_unstable();
                    assert!(
                        places.into_iter().eq(next..next + block.len() as u32),
                        "{count} {axis}"
                    );
                    next += block.len() as u32;
                }
            }
        }
    }

    #[test]
    fn boxes_are_divided_along_the_longest_side() {
        let mut points: Vec<Point> = (0..64).map(|i| [i / 2, i % 2, 0].map(f64::from)).collect();
        Rng::with_seed(0).shuffle(&mut points);
        let found = order((0..64).collect(), |id| points[id as usize]);
        // Eight blocks of 4 by 2 points.
        assert_eq!(extent(&points, &found), 24.0);
    }

    #[test]
    fn an_extent_is_the_sum_of_the_longest_sides() {
        let along_x = (0..8).map(|i| [f64::from(i), 0.0, 0.0]);
        let along_y = (0..4).map(|i| [0.5, f64::from(i), 1.0]);
        let points: Vec<Point> = along_x.chain(along_y).collect();
        assert_eq!(extent(&points, &(0..12).collect::<Vec<_>>()), 10.0);
    }

    #[test]
    fn each_index_comes_once_wherever_the_points_are() {
        let mut rng = Rng::with_seed(0);
        for count in [0, 1, 7, 8, 9, 63, 65, 511, 513, 20_000] {
            let sizes = [0.0, 1.0, 1e-320, f64::MAX];
            let points: Vec<Point> = (0..count)
                .map(|_| [0, 1, 2].map(|_| sizes[rng.usize(..4)] * (2.0 * rng.f64() - 1.0)))
                .collect();
            let mut ids = order((0..count).rev().collect(), |id| points[id as usize]);
            ids.sort_unstable();
            assert!(ids.into_iter().eq(0..count), "{count}");
        }
    }
}
