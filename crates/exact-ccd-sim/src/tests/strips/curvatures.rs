//! The bending energy of flat plates with small deflections of constant curvature.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::mesh::{Mesh, Strip};
use crate::energies::elasticity::bending;
use crate::energies::term::{Energy, Projection};

/// A plate in the plane y = 0 with a flexural rigidity of 1.
pub(super) struct Plate<'a> {
    mesh: &'a Mesh,
    size: [f64; 2],
    poisson: f64,
    elements: Vec<Arc<dyn Energy>>,
}

impl<'a> Plate<'a> {
    pub(super) fn new(strip: &Strip, mesh: &'a Mesh, poisson: f64) -> Self {
        Self {
            mesh,
            size: strip.size,
            poisson,
            elements: bending(&mesh.points, &mesh.faces, 1.0, poisson),
        }
    }

    fn area(&self) -> f64 {
        self.size[0] * self.size[1]
    }

    /// The energy of a cylinder that is curved along a direction at this angle to the x axis, divided by that
    /// of the theory, ½ κ² A.
    pub(super) fn rolled(&self, degrees: f64) -> f64 {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let shape = self.deflections(|x, z| 0.5 * (cos * x + sin * z).powi(2));
        let mut energy = 0.0;
        self.visit(|a, b, stiffness| energy += 0.5 * shape[a] * stiffness * shape[b]);
        energy / (0.5 * self.area())
    }

    /// The energy of a plate whose ends along x are twisted against each other, while all other vertices are
    /// free, divided by that of the theory, (1 − ν) κ² A.
    pub(super) fn twisted(&self) -> f64 {
        let twist = self.deflections(|x, z| x * z);
        let is_held = |vertex: usize| {
            let x = self.mesh.points[vertex][0];
            x < 1e-9 || x > self.size[0] - 1e-9
        };
        let count = twist.len();
        // Held vertices have the unit matrix, and their forces are loads of the others.
        let mut stiffness = DMatrix::zeros(count, count);
        let mut load = DVector::zeros(count);
        self.visit(|a, b, value| match (is_held(a), is_held(b)) {
            (false, false) => stiffness[(a, b)] += value,
            (false, true) => load[a] -= value * twist[b],
            _ => (),
        });
        for vertex in (0..count).filter(|&vertex| is_held(vertex)) {
            stiffness[(vertex, vertex)] = 1.0;
            load[vertex] = twist[vertex];
        }
        let shape = stiffness.cholesky().unwrap().solve(&load);
        let mut energy = 0.0;
        self.visit(|a, b, value| energy += 0.5 * shape[a] * value * shape[b]);
        energy / ((1.0 - self.poisson) * self.area())
    }

    fn deflections(&self, at: impl Fn(f64, f64) -> f64) -> DVector<f64> {
        let points = self.mesh.points.iter().map(|&[x, _, z]| at(x, z));
        DVector::from_iterator(self.mesh.points.len(), points)
    }

    /// Calls a function for the terms of the Hessian by the deflections.
    fn visit(&self, mut f: impl FnMut(usize, usize, f64)) {
        for element in &self.elements {
            let hessian = element.hessian(&self.mesh.points, Projection::None);
            for (row, &a) in element.vertices().iter().enumerate() {
                for (column, &b) in element.vertices().iter().enumerate() {
                    f(a as usize, b as usize, hessian[(3 * row + 1, 3 * column + 1)]);
                }
            }
        }
    }
}
