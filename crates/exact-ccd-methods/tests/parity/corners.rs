//! F at the corners of the domain of (u, v), as differences of points.

use std::fmt::Debug;

use exact_ccd::{EdgeEdge, Kind, Point, VertexFace};

use exact_ccd_testing::primitives::Points;

pub(crate) trait Corners: Kind<Points = [Point; 4]> + PartialEq + Debug {
    /// The differences in the order of the checks.
    const DIFFERENCES: &'static [[usize; 2]];

    /// The pairs of points with these differences.
    fn pairs(points: &Points) -> Vec<[Point; 2]> {
        let pair = |now: &[Point; 4], [i, j]: [usize; 2]| [now[i], now[j]];
        points
            .iter()
            .flat_map(|now| Self::DIFFERENCES.iter().map(|&ij| pair(now, ij)))
            .collect()
    }
}

impl Corners for VertexFace {
    const DIFFERENCES: &'static [[usize; 2]] = &[[0, 1], [0, 2], [0, 3]];
}

impl Corners for EdgeEdge {
    const DIFFERENCES: &'static [[usize; 2]] = &[[0, 2], [0, 3], [1, 2], [1, 3]];
}
