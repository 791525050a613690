//! The mass distribution of a closed surface.

use std::collections::BTreeMap;

use exact_ccd_mesh::Point;
use nalgebra::{Matrix3, Vector3};

use crate::energies::term::gather;

/// The volume integrals of 1, x and x xᵀ over the interior of a closed surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moments {
    /// The volume V in m³: positive if the normals point outward.
    pub(crate) volume: f64,
    /// The mean c of x over the volume, in m.
    pub(crate) center: Vector3<f64>,
    /// The mean of (x − c) (x − c)ᵀ over the volume, in m².
    pub(crate) covariance: Matrix3<f64>,
}

impl Moments {
    /// The moments: the sums over the tetrahedra of the faces and one common point, with the sign of their
    /// volumes. The integrals of polynomials over a tetrahedron of corners o, a, b, c are exact. With o = 0
    /// and the sum s of the corners, the integral of x is V s / 4, and of x xᵀ, V (a aᵀ + b bᵀ + c cᵀ + s
    /// sᵀ) / 20. The common point is a corner for the center, and the center for the covariance, because
    /// rounding errors grow with its distance.
    pub(crate) fn new(points: &[Point], faces: &[[u32; 3]]) -> Self {
        let near = faces
            .first()
            .map_or_else(Vector3::zeros, |&[a, ..]| points[a as usize].into());
        let tetrahedra = |origin: Vector3<f64>| {
            faces.iter().map(move |face| {
                let corners = gather(points, face).map(|corner| corner - origin);
                let [a, b, c] = corners;
                (a.cross(&b).dot(&c) / 6.0, corners)
            })
        };
        let (mut volume, mut moment) = (0.0, Vector3::zeros());
        for (part, [a, b, c]) in tetrahedra(near) {
            volume += part;
            moment += (a + b + c) * (part / 4.0);
        }
        let center = near + moment / volume;
        let mut second = Matrix3::zeros();
        for (part, corners) in tetrahedra(center) {
            let sum: Vector3<f64> = corners.iter().sum();
            let square = |x: Vector3<f64>| x * x.transpose();
            second += (corners.map(square).iter().sum::<Matrix3<f64>>() + square(sum)) * (part / 20.0);
        }
        Self {
            volume,
            center,
            covariance: second / volume,
        }
    }
}

/// Returns true if faces enclose a volume: each edge is passed as often in one direction as in the other one.
pub(crate) fn is_closed(faces: &[[u32; 3]]) -> bool {
    let mut passes: BTreeMap<[u32; 2], i64> = BTreeMap::new();
    for &[a, b, c] in faces {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            *passes.entry([from.min(to), from.max(to)]).or_default() += if from < to { 1 } else { -1 };
        }
    }
    passes.values().all(|&passes| passes == 0)
}
