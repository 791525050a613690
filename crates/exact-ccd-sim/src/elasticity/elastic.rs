//! Any elastic element.

use arrayvec::ArrayVec;
use exact_ccd_mesh::Point;

use super::{Hinge, Membrane, Tetrahedron};
use crate::element::{Element, Vector12};
use crate::gather::gather;

/// A piece of a solid, of a shell, or what bends between two of these, among the vertices of a system.
#[derive(Clone, Debug)]
pub(crate) enum Elastic {
    /// A piece of a solid.
    Tetrahedron(Tetrahedron),
    /// A piece of a shell, in its plane.
    Membrane(Membrane),
    /// What bends between two pieces of a shell.
    Hinge(Hinge),
}

impl Elastic {
    /// The vertices.
    #[must_use]
    pub(crate) fn vertices(&self) -> ArrayVec<u32, 4> {
        match self {
            Self::Tetrahedron(tetrahedron) => tetrahedron.vertices().into(),
            Self::Membrane(membrane) => membrane.vertices().into_iter().collect(),
            Self::Hinge(hinge) => hinge.vertices().into(),
        }
    }

    /// The energy with all vertices of the system at these points, in J.
    #[must_use]
    pub(crate) fn value(&self, points: &[Point]) -> f64 {
        match self {
            Self::Tetrahedron(tetrahedron) => tetrahedron.value(&gather(points, &tetrahedron.vertices())),
            Self::Membrane(membrane) => membrane.value(&gather(points, &membrane.vertices())),
            Self::Hinge(hinge) => hinge.value(&gather(points, &hinge.vertices())),
        }
    }

    /// The gradient of the energy.
    #[must_use]
    pub(crate) fn gradient(&self, points: &[Point]) -> Vector12 {
        match self {
            Self::Tetrahedron(tetrahedron) => tetrahedron.gradient(&gather(points, &tetrahedron.vertices())),
            Self::Membrane(membrane) => membrane.gradient(&gather(points, &membrane.vertices())),
            Self::Hinge(hinge) => hinge.gradient(&gather(points, &hinge.vertices())),
        }
    }

    /// The derivatives of the energy; the Hessian is projected if asked for.
    #[must_use]
    pub(crate) fn derivatives(&self, points: &[Point], projected: bool) -> Element {
        match self {
            Self::Tetrahedron(tetrahedron) => {
                tetrahedron.derivatives(&gather(points, &tetrahedron.vertices()), projected)
            }
            Self::Membrane(membrane) => {
                membrane.derivatives(&gather(points, &membrane.vertices()), projected)
            }
            Self::Hinge(hinge) => hinge.derivatives(&gather(points, &hinge.vertices()), projected),
        }
    }
}
