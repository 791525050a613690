//! A body at rest in its own coordinates, prepared for steps.

use super::error::BodiesError;
use super::sphere::{Sphere, length};
use super::tree::Tree;
use super::world::largest;
use crate::broad_phase::check_primitive_count;
use crate::mesh::{Frame, check_positions};

/// A body, and the tree of its primitives.
#[derive(Clone, Debug)]
pub(super) struct Body {
    pub(super) frame: Frame,
    pub(super) tree: Tree,
    /// A bound of the distance of all vertices from the origin.
    pub(super) reach: f64,
    /// The largest magnitude of a coordinate.
    pub(super) largest: f64,
}

impl Body {
    pub(super) fn new(index: usize, frame: Frame) -> Result<Self, BodiesError> {
        let refused = |error| BodiesError::Positions { body: index, error };
        check_positions(frame.mesh.vertex_count(), &frame.positions).map_err(refused)?;
        let mesh = &frame.mesh;
        let count = mesh.vertex_count() + mesh.edges().len() + mesh.faces().len();
        let too_many = |error| BodiesError::TooManyPrimitives { body: index, error };
        check_primitive_count(count).map_err(too_many)?;
        Ok(Self::of(frame))
    }

    /// The body with all coordinates times a factor.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        let positions = self.frame.positions.iter();
        Self::of(Frame {
            mesh: self.frame.mesh.clone(),
            positions: positions.map(|point| point.map(|x| factor * x)).collect(),
        })
    }

    fn of(frame: Frame) -> Self {
        let tree = Tree::new(&frame);
        let none = Sphere {
            center: [0.0; 3],
            radius: 0.0,
        };
        let around = tree.root().map_or(none, |root| root.sphere);
        Self {
            reach: (length(around.center) + around.radius) * (1.0 + 1e-12),
            largest: largest(&frame.positions),
            tree,
            frame,
        }
    }
}
