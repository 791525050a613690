//! What a scene is made of.

use exact_ccd_mesh::Point;
use serde::{Deserialize, Serialize};

use crate::elasticity::{ElasticModuli, SolidMaterial};

/// A mesh with what it is made of. It is at rest where its points are.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// The positions of its vertices at the start, in m.
    pub points: Vec<Point>,
    /// What holds them together.
    pub kind: BodyKind,
    /// The velocity of all of its vertices at the start, in m/s.
    pub velocity: Point,
}

/// What holds the vertices of a [`Body`] together.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyKind {
    /// An elastic solid.
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
    /// A surface that only moves if a script says so.
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
    /// The energy.
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
    /// The thickness, in m. It matters for mass and stiffness, not for contact.
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
