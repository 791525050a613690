//! The incremental potential, whose minimum is the result of a time step.

use exact_ccd_mesh::Point;
use nalgebra::Vector3;
use rayon::prelude::*;

use crate::contact::Collisions;
use crate::friction::{FrictionContact, Smoothing};
use crate::gather::gather_some;
use crate::integrator::Scheme;
use crate::scripted::Axes;
use crate::system::System;

/// ½ |x − x̂|²_M + h² Ψ(x) + κ Σ b + friction + springs, in kg m².
pub(crate) struct Potential<'a> {
    pub(crate) system: &'a System,
    pub(crate) scheme: &'a Scheme,
    pub(crate) stiffness: f64,
    pub(crate) friction: &'a [FrictionContact],
    pub(crate) smoothing: Smoothing,
    /// The springs that draw scripted vertices to their Dirichlet targets.
    pub(crate) springs: &'a [Spring],
    /// The coordinates of each vertex that are not free: see [`System::held`].
    pub(crate) held: &'a [Axes],
}

/// The spring ½ Σ k (x − target)² of a scripted vertex, a sum over the axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spring {
    pub(crate) vertex: u32,
    pub(crate) target: Point,
    /// k for each axis, in kg: 0 for coordinates that are free.
    pub(crate) stiffness: Vector3<f64>,
}

impl Spring {
    fn value(&self, points: &[Point]) -> f64 {
        0.5 * self.offset(points).dot(&self.gradient(points))
    }

    /// The gradient with respect to the vertex.
    pub(super) fn gradient(&self, points: &[Point]) -> Vector3<f64> {
        self.offset(points).component_mul(&self.stiffness)
    }

    fn offset(&self, points: &[Point]) -> Vector3<f64> {
        at(points, self.vertex as usize) - Vector3::from(self.target)
    }
}

/// The number of elements whose derivatives are in memory at a time.
const CHUNK: usize = 1024;

impl Potential<'_> {
    /// The value. Infinite if a neo-Hookean element is inverted.
    pub(crate) fn value(&self, points: &[Point], collisions: &Collisions) -> f64 {
        let inertia: f64 = self
            .inertia()
            .map(|(v, m)| 0.5 * m * self.offset(points, v).norm_squared())
            .sum();
        let springs: f64 = self.springs.iter().map(|spring| spring.value(points)).sum();
        let elastic = self.elastic(points) * self.scheme.duration * self.scheme.duration;
        inertia + springs + elastic + self.stiffness * collisions.value(points) + self.friction(points)
    }

    /// Ψ, in J.
    pub(crate) fn elastic(&self, points: &[Point]) -> f64 {
        let elements = sum(&self.system.elements, |element| element.value(points));
        elements + sum(&self.system.bends, |bend| bend.value(points))
    }

    /// The potential of friction, in kg m².
    pub(crate) fn friction(&self, points: &[Point]) -> f64 {
        sum(self.friction, |contact| {
            contact.value(&self.displacements(points, contact), self.smoothing)
        })
    }

    /// The work of friction against the slips, in kg m².
    pub(crate) fn friction_work(&self, points: &[Point]) -> f64 {
        sum(self.friction, |contact| {
            contact.work(&self.displacements(points, contact), self.smoothing)
        })
    }

    /// The gradient of inertia and elasticity.
    pub(crate) fn smooth_gradient(&self, points: &[Point]) -> Vec<Vector3<f64>> {
        let mut gradient = self.inertia_gradient(points);
        let scale = self.scheme.duration * self.scheme.duration;
        each(
            &self.system.elements,
            |element| element.gradient(points),
            |element, forces| {
                for (place, vertex) in element.vertices().into_iter().enumerate() {
                    gradient[vertex as usize] += forces.fixed_rows::<3>(3 * place) * scale;
                }
            },
        );
        each(
            &self.system.bends,
            |bend| bend.gradient(points),
            |bend, forces| {
                for (place, &vertex) in bend.vertices().iter().enumerate() {
                    gradient[vertex as usize] += forces.fixed_rows::<3>(3 * place) * scale;
                }
            },
        );
        gradient
    }

    /// The gradient of the potential.
    pub(crate) fn gradient(&self, points: &[Point], collisions: &Collisions) -> Vec<Vector3<f64>> {
        let mut gradient = self.smooth_gradient(points);
        for (sum, barrier) in gradient.iter_mut().zip(collisions.gradient(points)) {
            *sum += barrier * self.stiffness;
        }
        for contact in self.friction {
            let element = contact.derivatives(&self.displacements(points, contact), self.smoothing);
            for (place, &vertex) in element.vertices.iter().enumerate() {
                gradient[vertex as usize] += element.force(place);
            }
        }
        for spring in self.springs {
            gradient[spring.vertex as usize] += spring.gradient(points);
        }
        gradient
    }

    /// The magnitude of the rounding error of a value.
    pub(crate) fn noise(&self, value: f64) -> f64 {
        let elastic = self.scheme.duration * self.scheme.duration * self.system.rigidity;
        8.0 * f64::EPSILON * (elastic + value.abs())
    }

    /// The vertices with a free coordinate, with their masses. The inertia of a vertex acts on its held
    /// coordinates too, where it is a constant.
    pub(super) fn inertia(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let masses = self.system.masses.iter().copied().enumerate();
        masses.filter(|&(vertex, _)| self.held[vertex] != [true; 3])
    }

    pub(super) fn inertia_gradient(&self, points: &[Point]) -> Vec<Vector3<f64>> {
        let mut gradient = vec![Vector3::zeros(); points.len()];
        for (vertex, mass) in self.inertia() {
            gradient[vertex] = self.offset(points, vertex) * mass;
        }
        gradient
    }

    fn offset(&self, points: &[Point], vertex: usize) -> Vector3<f64> {
        at(points, vertex) - at(&self.scheme.predicted, vertex)
    }

    pub(super) fn displacements(&self, points: &[Point], contact: &FrictionContact) -> [Vector3<f64>; 4] {
        let now = gather_some(points, contact.vertices());
        let then = gather_some(&self.scheme.origin, contact.vertices());
        [0, 1, 2, 3].map(|place: usize| now[place] - then[place])
    }
}

fn at(points: &[Point], vertex: usize) -> Vector3<f64> {
    Vector3::from(points[vertex])
}

/// The sum of the values of elements. They are computed in parallel and added in order.
fn sum<T: Sync>(elements: &[T], value: impl Fn(&T) -> f64 + Sync) -> f64 {
    let values: Vec<f64> = elements.par_iter().map(&value).collect();
    values.iter().sum()
}

/// Computes the derivatives of elements in parallel, and calls `add` for them in order.
pub(super) fn each<T: Sync, D: Send>(
    elements: &[T],
    derive: impl Fn(&T) -> D + Sync,
    mut add: impl FnMut(&T, &D),
) {
    for chunk in elements.chunks(CHUNK) {
        let derived: Vec<D> = chunk.par_iter().map(&derive).collect();
        chunk
            .iter()
            .zip(&derived)
            .for_each(|(element, derived)| add(element, derived));
    }
}
