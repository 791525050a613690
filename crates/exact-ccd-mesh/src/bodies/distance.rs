//! The distances of bodies at poses, between certified bounds.

use arrayvec::ArrayVec;
use exact_ccd::motion::Pose;
use exact_ccd::predicates::EdgeFace;
use exact_ccd::{AnyKind, CONTACT, DistanceBounds, Kind, Point, Query, Separation, with_kind};
use rayon::prelude::*;

use super::Bodies;
use super::encounter::{Below, Encounter, Nodes};
use super::error::BodiesError;
use super::part::Part;
use super::scene::Scene;
use super::shape::{Primitive, Shape};
use super::sphere::{Sphere, length};
use super::tree::Leaf;
use super::world::World;
use crate::vector::{cross, dot, minus};

/// The distance of two bodies at rest, between two bounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyDistance {
    /// The indices of the bodies, the lesser first.
    pub bodies: [usize; 2],
    /// Bounds of the distance of the surfaces. The lower one is 0 if they may touch or pass through each
    /// other. They differ by the error of places in the world: some 10⁻¹² of the largest coordinates; they
    /// are 0 and infinite if coordinates are above 2⁴⁰⁰.
    pub bounds: DistanceBounds,
    /// A point of each body, in the coordinates of the world, rounded; their distance is within the bounds up
    /// to the error of the parameters of an [`Impact`](exact_ccd::Impact). If the bodies pass through each
    /// other, it may be one point of an edge and a face.
    pub points: [Point; 2],
}

impl Bodies {
    /// The distance of each pair of bodies at poses, one for each body, in increasing order of the pairs.
    /// Pairs that are farther apart than the cut-off, and pairs that cannot collide, are left out.
    ///
    /// The bounds are certified for the rotations and places of the poses as they are. The distance is that
    /// of surfaces: a body inside another one is at a distance from it.
    ///
    /// ```
    /// use exact_ccd::Separation;
    /// use exact_ccd::motion::Pose;
    /// use exact_ccd_mesh::{Bodies, Frame};
    ///
    /// let rod = || Frame::with_edges(vec![[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]], Vec::new(), &[[0, 1]]);
    /// let bodies = Bodies::new([rod()?, rod()?])?;
    /// // The second rod turns by a right angle about the z axis, and is above the first one.
    /// let poses = [
    ///     Pose::new([1.0, 0.0, 0.0, 0.0], [0.0; 3])?,
    ///     Pose::new([1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.75])?,
    /// ];
    /// let distances = bodies.distances(&poses, Separation::new(10.0)?)?;
    /// assert!(distances[0].bounds.lower <= 0.75 && distances[0].bounds.upper >= 0.75);
    /// assert!(distances[0].bounds.upper - distances[0].bounds.lower < 1e-11);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BodiesError::PoseCount`], if there is not one pose for each body; [`BodiesError::TooManyBodies`].
    pub fn distances(&self, poses: &[Pose], cut_off: Separation) -> Result<Vec<BodyDistance>, BodiesError> {
        let motions = self.motions(poses, poses)?;
        let cut_off = cut_off.get();
        let world = World::as_given(self, &motions, cut_off);
        let encounters = self.encounters(&world, &motions, CONTACT)?;
        let distances = encounters.par_iter().map(|encounter| encounter.distance(cut_off));
        Ok(distances.collect::<Vec<_>>().into_iter().flatten().collect())
    }

    /// The least distance of two bodies at poses; `None` if no two can collide. Of several pairs with the
    /// least lower bound, it is the first one.
    ///
    /// # Errors
    /// As [`distances`](Self::distances).
    pub fn distance(&self, poses: &[Pose]) -> Result<Option<BodyDistance>, BodiesError> {
        let farthest = Separation::new(f64::MAX).unwrap_or_default();
        let distances = self.distances(poses, farthest)?.into_iter();
        Ok(distances.reduce(|least, next| {
            if next.bounds.lower < least.bounds.lower {
                next
            } else {
                least
            }
        }))
    }
}

impl Encounter<'_> {
    /// The distance of two bodies at rest, unless it is above the cut-off.
    fn distance(&self, cut_off: f64) -> Option<BodyDistance> {
        let mut scene = Scene::new(Part::WHOLE, self.scene(Part::WHOLE).placed, 0.0);
        // Bodies at rest do not deviate from straight motion.
        scene.deviation = 0.0;
        let mut nearest = Nearest {
            encounter: self,
            bounds: DistanceBounds {
                lower: f64::INFINITY,
                upper: (cut_off + scene.margin).min(f64::MAX),
            },
            points: None,
            scene: &scene,
        };
        // Places without a bound of their errors say nothing.
        if scene.margin.is_finite() {
            nearest.descend(self.roots()?);
        } else {
            nearest.take(
                DistanceBounds {
                    lower: 0.0,
                    upper: f64::INFINITY,
                },
                self.some_points(&scene)?,
            );
        }
        nearest.found().filter(|found| found.bounds.lower <= cut_off)
    }

    /// The center of the ball around each body.
    fn some_points(&self, scene: &Scene) -> Option<[Point; 2]> {
        let nodes = self.roots()?;
        Some([0, 1].map(|i: usize| scene.placed[i].at(self.ball(i, nodes[i]).center, 0)))
    }

    fn ball(&self, body: usize, node: u32) -> Sphere {
        self.bodies[body].tree.node(node).sphere
    }
}

/// The nearest primitives so far, in rounded places of the world.
///
/// A rounded place is within an error of the exact one, and the margin of the scene is the sum of these of
/// both bodies, or more. So the distance of rounded primitives differs from the exact one by at most the
/// margin, and so does the least one of all pairs.
struct Nearest<'a> {
    encounter: &'a Encounter<'a>,
    scene: &'a Scene,
    /// Bounds of the least distance of rounded primitives. The upper one is the cut-off before there is any.
    bounds: DistanceBounds,
    points: Option<[Point; 2]>,
}

impl Nearest<'_> {
    /// The distance, with the error of rounded places.
    fn found(&self) -> Option<BodyDistance> {
        let DistanceBounds { lower, upper } = self.bounds;
        let margin = self.scene.margin;
        Some(BodyDistance {
            bodies: self.encounter.ids,
            bounds: DistanceBounds {
                lower: (lower - margin).next_down().max(0.0),
                upper: (upper + margin).next_up(),
            },
            points: self.points?,
        })
    }

    fn take(&mut self, bounds: DistanceBounds, points: [Point; 2]) {
        if bounds.upper < self.bounds.upper || self.points.is_none() {
            self.points = Some(points);
        }
        self.bounds.lower = self.bounds.lower.min(bounds.lower);
        self.bounds.upper = self.bounds.upper.min(bounds.upper);
    }

    /// Examines all pairs of nodes below one, the nearer ones first.
    fn descend(&mut self, pair: Nodes) {
        let mut stack = vec![(f64::NEG_INFINITY, pair)];
        while let Some((gap, pair)) = stack.pop() {
            if self.is_farther(gap) || self.bounds.upper.to_bits() == 0 {
                continue;
            }
            match self.encounter.below(self.scene, pair) {
                Below::Split(halves) => {
                    let mut halves = halves.map(|pair| (self.gap_of_nodes(pair), pair));
                    halves.sort_by(|(a, _), (b, _)| b.total_cmp(a));
                    stack.extend(halves);
                }
                Below::Leaves(leaves) => self.compare(leaves),
                // Only for a deviation.
                Below::Later => {}
            }
        }
    }

    /// Returns true if a gap is certainly above the least distance so far. It is not if it is not a number.
    fn is_farther(&self, gap: f64) -> bool {
        gap > self.bounds.upper
    }

    fn gap_of_nodes(&self, pair: Nodes) -> f64 {
        self.gap([0, 1].map(|i: usize| self.encounter.ball(i, pair[i])))
    }

    /// A bound below the distance of rounded points, one of each ball: these are within an error of balls
    /// around rounded centers. The errors of the distance of the centers are in the margin too.
    fn gap(&self, [one, other]: [Sphere; 2]) -> f64 {
        let centers = [
            self.scene.placed[0].at(one.center, 0),
            self.scene.placed[1].at(other.center, 0),
        ];
        let radii = one.radius + other.radius;
        length(minus(centers[0], centers[1])) - radii * (1.0 + 1e-12) - 2.0 * self.scene.margin
    }

    /// Compares the primitives of two leaves.
    fn compare(&mut self, leaves: [&Leaf; 2]) {
        let trees = self.encounter.bodies.map(|body| &body.tree);
        for one in trees[0].primitives(leaves[0]) {
            for other in trees[1].primitives(leaves[1]) {
                let gap = self.gap([one.sphere, other.sphere]);
                if self.is_farther(gap) {
                    continue;
                }
                match (one.shape, other.shape) {
                    (Shape::Edge, Shape::Face) if gap <= 0.0 => self.cross([one, other], [0, 1]),
                    (Shape::Face, Shape::Edge) if gap <= 0.0 => self.cross([one, other], [1, 0]),
                    _ => self.measure([one, other]),
                }
            }
        }
    }

    /// Takes a point of an edge that passes through a face; the order is the order of the edge and the face.
    fn cross(&mut self, pair: [&Primitive; 2], [edge, face]: [usize; 2]) {
        let places = [0, 1].map(|i: usize| self.places(i, pair[i]));
        let (&[a, b], &[c, d, e]) = (&places[edge][..], &places[face][..]) else {
            return;
        };
        if EdgeFace::new([a, b], [c, d, e]).is_ok_and(|query| query.intersects()) {
            let normal = cross(minus(d, c), minus(e, c));
            let part = dot(normal, minus(c, a)) / dot(normal, minus(b, a));
            // In a common plane, any point of the edge will do.
            let part = if part.is_nan() { 0.5 } else { part.clamp(0.0, 1.0) };
            let point = [0, 1, 2].map(|axis: usize| (1.0 - part) * a[axis] + part * b[axis]);
            self.take(
                DistanceBounds {
                    lower: 0.0,
                    upper: 0.0,
                },
                [point; 2],
            );
        }
    }

    /// Takes the distance of two primitives, if they are compared and it is not above the least one so far.
    fn measure(&mut self, pair: [&Primitive; 2]) {
        let Some((kind, is_swapped)) = pair[0].kind_with(pair[1]) else {
            return;
        };
        let order = if is_swapped { [1, 0] } else { [0, 1] };
        let places = order.map(|i: usize| self.places(i, pair[i]));
        let Some((bounds, points)) = distance(kind, &places, self.bounds.upper) else {
            return;
        };
        self.take(bounds, order.map(|i: usize| points[i]));
    }

    /// The rounded places of the vertices of a primitive.
    fn places(&self, body: usize, primitive: &Primitive) -> ArrayVec<Point, 3> {
        let points = primitive.points(&self.encounter.bodies[body].frame).into_iter();
        points.map(|point| self.scene.placed[body].at(point, 0)).collect()
    }
}

/// The distance of two primitives at rest, and their closest points, if it is at most `most`.
fn distance(
    kind: AnyKind,
    places: &[ArrayVec<Point, 3>; 2],
    most: f64,
) -> Option<(DistanceBounds, [Point; 2])> {
    with_kind!(kind, K => distance_of::<K>(places, most))
}

fn distance_of<K: Kind>(places: &[ArrayVec<Point, 3>; 2], most: f64) -> Option<(DistanceBounds, [Point; 2])> {
    let mut points = K::Points::default();
    let all = places.iter().flatten();
    for (target, &place) in points.as_mut().iter_mut().zip(all) {
        *target = place;
    }
    let query = Query::<K>::new(points, points).ok()?;
    let collision = query.collision(Separation::new(most).ok()?)?;
    let bounds = query.distance_at(0.0).ok()?;
    let weights = collision.impact().weights::<K>();
    let mut weights = weights.into_iter();
    let points = [0, 1].map(|i: usize| {
        let weighted = places[i].iter().zip(weights.by_ref());
        weighted.fold([0.0; 3], |sum, (place, weight)| {
            [0, 1, 2].map(|axis: usize| sum[axis] + weight.abs() * place[axis])
        })
    });
    Some((bounds, points))
}
