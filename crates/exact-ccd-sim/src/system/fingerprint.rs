//! Fingerprints of systems.

use exact_ccd_mesh::TriangleMesh;
use serde::{Deserialize, Serialize};

use super::System;
use crate::body::{
    AffineProperties, BodyKind, ParticleProperties, Region, RodProperties, ShellProperties, SolidProperties,
};
use crate::digest::{Digest, Hash};
use crate::half_space::HalfSpace;

/// The definition of the hashes, which is another one whenever equal systems would get other hashes.
const VERSION: u32 = 4;

/// Hashes of the parts of a [`System`], of 64 bits: against accidental differences, not against forgery.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fingerprint {
    /// The definition of the hashes; 0 in checkpoints without a number.
    #[serde(default)]
    version: u32,
    /// The hash of the initial positions.
    positions: String,
    /// The hash of the initial velocities.
    velocities: String,
    /// The hash of the corners of faces, edges and tetrahedra.
    elements: String,
    /// The hash of the names of all bodies, which decide their friction, and of their numbers of vertices.
    #[serde(default)]
    bodies: String,
    /// The hash of the materials and offsets of all bodies.
    materials: String,
    /// The hash of the scripts.
    scripts: String,
    /// The hash of the half spaces.
    half_spaces: String,
    /// The hash of the loads.
    loads: String,
    /// The hash of the springs.
    #[serde(default)]
    springs: String,
}

impl Fingerprint {
    /// The fingerprint of a system. The run time is proportional to the size of the system.
    #[must_use]
    pub fn of(system: &System) -> Self {
        Self {
            version: VERSION,
            positions: Hash::of(&system.start),
            velocities: Hash::of(&system.velocities),
            elements: Hash::of(&(system.surface(), system.tetrahedra())),
            bodies: Hash::of(&system.bodies.named_ranges()),
            materials: system.bodies.materials.clone(),
            scripts: Hash::of(&system.scripts),
            half_spaces: Hash::of(system.half_spaces()),
            loads: Hash::of(&system.loads),
            springs: Hash::of(&system.elastic.springs),
        }
    }

    /// Returns true if the hashes have the same definition, so that they can be compared.
    pub(crate) fn is_current(&self) -> bool {
        self.version == VERSION
    }

    /// The first part in which two systems differ.
    pub(crate) fn difference(&self, other: &Self) -> Option<&'static str> {
        let parts = [
            ("positions", &self.positions, &other.positions),
            ("elements", &self.elements, &other.elements),
            ("velocities", &self.velocities, &other.velocities),
            ("bodies", &self.bodies, &other.bodies),
            ("materials", &self.materials, &other.materials),
            ("scripts", &self.scripts, &other.scripts),
            ("half spaces", &self.half_spaces, &other.half_spaces),
            ("loads", &self.loads, &other.loads),
            ("springs", &self.springs, &other.springs),
        ];
        let different = parts.into_iter().find(|(_, a, b)| a != b);
        different.map(|(name, ..)| name)
    }
}

/// The kind of a body with its materials. The system's digest has its elements.
impl Digest for BodyKind {
    fn digest(&self, hash: &mut Hash) {
        self.name().digest(hash);
        match self {
            Self::Solid {
                material, regions, ..
            } => (material, regions).digest(hash),
            Self::Shell { material, .. } => {
                let ShellProperties {
                    density,
                    young,
                    poisson,
                    thickness,
                    strain_limit,
                } = *material;
                ([density, young, poisson, thickness], strain_limit).digest(hash);
            }
            Self::Rod { material, .. } => {
                let RodProperties {
                    density,
                    young,
                    radius,
                    shear,
                } = *material;
                ([density, young, radius], shear).digest(hash);
            }
            Self::Particles { material } => {
                let ParticleProperties { density, radius } = *material;
                [density, radius].digest(hash);
            }
            Self::Affine { material, .. } => {
                let AffineProperties { density, stiffness } = *material;
                [density, stiffness].digest(hash);
            }
            Self::Obstacle { .. } => {}
        }
    }
}

impl Digest for SolidProperties {
    fn digest(&self, hash: &mut Hash) {
        let Self {
            density,
            young,
            poisson,
            energy,
        } = *self;
        ([density, young, poisson], energy as u32).digest(hash);
    }
}

impl Digest for Region {
    fn digest(&self, hash: &mut Hash) {
        let Self { tetrahedra, material } = self;
        (tetrahedra, material).digest(hash);
    }
}

impl Digest for HalfSpace {
    fn digest(&self, hash: &mut Hash) {
        let Self { name, point, normal } = self;
        (name.as_str(), [point, normal]).digest(hash);
    }
}

impl Digest for TriangleMesh {
    fn digest(&self, hash: &mut Hash) {
        let vertex_count = self.vertex_count() as u64;
        (vertex_count, (self.faces(), self.edges())).digest(hash);
    }
}
