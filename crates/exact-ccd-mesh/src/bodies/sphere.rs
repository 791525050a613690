//! Spheres around primitives, in the coordinates of their body.

use exact_ccd::Point;

use crate::broad_phase::Aabb;
use crate::vector::{dot, minus};

/// A ball around points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sphere {
    pub(super) center: Point,
    pub(super) radius: f64,
}

impl Sphere {
    /// The ball around points with a center.
    ///
    /// A distance has less than ten roundings, in any direction; squares below 2⁻¹⁰²² may vanish. An
    /// overflow leads to an infinite radius, or to one that is not a number: nothing is outside of these.
    fn centered(center: Point, points: impl Iterator<Item = Point>) -> Self {
        let distances = points.map(|point| length(minus(point, center)));
        let most = distances.fold(0.0, |most: f64, x| if x <= most { most } else { x });
        Self {
            center,
            radius: most * (1.0 + 1e-12) + 1e-150,
        }
    }

    /// A ball around the points of a set of primitives: its center is the center of their box.
    pub(super) fn around(points: impl Iterator<Item = Point> + Clone) -> Self {
        let all = points
            .clone()
            .fold(Aabb::EMPTY, |all, point| all.union(&Aabb::of(point)));
        Self::centered(all.center(), points)
    }

    /// A small ball around a primitive: its center is the middle of two vertices, or the mean of all.
    pub(super) fn of_primitive(points: &[Point]) -> Self {
        let mean = |points: &[Point]| {
            let part = 1.0 / points.len() as f64;
            [0, 1, 2].map(|axis: usize| points.iter().map(|point| part * point[axis]).sum())
        };
        let centered = |center| Self::centered(center, points.iter().copied());
        let middles = (0..points.len()).map(|i| mean(&[points[i], points[(i + 1) % points.len()]]));
        let all = middles.chain([mean(points)]).map(centered);
        let least = all.reduce(|least, next| if next.radius < least.radius { next } else { least });
        least.unwrap_or_else(|| centered([0.0; 3]))
    }
}

/// The length of a vector, rounded.
pub(super) fn length(vector: Point) -> f64 {
    dot(vector, vector).sqrt()
}
