//! The quadratic that a Newton iteration minimises.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, Vector3};

use super::pattern::{Pattern, key};
use super::potential::{Potential, each};
use super::unknowns::Unknowns;
use crate::contact::Collisions;
use crate::element::Element;
use crate::gather::gather_some;

/// Gradient and Hessian of a potential with respect to the unknowns.
pub(crate) struct Quadratic {
    /// The gradient of all vertices.
    pub(crate) gradient: Vec<Vector3<f64>>,
    pub(crate) pattern: Pattern,
    pub(crate) values: Vec<f64>,
    /// The Hessian's columns of the vertices that are not unknown, times their given displacements: what these do to the
    /// gradient of the unknowns.
    pub(crate) given: Vec<Vector3<f64>>,
}

impl Potential<'_> {
    /// The pairs of unknowns that interact by elasticity.
    pub(crate) fn elastic_keys(&self, unknowns: &Unknowns) -> Vec<u64> {
        let mut keys = Vec::new();
        for element in &self.system.elements {
            add_keys(&mut keys, unknowns, &element.vertices());
        }
        keys.sort_unstable();
        keys.dedup();
        keys
    }

    /// Gradient and Hessian, where vertices that are not unknown are displaced by `given`.
    pub(crate) fn quadratic(
        &self,
        points: &[Point],
        collisions: &Collisions,
        unknowns: &Unknowns,
        elastic_keys: &[u64],
        given: &[Vector3<f64>],
    ) -> Quadratic {
        let mut keys = elastic_keys.to_vec();
        let contacts = collisions.as_slice();
        contacts
            .iter()
            .for_each(|c| add_keys(&mut keys, unknowns, c.vertices()));
        self.friction
            .iter()
            .for_each(|c| add_keys(&mut keys, unknowns, c.vertices()));
        let pattern = Pattern::new(unknowns.len(), keys);
        let mut sum = Sum {
            values: vec![0.0; pattern.scalar_count()],
            gradient: self.inertia_gradient(points),
            effect: vec![Vector3::zeros(); points.len()],
            pattern,
            unknowns,
            given,
        };

        for (vertex, mass) in self.inertia() {
            sum.add_diagonal(vertex as u32, mass);
        }
        for spring in self.springs {
            sum.gradient[spring.vertex as usize] += self.pull(points, spring);
            sum.add_diagonal(spring.vertex, spring.stiffness);
        }
        let scale = self.scheme.duration * self.scheme.duration;
        each(
            &self.system.elements,
            |element| element.derivatives(points, true).scaled(scale),
            |_, element| sum.add(element),
        );
        each(
            contacts,
            |collision| {
                let corners = gather_some(points, collision.vertices());
                collision
                    .derivatives(&corners, collisions.barrier(), true)
                    .scaled(self.stiffness)
            },
            |_, element| sum.add(element),
        );
        each(
            self.friction,
            |contact| contact.derivatives(&self.displacements(points, contact), self.smoothing),
            |_, element| sum.add(element),
        );
        Quadratic {
            gradient: sum.gradient,
            pattern: sum.pattern,
            values: sum.values,
            given: sum.effect,
        }
    }
}

fn add_keys(keys: &mut Vec<u64>, unknowns: &Unknowns, vertices: &[u32]) {
    for (place, &a) in vertices.iter().enumerate() {
        let Some(a) = unknowns.number(a) else { continue };
        let others = vertices[..place].iter().filter_map(|&b| unknowns.number(b));
        keys.extend(others.map(|b| key(a, b)));
    }
}

/// Gradient and Hessian while elements are added to them.
struct Sum<'a> {
    pattern: Pattern,
    values: Vec<f64>,
    gradient: Vec<Vector3<f64>>,
    effect: Vec<Vector3<f64>>,
    unknowns: &'a Unknowns,
    given: &'a [Vector3<f64>],
}

impl Sum<'_> {
    fn add_diagonal(&mut self, vertex: u32, value: f64) {
        if let Some(number) = self.unknowns.number(vertex) {
            let block = Matrix3::from_diagonal_element(value);
            self.pattern.add(&mut self.values, number, number, &block);
        }
    }

    fn add(&mut self, element: &Element) {
        for (row, &vertex) in element.vertices.iter().enumerate() {
            self.gradient[vertex as usize] += element.force(row);
            let Some(number) = self.unknowns.number(vertex) else {
                continue;
            };
            for (column, &other) in element.vertices.iter().enumerate() {
                match self.unknowns.number(other) {
                    None => {
                        let given = self.given[other as usize];
                        self.effect[vertex as usize] += element.block(row, column) * given;
                    }
                    // The other triangle is the same.
                    Some(other) if other > number => {}
                    Some(other) => {
                        let block = element.block(row, column);
                        self.pattern.add(&mut self.values, number, other, &block);
                    }
                }
            }
        }
    }
}
