//! Bodies and their materials.

use core::f64::consts::PI;

use exact_ccd_mesh::Point;
use serde::{Deserialize, Serialize};

use crate::energies::elasticity::{ElasticModuli, SolidMaterial};

/// A mesh with its material. The points are also the rest shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Its name, which several bodies may share. Empty for no name.
    pub name: String,
    /// The positions of its vertices at the start, in m.
    pub points: Vec<Point>,
    /// The kind of body, with its elements and its material.
    pub kind: BodyKind,
    /// The initial velocity of all vertices, in m/s.
    pub velocity: Point,
    /// The initial angular velocity about its center of mass, in rad/s.
    pub angular_velocity: Point,
    /// The offset of its contact surface from its mesh, in m: half of its thickness for contact. Two bodies
    /// keep their meshes farther apart than the sum of their offsets, and so do two parts of one body.
    pub offset: f64,
}

/// The kind of a [`Body`].
#[derive(Clone, Debug, PartialEq)]
pub enum BodyKind {
    /// An elastic solid of linear tetrahedra, which lock in bending: a beam that is one cell thick deflects
    /// by about a quarter of the deflection of beam theory. Meshes with more cells across the thickness are
    /// less stiff. Nearly incompressible materials (Poisson's ratio near ½) lock in volume as well.
    Solid {
        /// The corners of its tetrahedra, in either orientation.
        tetrahedra: Vec<[u32; 4]>,
        /// Its material, except in the regions.
        material: SolidProperties,
        /// Parts with materials of their own. Of several regions of a tetrahedron, the last one counts.
        regions: Vec<Region>,
    },
    /// A thin elastic shell.
    Shell {
        /// Its triangles.
        faces: Vec<[u32; 3]>,
        /// Its material.
        material: ShellProperties,
    },
    /// A thin elastic rod, or several of them. They resist twist between edges that are held, if the material
    /// has a shear modulus, but for closed loops without a branch.
    Rod {
        /// Its edges. The rods bend at the vertices of two edges; more than two edges are hinged.
        edges: Vec<[u32; 2]>,
        /// Its material.
        material: RodProperties,
    },
    /// Particles: all points of the body. They do not rotate.
    Particles {
        /// Their material.
        material: ParticleProperties,
    },
    /// A nearly rigid body with the twelve unknowns of an affine map. All its vertices move by this map, and
    /// scripts move all of them or none.
    Affine {
        /// The triangles of a closed surface, in either orientation.
        faces: Vec<[u32; 3]>,
        /// Its material.
        material: AffineProperties,
    },
    /// A surface without mass, which rests unless a script moves it.
    Obstacle {
        /// Its triangles.
        faces: Vec<[u32; 3]>,
    },
}

/// A part of a solid with a material of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// Its tetrahedra, by their places in the solid.
    pub tetrahedra: Vec<u32>,
    /// Its material.
    pub material: SolidProperties,
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
    /// The limit ε of the strain: no principal stretch reaches 1 + ε. `None` for no limit.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strain_limit: Option<f64>,
}

/// The material of a rod with a circular cross section.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct RodProperties {
    /// The mass density, in kg/m³.
    pub density: f64,
    /// Young's modulus, in Pa.
    pub young: f64,
    /// The radius of the cross section, in m. It enters mass and stiffness, but not contact.
    pub radius: f64,
    /// The shear modulus G in Pa, by which a rod between two held edges resists twist. `None`: it does not. A
    /// closed loop without a branch does not resist twist.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear: Option<f64>,
}

/// The material of particles, which are balls.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct ParticleProperties {
    /// The mass density, in kg/m³.
    pub density: f64,
    /// The radius, in m. It enters the mass, but not contact.
    pub radius: f64,
}

/// The material of an affine body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct AffineProperties {
    /// The mass density, in kg/m³.
    pub density: f64,
    /// The stiffness κ against strain, in Pa: the energy is κ V |AᵀA − 1|², with the volume V and the
    /// matrix A of the affine map.
    pub stiffness: f64,
}

/// The number of nodes of an affine body.
const NODES: usize = 4;

impl BodyKind {
    /// The name: `solid`, `shell`, `rod`, `particles`, `affine` or `obstacle`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Solid { .. } => "solid",
            Self::Shell { .. } => "shell",
            Self::Rod { .. } => "rod",
            Self::Particles { .. } => "particles",
            Self::Affine { .. } => "affine",
            Self::Obstacle { .. } => "obstacle",
        }
    }
}

impl Body {
    /// The body at rest, without an offset.
    #[must_use]
    pub fn new(points: Vec<Point>, kind: BodyKind) -> Self {
        Self {
            name: String::new(),
            points,
            kind,
            velocity: [0.0; 3],
            angular_velocity: [0.0; 3],
            offset: 0.0,
        }
    }

    /// The number of its vertices in a [`System`](crate::System): its points, followed by four nodes for an
    /// affine body.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        let nodes = if let BodyKind::Affine { .. } = self.kind {
            NODES
        } else {
            0
        };
        self.points.len() + nodes
    }

    /// The same body with another name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        let name = name.into();
        Self { name, ..self }
    }

    /// The same body with another offset of its contact surface, in m.
    #[must_use]
    pub fn with_offset(self, offset: f64) -> Self {
        Self { offset, ..self }
    }
}

impl SolidProperties {
    /// The elastic moduli.
    pub(crate) fn moduli(&self) -> ElasticModuli {
        let Self { young, poisson, .. } = *self;
        ElasticModuli { young, poisson }
    }
}

impl ShellProperties {
    /// The elastic moduli.
    pub(crate) fn moduli(&self) -> ElasticModuli {
        let Self { young, poisson, .. } = *self;
        ElasticModuli { young, poisson }
    }
}

impl RodProperties {
    /// The area A = π r² of the cross section, in m².
    #[must_use]
    pub fn area(&self) -> f64 {
        PI * self.radius * self.radius
    }

    /// The axial stiffness E A, in N.
    #[must_use]
    pub(crate) fn axial_stiffness(&self) -> f64 {
        self.young * self.area()
    }

    /// The flexural rigidity E I, with the second moment of area I = π r⁴ / 4, in N m².
    #[must_use]
    pub fn flexural_rigidity(&self) -> f64 {
        0.25 * self.axial_stiffness() * self.radius * self.radius
    }

    /// The torsional rigidity G J, with the polar moment of area J = π r⁴ / 2, in N m². `None` without a
    /// shear modulus.
    #[must_use]
    pub fn torsional_rigidity(&self) -> Option<f64> {
        let moment = 0.5 * self.area() * self.radius * self.radius;
        self.shear.map(|shear| shear * moment)
    }
}

impl ParticleProperties {
    /// The mass of a particle, in kg.
    #[must_use]
    pub fn mass(&self) -> f64 {
        4.0 / 3.0 * PI * self.density * self.radius.powi(3)
    }
}
