//! The contacts of a state.

use std::borrow::Cow;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::Simulation;
use crate::energies::contact::{Collision, CollisionSet};
use crate::energies::term::{Energy, gather_some};

/// Two features (vertices, edges, faces) within the contact distance, or a vertex and a half space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Their bodies, by their places in the list of all bodies, followed by the half spaces.
    pub bodies: [usize; 2],
    /// The closest points of the features, in m.
    pub points: [Point; 2],
    /// The distance between the contact surfaces, in m.
    pub distance: f64,
    /// The normal force on the first feature, in N, with the stiffness of the last time step: zero before the
    /// first one. Some contacts of the convergent formulation correct others: their force points inward, and
    /// the sum is that on the body.
    pub force: Point,
}

impl Simulation {
    /// The contacts of the current state, in an order that does not depend on threads.
    #[must_use]
    pub fn contacts(&self) -> Vec<Contact> {
        let collisions = self.collisions();
        let contacts = collisions.as_slice().iter();
        contacts.map(|collision| self.contact(collision)).collect()
    }

    /// The collisions of the current state.
    pub(super) fn collisions(&self) -> Cow<'_, CollisionSet> {
        let positions = &self.state.positions;
        if let Some(known) = &self.known
            && known.positions == *positions
        {
            return Cow::Borrowed(&known.collisions);
        }
        let candidates = self.system.geometry.near_at(positions, &self.barrier);
        let surface = self.system.contact_surface(self.settings.formulation);
        Cow::Owned(CollisionSet::new(surface, &candidates, positions, self.barrier))
    }

    fn contact(&self, collision: &Collision) -> Contact {
        let corners = gather_some(&self.state.positions, collision.vertices());
        let shortest = collision.shortest_vector(&self.state.positions);
        // Weights are positive for the first feature, negative for the second.
        let weighted = corners
            .iter()
            .zip(shortest.weights)
            .filter(|(_, weight)| *weight > 0.0);
        let first: Vector3<f64> = weighted.map(|(corner, weight)| corner * weight).sum();
        let direction = shortest.vector.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        let stiffness = self.state.stiffness.unwrap_or(0.0);
        let force = direction * (stiffness * collision.normal_force(&self.state.positions));
        Contact {
            bodies: self.system.bodies_of(collision),
            points: [first, first - shortest.vector].map(Point::from),
            distance: collision.gap(&self.state.positions),
            force: force.into(),
        }
    }
}
