//! The elastic elements of a system.

use arrayvec::ArrayVec;
use exact_ccd_mesh::Point;

use super::{Bend, Hinge, Membrane, Stretch, Tetrahedron};
use crate::element::{Element, Vector12};
use crate::gather::gather;

/// An elastic element on vertices of a system.
#[derive(Clone, Debug)]
pub(crate) enum Elastic {
    /// A tetrahedron of a solid.
    Tetrahedron(Tetrahedron),
    /// A triangle of a shell, which resists deformation in its plane.
    Membrane(Membrane),
    /// An edge between two triangles of a shell, which resists bending.
    Hinge(Hinge),
    /// An edge of a rod.
    Stretch(Stretch),
    /// A vertex of a rod between two edges.
    Bend(Bend),
}

impl Elastic {
    /// The vertices.
    #[must_use]
    pub(crate) fn vertices(&self) -> ArrayVec<u32, 4> {
        match self {
            Self::Tetrahedron(tetrahedron) => tetrahedron.vertices().into(),
            Self::Membrane(membrane) => membrane.vertices().into_iter().collect(),
            Self::Hinge(hinge) => hinge.vertices().into(),
            Self::Stretch(stretch) => stretch.vertices().into_iter().collect(),
            Self::Bend(bend) => bend.vertices().into_iter().collect(),
        }
    }

    /// The energy in J, for these positions of all vertices of the system.
    #[must_use]
    pub(crate) fn value(&self, points: &[Point]) -> f64 {
        match self {
            Self::Tetrahedron(tetrahedron) => tetrahedron.value(&gather(points, &tetrahedron.vertices())),
            Self::Membrane(membrane) => membrane.value(&gather(points, &membrane.vertices())),
            Self::Hinge(hinge) => hinge.value(&gather(points, &hinge.vertices())),
            Self::Stretch(stretch) => stretch.value(&gather(points, &stretch.vertices())),
            Self::Bend(bend) => bend.value(&gather(points, &bend.vertices())),
        }
    }

    /// The gradient of the energy.
    #[must_use]
    pub(crate) fn gradient(&self, points: &[Point]) -> Vector12 {
        match self {
            Self::Tetrahedron(tetrahedron) => tetrahedron.gradient(&gather(points, &tetrahedron.vertices())),
            Self::Membrane(membrane) => membrane.gradient(&gather(points, &membrane.vertices())),
            Self::Hinge(hinge) => hinge.gradient(&gather(points, &hinge.vertices())),
            Self::Stretch(stretch) => stretch.gradient(&gather(points, &stretch.vertices())),
            Self::Bend(bend) => bend.gradient(&gather(points, &bend.vertices())),
        }
    }

    /// The gradient and the Hessian of the energy. If `projected`, the Hessian is positive semi-definite.
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
            Self::Stretch(stretch) => stretch.derivatives(&gather(points, &stretch.vertices()), projected),
            Self::Bend(bend) => bend.derivatives(&gather(points, &bend.vertices()), projected),
        }
    }
}
