//! Springs between two bodies, or a body and a place.

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, Vector3};

use super::term::{Block, Energy, Projection, write_products};
use crate::digest::{Digest, Hash};
use crate::range::{OutOfRange, check_finite, check_not_negative, check_positive};

/// A spring. One without length holds its two ends together: a ball joint of affine bodies, a stitch of
/// others.
///
/// The energy is ½ k (d − l)² for the distance d of the ends. A joint is this energy, not an elimination of
/// unknowns: so chains and loops of joints are alike, and a joint that a force F pulls is open by F / k.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring {
    /// Its ends.
    pub ends: [SpringEnd; 2],
    /// Its stiffness k, in N/m.
    pub stiffness: f64,
    /// Its length l without forces, in m. `None` for the distance of the ends at the start.
    pub length: Option<f64>,
}

/// An end of a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpringEnd {
    /// The body, by its place in the list of bodies. `None` for a place that never moves.
    pub body: Option<usize>,
    /// The position at the start, in m: a vertex, or any point of an affine body, which carries it.
    pub at: Point,
}

impl Spring {
    /// Checks that all numbers are in range.
    ///
    /// # Errors
    /// [`OutOfRange`] names the first number that is out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        for end in &self.ends {
            check_finite("at", &end.at)?;
        }
        check_positive("stiffness", self.stiffness)?;
        check_not_negative("length", self.length.unwrap_or(0.0))
    }
}

/// The energy ½ k (|d| − l)² with d = Σ wₖ xₖ − c.
#[derive(Debug)]
pub(crate) struct SpringEnergy {
    pub(crate) vertices: Vec<u32>,
    /// The weight of each vertex.
    pub(crate) weights: Vec<f64>,
    /// c: the part of d that does not move.
    pub(crate) fixed: Vector3<f64>,
    pub(crate) stiffness: f64,
    pub(crate) length: f64,
}

impl SpringEnergy {
    /// d.
    pub(crate) fn vector(&self, points: &[Point]) -> Vector3<f64> {
        let pairs = self.vertices.iter().zip(&self.weights);
        let sum: Vector3<f64> = pairs
            .map(|(&vertex, &weight)| Vector3::from(points[vertex as usize]) * weight)
            .sum();
        sum - self.fixed
    }
}

impl Energy for SpringEnergy {
    fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    fn value(&self, points: &[Point]) -> f64 {
        0.5 * self.stiffness * (self.vector(points).norm() - self.length).powi(2)
    }

    /// Without a direction, where d = 0, the force of a spring with a length is set to zero.
    fn write_gradient(&self, points: &[Point], gradient: &mut [f64]) {
        let d = self.vector(points);
        let direction = d.try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        let force = (d - direction * self.length) * self.stiffness;
        for (rows, &weight) in gradient.chunks_exact_mut(3).zip(&self.weights) {
            rows.copy_from_slice((force * weight).as_slice());
        }
    }

    /// By d: k along it, and k (1 − l / |d|) across.
    fn write_hessian(&self, points: &[Point], projection: Projection, hessian: &mut [Block]) {
        let d = self.vector(points);
        let block = match d.try_normalize(0.0) {
            Some(n) if self.length > 0.0 => {
                let across = projection.of_value(1.0 - self.length / d.norm());
                Matrix3::from_diagonal_element(across) + n * n.transpose() * (1.0 - across)
            }
            _ => Matrix3::identity(),
        } * self.stiffness;
        write_products(&self.weights, &block, hessian);
    }
}

impl Digest for Spring {
    fn digest(&self, hash: &mut Hash) {
        let Self {
            ends,
            stiffness,
            length,
        } = self;
        for SpringEnd { body, at } in ends {
            (body.map(|body| body as u64), at).digest(hash);
        }
        (*stiffness, *length).digest(hash);
    }
}
