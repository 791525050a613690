//! Affine bodies: four point masses, which carry a surface.
//!
//! Four equal masses can have the mass, the center and the second moments of any body. Then the kinetic
//! energy of every affine motion, and the work of every homogeneous force, are the same as of the body: the
//! mass matrix of its twelve unknowns is exact, and it is diagonal. With the Cholesky factor L of the mean of
//! (x − c) (x − c)ᵀ, the masses are at c + L s for the alternate corners s of a cube: s has the mean 0, and
//! s sᵀ the mean 1.

use std::sync::Arc;

use exact_ccd_mesh::Point;
use nalgebra::Vector3;

use super::body_error::BodyError;
use super::parts::Parts;
use crate::body::AffineProperties;
use crate::carriers::Carrier;
use crate::energies::elasticity::{SaintVenantKirchhoff, Tetrahedron};
use crate::moments::{Moments, is_closed};
use crate::range::check_positive;

/// Alternate corners of a cube, in the order of a tetrahedron of positive volume.
const CORNERS: [[f64; 3]; 4] = [
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, -1.0],
    [1.0, -1.0, -1.0],
    [-1.0, -1.0, 1.0],
];

impl Parts {
    /// Adds the nodes of an affine body after its vertices, which begin with `first`.
    pub(super) fn add_affine(
        &mut self,
        first: usize,
        mut faces: Vec<[u32; 3]>,
        material: &AffineProperties,
    ) -> Result<(), BodyError> {
        check_positive("density", material.density).and(check_positive("stiffness", material.stiffness))?;
        if !is_closed(&faces) {
            return Err(BodyError::Open);
        }
        let mut moments = Moments::new(&self.start, &faces);
        if moments.volume < 0.0 {
            faces.iter_mut().for_each(|face| face.swap(1, 2));
            moments.volume = -moments.volume;
        }
        let Moments {
            volume,
            center,
            covariance,
        } = moments;
        let root = covariance.cholesky().ok_or(BodyError::NoVolume)?.l();
        let inverse = root.try_inverse().ok_or(BodyError::NoVolume)?;
        let count = self.start.len();
        let carriers = self.start[first..].iter().map(|&point| {
            let at = inverse * (Vector3::from(point) - center);
            Carrier {
                first: count as u32,
                weights: CORNERS.map(|corner| 0.25 * (1.0 + at.dot(&Vector3::from(corner)))),
            }
        });
        self.carriers.add(first as u32, carriers);
        let nodes: [Point; 4] = CORNERS.map(|corner| (center + root * Vector3::from(corner)).into());
        self.start.extend(nodes);
        let vertices = [0, 1, 2, 3].map(|node| (count + node) as u32);
        let element = Tetrahedron::new(vertices, &self.start)
            .ok_or(BodyError::NoVolume)?
            .with_volume(volume);
        let stiffness = SaintVenantKirchhoff::orthogonality(material.stiffness);
        self.add_element(
            0,
            Arc::new(element.of(stiffness)),
            volume,
            [material.density, material.stiffness],
        )?;
        self.outline.faces.extend(faces);
        Ok(())
    }
}
