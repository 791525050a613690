//! Planes between parts of two bodies.

#[cfg(test)]
mod tests;

use std::ops::{Add, Mul, Sub};

use exact_ccd::Point;

use super::encounter::{Encounter, Nodes};
use super::scene::Scene;
use crate::vector::{difference, dot, minus, product, unit};

/// The most directions that are tried.
const TRIES: usize = 4;

/// A bound of the round-off of a gap, in units of the largest distance of both bodies from the origin, one
/// after the other: 25 u.
///
/// Let u be the unit roundoff and |M| the matrix of magnitudes, whose norm is at most √3. A vertex v is
/// placed along the direction n by n · M v with 6 roundings of terms that sum up to |n| |M| |v|: three for
/// the direction in the coordinates of the body, and three for the product. The vertex that seems to be the
/// farthest is at most two such errors less far than the farthest, 12 √3 u. The gap of two
/// places has 4 roundings of terms that sum up to their distances from the origin. The ball of a node is
/// larger than its vertices by 2⁻⁴⁰, which covers that |n| is 1 up to some u, as does the slab.
const ROUNDOFF: f64 = 25.0 * 0.5 * f64::EPSILON;

impl Encounter<'_> {
    /// Returns true if a plane certainly separates all primitives below two nodes in the whole part.
    pub(super) fn has_plane_between(&self, scene: &Scene, pair: Nodes) -> bool {
        self.separating_direction(scene, pair).is_some()
    }

    /// The normal of planes that certainly separate all primitives below two nodes in the whole part: at both
    /// ends, a slab across it lies between the vertices of one and the vertices of the other one, as thick as
    /// the distance at which they touch and all deviations. Then parallel planes separate them at all times
    /// (`apart.rs`).
    ///
    /// Gilbert's algorithm for the distance of two convex hulls has the directions: to the point
    /// nearest to 0 that is known among the differences of their points, at both ends.
    fn separating_direction(&self, scene: &Scene, pair: Nodes) -> Option<Point> {
        let centers = [0, 1].map(|i: usize| {
            let sphere = self.bodies[i].tree.node(pair[i]).sphere;
            scene.placed[i].at_ends(sphere.center)
        });
        let [first, second] = centers.map(|[a, b]| between(a, b, 0.5));
        let mut nearest = minus(second, first);
        let roundoff = ROUNDOFF * (scene.placed[0].far + scene.placed[1].far);
        let slab = (scene.slab + roundoff) * (1.0 + 1e-12);
        for _ in 0..TRIES {
            let direction = unit(nearest)?;
            let ends = [0, 1].map(|end: usize| {
                let first = self.farthest(scene, pair, 0, end, direction);
                let second = self.farthest(scene, pair, 1, end, direction.map(|x| -x));
                [first, second]
            });
            let gaps = ends.map(|[first, second]| gap(direction, first, second));
            if gaps.iter().all(|&gap| gap > slab) {
                return Some(direction);
            }
            let [first, second] = ends[usize::from(gaps[1] < gaps[0])];
            nearest = nearest_to_origin(nearest, minus(second, first));
        }
        None
    }

    /// The place, at an end of the part, of the vertex below a node that is farthest in a direction.
    fn farthest(&self, scene: &Scene, pair: Nodes, body: usize, end: usize, direction: Point) -> Point {
        let placed = &scene.placed[body];
        let direction = placed.turned_back(direction, end);
        placed.at(self.bodies[body].tree.farthest(pair[body], direction), end)
    }
}

/// The distance of two places along a direction, in numbers of any kind.
fn gap<T>(direction: [T; 3], first: [T; 3], second: [T; 3]) -> T
where
    T: Copy + Add<Output = T> + Mul<Output = T> + Sub<Output = T>,
{
    product(direction, difference(second, first))
}

/// The point of a segment that is nearest to 0.
fn nearest_to_origin(start: Point, end: Point) -> Point {
    let change = minus(end, start);
    let time = -dot(start, change) / dot(change, change);
    between(start, end, time.clamp(0.0, 1.0))
}

fn between(start: Point, end: Point, time: f64) -> Point {
    [0, 1, 2].map(|axis: usize| start[axis] + time * (end[axis] - start[axis]))
}
