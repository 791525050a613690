//! Planes between parts of two bodies.

use exact_ccd::Point;

use super::encounter::{Encounter, Nodes};
use super::scene::Scene;
use crate::vector::{dot, minus, unit};

/// The most directions that are tried.
const TRIES: usize = 4;

impl Encounter<'_> {
    /// Returns true if a plane certainly separates all primitives below two nodes in the whole part: at both
    /// ends, a slab as thick as the margin lies between the vertices of one and the vertices of the other
    /// one. Then parallel planes separate them at all times (`apart.rs`).
    ///
    /// Gilbert's algorithm for the distance of two convex hulls has the directions: to the point
    /// nearest to 0 that is known among the differences of their points, at both ends. The vertex that is
    /// farthest in a direction is found up to rounding, by less than 2⁻⁴⁸ of the reach, which is in the
    /// margin.
    pub(super) fn has_plane_between(&self, scene: &Scene, pair: Nodes) -> bool {
        let centers = [0, 1].map(|i: usize| {
            let sphere = self.bodies[i].tree.node(pair[i]).sphere;
            scene.placed[i].at_ends(sphere.center)
        });
        let [first, second] = centers.map(|[a, b]| between(a, b, 0.5));
        let mut nearest = minus(second, first);
        for _ in 0..TRIES {
            let Some(direction) = unit(nearest) else {
                return false;
            };
            let differences = [0, 1].map(|end: usize| {
                let first = self.farthest(scene, pair, 0, end, direction);
                let second = self.farthest(scene, pair, 1, end, direction.map(|x| -x));
                minus(second, first)
            });
            let gaps = differences.map(|difference| dot(direction, difference));
            let slab = scene.margin * (1.0 + 1e-12);
            if gaps.iter().all(|&gap| gap > slab) {
                return true;
            }
            let least = differences[usize::from(gaps[1] < gaps[0])];
            nearest = nearest_to_origin(nearest, least);
        }
        false
    }

    /// The place, at an end of the part, of the vertex below a node that is farthest in a direction.
    fn farthest(&self, scene: &Scene, pair: Nodes, body: usize, end: usize, direction: Point) -> Point {
        let placed = &scene.placed[body];
        let direction = placed.turned_back(direction, end);
        placed.at(self.bodies[body].tree.farthest(pair[body], direction), end)
    }
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
