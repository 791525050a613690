//! Edges of a body at rest that meet faces of another one.

use exact_ccd::motion::{BodyPair, Chain, RigidMotion};
use exact_ccd::{CONTACT, Point, VertexFace};

use super::Bodies;
use super::apart::are_apart;
use super::encounter::{Below, Encounter};
use super::part::Part;
use super::shape::{Primitive, Shape};

/// An edge and a face of different bodies that have a common point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    /// The body of the edge, and the body of the face.
    pub(super) bodies: [usize; 2],
    pub(super) edge: u32,
    pub(super) face: u32,
}

impl Encounter<'_> {
    /// An edge and a face that meet, if there are any: the first in the order of both trees. The bodies rest.
    pub(super) fn crossing(&self, bodies: &Bodies) -> Option<Crossing> {
        let scene = self.scene(Part::WHOLE);
        let mut stack: Vec<_> = self.roots().into_iter().collect();
        while let Some(pair) = stack.pop() {
            let spheres = [0, 1].map(|i: usize| self.bodies[i].tree.node(pair[i]).sphere);
            if !scene.come_near(spheres) {
                continue;
            }
            match self.below(&scene, pair) {
                // Not reached: bodies at rest do not deviate from straight motion.
                Below::Later => stack.push(pair),
                Below::Split(halves) => stack.extend(halves),
                Below::Leaves(leaves) => {
                    let [first, second] = [0, 1].map(|i: usize| self.bodies[i].tree.primitives(leaves[i]));
                    let pairs = first.iter().flat_map(|a| second.iter().map(move |b| [a, b]));
                    let near = pairs.filter(|[a, b]| {
                        let is_kind = matches!(
                            (a.shape, b.shape),
                            (Shape::Edge, Shape::Face) | (Shape::Face, Shape::Edge)
                        );
                        is_kind && scene.come_near([a.sphere, b.sphere])
                    });
                    let mut crossings = near.filter_map(|pair| {
                        let [one, other] = self.places(&scene, pair);
                        let may_meet = !are_apart(&one, &other, scene.margin);
                        may_meet.then(|| self.crossing_of(bodies, pair)).flatten()
                    });
                    if let Some(crossing) = crossings.next() {
                        return Some(crossing);
                    }
                }
            }
        }
        None
    }

    /// An edge and a face, in any order, if they meet: a vertex that moves along the edge, in the coordinates
    /// of its body, comes into contact with the face.
    fn crossing_of(&self, bodies: &Bodies, pair: [&Primitive; 2]) -> Option<Crossing> {
        let of_edge = usize::from(pair[0].shape == Shape::Face);
        let of_face = 1 - of_edge;
        let [ends, corners] =
            [of_edge, of_face].map(|i: usize| pair[i].points(&bodies.bodies[self.ids[i]].frame));
        let along = RigidMotion::new([[1.0, 0.0, 0.0, 0.0]; 2], &ends).ok()?;
        let motions = self.given[of_edge].motions().iter().cloned();
        let chain = Chain::new(motions.chain([along])).ok()?;
        let motions = BodyPair::new(chain, self.given[of_face].clone());
        let points: [Point; 4] = [[0.0; 3], corners[0], corners[1], corners[2]];
        let query = motions.query::<VertexFace>(points).ok()?;
        query.collides(CONTACT).then(|| Crossing {
            bodies: [of_edge, of_face].map(|i| self.ids[i]),
            edge: pair[of_edge].id,
            face: pair[of_face].id,
        })
    }
}
