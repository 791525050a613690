//! Directions that separate the origin from points, in floating point.
//!
//! The least of g · p / |g| over some points is largest for the direction g of the point of their hull that
//! is closest to the origin: a point, or the foot on an edge, or the normal of a triangle. With at most
//! eight points, all of these are tried. Nothing here is exact; the checker verifies the directions.

use exact_ccd::Point;
use exact_ccd_mesh::vector::{cross, dot, minus};

/// The best direction, and the least g · p / |g|, if that is positive.
pub(crate) fn best(points: &[Point]) -> Option<(Point, f64)> {
    let mut best: Option<(Point, f64)> = None;
    let mut offer = |g: Point| {
        let length = dot(g, g).sqrt();
        let least = best.map_or(0.0, |(_, margin)| margin);
        if length > 0.0 && points.iter().all(|&p| dot(g, p) > least * length) {
            let margin = points
                .iter()
                .map(|&p| dot(g, p) / length)
                .fold(f64::INFINITY, f64::min);
            best = Some((g.map(|component| component / length), margin));
        }
    };
    for (i, &p) in points.iter().enumerate() {
        offer(p);
        for (j, &q) in points.iter().enumerate().skip(i + 1) {
            let edge = minus(q, p);
            let (along, square) = (dot(p, edge), dot(edge, edge));
            offer([0, 1, 2].map(|axis: usize| square * p[axis] - along * edge[axis]));
            for &r in &points[j + 1..] {
                let normal = cross(edge, minus(r, p));
                offer(if dot(normal, p) < 0.0 {
                    normal.map(|component| -component)
                } else {
                    normal
                });
            }
        }
    }
    best
}

/// A direction of unit length in integers of so many bits.
pub(crate) fn rounded(g: Point, bits: u32) -> [i64; 3] {
    let largest = g
        .iter()
        .fold(0.0_f64, |largest, component| largest.max(component.abs()));
    let scale = ((1_i64 << (bits - 1)) - 1) as f64 / largest;
    g.map(|component| (component * scale).round() as i64)
}
