//! Bodies and their materials.

use exact_ccd_mesh::Point;
use serde::{Deserialize, Serialize};

use crate::elasticity::{ElasticModuli, SolidMaterial};

/// A mesh with its material. The points are also the rest shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// The positions of its vertices at the start, in m.
    pub points: Vec<Point>,
    /// The kind of body, with its elements and its material.
    pub kind: BodyKind,
    /// The initial velocity of all vertices, in m/s.
    pub velocity: Point,
}

/// The kind of a [`Body`].
#[derive(Clone, Debug, PartialEq)]
pub enum BodyKind {
    /// An elastic solid of linear tetrahedra. See [`elasticity`](crate::elasticity) about locking.
    Solid {
        /// The corners of its tetrahedra, in either orientation.
        tetrahedra: Vec<[u32; 4]>,
        /// Its material.
        material: SolidProperties,
    },
    /// A thin elastic shell.
    Shell {
        /// Its triangles.
        faces: Vec<[u32; 3]>,
        /// Its material.
        material: ShellProperties,
    },
    /// A surface without mass, which rests unless a script moves it.
    Obstacle {
        /// Its triangles.
        faces: Vec<[u32; 3]>,
    },
}

/// The material of a solid.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct SolidProperties {
    /// The mass density, in kg/m³.
    pub density: f64,
    /// Young's modulus, in Pa.
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// The hyperelastic energy.
    #[serde(default)]
    pub energy: SolidMaterial,
}

/// The material of a shell.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct ShellProperties {
    /// The mass density, in kg/m³.
    pub density: f64,
    /// Young's modulus, in Pa.
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// The thickness, in m. It enters mass and stiffness, but not contact.
    pub thickness: f64,
}

impl SolidProperties {
    /// The elastic moduli.
    #[must_use]
    pub fn moduli(&self) -> ElasticModuli {
        let Self { young, poisson, .. } = *self;
        ElasticModuli { young, poisson }
    }
}

impl ShellProperties {
    /// The elastic moduli.
    #[must_use]
    pub fn moduli(&self) -> ElasticModuli {
        let Self { young, poisson, .. } = *self;
        ElasticModuli { young, poisson }
    }
}
